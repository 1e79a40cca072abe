#include "io/nearest.h"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numeric>
#include <vector>

namespace nacre::io {

namespace {

// Levenshtein's distance: insertions, deletions and replacements that make b of a.
std::size_t edit_distance(const std::string &a, const std::string &b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] != b[j - 1]);
            diagonal = row[j];
            row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row[b.size()];
}

} // namespace

std::string suggest(const std::string &name, std::span<const std::string> known) {
    if (known.empty()) return "";
    const auto distance = [&](const std::string &other) { return edit_distance(name, other); };
    const auto nearest = std::min_element(known.begin(), known.end(),
                                          [&](const auto &a, const auto &b) { return distance(a) < distance(b); });
    // "colour" for "base_color" is far in edits, yet clearly meant.
    const bool part = name.size() >= 4 && nearest->find(name) != std::string::npos;
    if (part || distance(*nearest) <= std::max<std::size_t>(2, name.size() / 3))
        return fmt::format(", did you mean '{}'?", *nearest);
    return fmt::format("; known: {}", fmt::join(known, ", "));
}

} // namespace nacre::io
