#include "io/override.h"
#include "base/error.h"
#include "io/fields.h"
#include "io/nearest.h"
#include <algorithm>
#include <fmt/format.h>

namespace nacre::io {

namespace {

// The first component of `path`. A key that is there wins, the longest first: names of materials may hold dots.
std::string first_component(const Json &node, const std::string &path) {
    std::string best = path.substr(0, path.find('.'));
    if (node.is_object())
        for (const auto &item : node.items())
            if (item.key().size() > best.size() && (path == item.key() || path.starts_with(item.key() + ".")))
                best = item.key();
    return best;
}

Json &element(Json &array, const std::string &index, const std::string &path, const std::string &subject) {
    const bool digits = !index.empty() && index.size() < 10 &&
                        std::all_of(index.begin(), index.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!digits || std::stoul(index) >= array.size())
        input_error(subject, "{}: there is no element '{}', only 0 to {}", path, index,
                    static_cast<long>(array.size()) - 1);
    return array[std::stoul(index)];
}

Json &member(Json &object, const std::string &name, const std::string &path, bool last, const std::string &subject) {
    if (!object.contains(name) && !last && path == "materials") {
        std::vector<std::string> names;
        for (const auto &item : object.items()) names.push_back(item.key());
        input_error(subject, "{}.{}: there is no such material{}", path, name, suggest(name, names));
    }
    return object[name];
}

void set(Json &tree, const Override &assignment, Source &source) {
    const std::string &subject = source.overrides;
    Json *node = &tree;
    std::string done, rest = assignment.path;
    bool noted = false;
    while (true) {
        const std::string name = first_component(*node, rest);
        if (name.empty()) input_error(subject, "'{}' is not a path like render.spp", assignment.path);
        const bool last = name.size() == rest.size();
        if (node->is_null()) *node = Json::object(); // a section the file left out
        if (node->is_array())
            node = &element(*node, name, done, subject);
        else if (node->is_object())
            node = &member(*node, name, done, last, subject);
        else
            input_error(subject, "{}: is {}, it has no '{}'", done, describe(*node), name);
        done = join(done, name);
        if (!noted && (last || node->is_null())) {
            source.overridden.push_back(done); // the outermost thing that this override made
            noted = true;
        }
        if (last) break;
        rest.erase(0, name.size() + 1);
    }
    const Json value = Json::parse(assignment.value, nullptr, false);
    *node = value.is_discarded() ? Json(assignment.value) : value;
}

} // namespace

void apply_overrides(Json &tree, const std::vector<Override> &overrides, Source &source) {
    for (const Override &assignment : overrides) set(tree, assignment, source);
}

} // namespace nacre::io
