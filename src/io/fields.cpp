#include "io/fields.h"
#include "base/error.h"
#include "io/nearest.h"
#include "io/ranges.h"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace nacre::io {

std::string describe(const Json &value) {
    if (value.is_array()) return fmt::format("an array of {}", value.size());
    if (value.is_object()) return "an object";
    if (value.is_null()) return "null";
    if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
    if (value.is_string()) return fmt::format("\"{}\"", value.get_ref<const std::string &>());
    return fmt::format("{}", value.get<double>());
}

Fields::Fields(const Json &tree, std::string path, std::string kind, const Source &source)
    : tree(tree), here(std::move(path)), kind(std::move(kind)), origin(source) {
    if (!tree.is_object()) origin.fail(here, fmt::format("expected an object, got {}", describe(tree)));
}

void Fields::fail(const std::string &name, const std::string &message) const { origin.fail(path(name), message); }

const Json *Fields::find(const std::string &name) {
    known.push_back(name);
    const auto found = tree.find(name);
    return found == tree.end() ? nullptr : &*found;
}

double Fields::number(const std::string &name, const Json &value) const {
    if (!value.is_number()) fail(name, fmt::format("expected a number, got {}", describe(value)));
    const double number = value.get<double>();
    const Range &range = range_of(kind + "." + name);
    if (!range.holds(number)) fail(name, fmt::format("{} is out of range, must be {}", number, range.text()));
    return number;
}

void Fields::read(const std::string &name, double &value) {
    if (const Json *found = find(name)) value = number(name, *found);
}

void Fields::read(const std::string &name, int &value) {
    if (const Json *found = find(name)) value = static_cast<int>(number(name, *found));
}

void Fields::read(const std::string &name, std::uint32_t &value) {
    if (const Json *found = find(name)) value = static_cast<std::uint32_t>(number(name, *found));
}

void Fields::read(const std::string &name, bool &value) {
    const Json *found = find(name);
    if (!found) return;
    if (!found->is_boolean()) fail(name, fmt::format("expected true or false, got {}", describe(*found)));
    value = found->get<bool>();
}

void Fields::read(const std::string &name, std::string &value) {
    const Json *found = find(name);
    if (!found) return;
    if (!found->is_string()) fail(name, fmt::format("expected a string, got {}", describe(*found)));
    value = found->get<std::string>();
}

template <typename Vector> void Fields::read_vector(const std::string &name, Vector &value) {
    const Json *found = find(name);
    if (!found) return;
    if (!found->is_array() || found->size() != static_cast<std::size_t>(value.size()))
        fail(name, fmt::format("expected {} numbers, got {}", value.size(), describe(*found)));
    for (int i = 0; i < value.size(); ++i) value[i] = number(name, (*found)[i]);
}

void Fields::read(const std::string &name, Vec2 &value) { read_vector(name, value); }
void Fields::read(const std::string &name, Vec3 &value) { read_vector(name, value); }

void Fields::read_color(const std::string &name, Vec3 &value) {
    const Json *found = find(name);
    if (!found) return;
    if (found->is_number())
        value = Vec3::Constant(number(name, *found));
    else if (found->is_array() && found->size() == 3)
        read(name, value);
    else
        fail(name, fmt::format("expected a number or three, got {}", describe(*found)));
}

void Fields::choose(const std::string &name, std::span<const Choice> choices, int &value) {
    std::string word;
    if (!find(name)) return;
    read(name, word);
    std::vector<std::string> all;
    for (const Choice &choice : choices) all.emplace_back(choice.name);
    const auto chosen = std::find_if(choices.begin(), choices.end(), [&](const Choice &c) { return word == c.name; });
    if (chosen == choices.end()) fail(name, fmt::format("unknown value '{}'{}", word, suggest(word, all)));
    value = chosen->value;
}

void Fields::finish() const {
    for (const auto &item : tree.items())
        if (std::find(known.begin(), known.end(), item.key()) == known.end())
            fail(item.key(), "unknown field" + suggest(item.key(), known));
}

} // namespace nacre::io
