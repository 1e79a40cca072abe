#include "base/error.h"
#include "io/fields.h"
#include "io/find_file.h"
#include "sheet/sheet.h"
#include <fmt/format.h>

namespace nacre::sheet {
namespace {

using io::Fields;
using io::Json;

template <typename Number> void read_optional(Fields &fields, const char *name, std::optional<Number> &value) {
    if (!fields.find(name)) return;
    value.emplace();
    fields.read(name, *value);
}

// A path in the sheet; the folder it is relative to is the sheet's.
std::filesystem::path read_path(Fields &fields, const char *name, const std::filesystem::path &sheet) {
    std::string text;
    fields.read(name, text);
    return text.empty() ? std::filesystem::path() : sheet.parent_path() / text;
}

Panel read_panel(const Json &tree, const std::string &path, const io::Source &source) {
    Panel panel;
    Fields fields(tree, path, "panel", source);
    fields.read("label", panel.label);
    if (panel.label.empty()) fields.fail("label", "every panel needs one");
    if (const Json *set = fields.find("set")) {
        const Fields section(*set, fields.path("set"), "set", source); // checks that it is an object
        for (const auto &item : set->items()) panel.set.push_back({item.key(), item.value().dump()});
    }
    fields.finish();
    return panel;
}

// How messages call panel `index`: "figure5.json: panels.1.set".
std::string name_of_settings(const Sheet &sheet, std::size_t index) {
    return fmt::format("{}: panels.{}.set", sheet.file.string(), index);
}

} // namespace

Sheet read_sheet(const std::filesystem::path &file) {
    const io::Source source{file};
    const Json tree = io::parse_json(io::read_file(file), file.string());
    Sheet sheet;
    sheet.file = file;
    Fields root(tree, "", "sheet", source);
    root.read("title", sheet.title);
    sheet.scene = read_path(root, "scene", file);
    if (sheet.scene.empty()) root.fail("scene", "a sheet needs a scene, for example \"../bear/bear.json\"");
    sheet.fallback = read_path(root, "fallback", file);
    if (const Json *image = root.find("image")) {
        Fields fields(*image, "image", "image", source);
        read_optional(fields, "width", sheet.width);
        read_optional(fields, "height", sheet.height);
        fields.finish();
    }
    read_optional(root, "spp", sheet.spp);
    read_optional(root, "seconds", sheet.seconds);
    if (sheet.spp && sheet.seconds) root.fail("seconds", "is given together with spp, give one of them");
    read_optional(root, "columns", sheet.columns);
    const Json *panels = root.find("panels");
    if (!panels || !panels->is_array() || panels->empty())
        root.fail("panels", "a sheet needs an array of panels, each with a label and what it sets");
    for (std::size_t i = 0; i < panels->size(); ++i)
        sheet.panels.push_back(read_panel((*panels)[i], fmt::format("panels.{}", i), source));
    root.finish();
    return sheet;
}

scene::Scene load_panel(const Sheet &sheet, std::size_t index) {
    scene::Scene scene = io::load_scene(sheet.scene, sheet.panels[index].set, name_of_settings(sheet, index));
    if (sheet.width) scene.image.width = *sheet.width;
    if (sheet.height) scene.image.height = *sheet.height;
    if (sheet.spp) scene.render.spp = *sheet.spp;
    return scene;
}

std::string check_panels(Sheet &sheet) {
    const auto load_all = [&] {
        for (std::size_t i = 0; i < sheet.panels.size(); ++i) load_panel(sheet, i);
    };
    try {
        load_all();
        return "";
    } catch (const MissingFile &error) {
        if (sheet.fallback.empty()) throw;
        sheet.scene = sheet.fallback;
        load_all();
        return error.what();
    }
}

} // namespace nacre::sheet
