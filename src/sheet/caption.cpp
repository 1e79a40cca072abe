#include "sheet/caption.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace nacre::sheet {
namespace {

const std::string *value_of(const Panel &panel, const std::string &path) {
    for (const io::Override &assignment : panel.set)
        if (assignment.path == path) return &assignment.value;
    return nullptr;
}

bool same_everywhere(const Sheet &sheet, const io::Override &assignment) {
    return std::all_of(sheet.panels.begin(), sheet.panels.end(), [&](const Panel &panel) {
        const std::string *value = value_of(panel, assignment.path);
        return value && *value == assignment.value;
    });
}

// "subsurface_bleed" of "materials.skin.subsurface_bleed": figures have one material.
std::string last_component(const std::string &path) { return path.substr(path.rfind('.') + 1); }

std::string without_quotes(const std::string &json) {
    return json.size() >= 2 && json.front() == '"' ? json.substr(1, json.size() - 2) : json;
}

} // namespace

std::vector<std::string> differing_settings(const Sheet &sheet, std::size_t index) {
    std::vector<std::string> result;
    for (const io::Override &assignment : sheet.panels[index].set)
        if (!same_everywhere(sheet, assignment))
            result.push_back(last_component(assignment.path) + " " + without_quotes(assignment.value));
    return result;
}

std::optional<double> relative_error(const io::Picture &picture) {
    const auto found = std::find(picture.channels.begin(), picture.channels.end(), "variance.R");
    const std::size_t channels = picture.channels.size(), variance = std::size_t(found - picture.channels.begin());
    double sum = 0, squares = 0, lit = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); i += channels) {
        const float *pixel = picture.pixels.data() + i;
        if (!(pixel[0] + pixel[1] + pixel[2] > 0)) continue;
        lit += 3;
        for (std::size_t c = 0; c < 3; ++c) {
            sum += pixel[c];
            squares += pixel[variance + c];
        }
    }
    if (lit == 0 || squares == 0) return {};
    return std::sqrt(squares / lit) / (sum / lit);
}

std::string cost_line(const io::Picture &picture, double seconds, std::uint64_t samples) {
    const double per_pixel = double(samples) / (double(picture.width) * picture.height);
    const std::optional<double> error = relative_error(picture);
    return fmt::format("{:.3g} s, {:.3g} spp, error {}", seconds, per_pixel,
                       error ? fmt::format("{:.3g} %", 100 * *error) : "unknown");
}

} // namespace nacre::sheet
