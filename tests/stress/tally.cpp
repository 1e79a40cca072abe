#include "stress/tally.h"
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace nacre::stress {

void Tally::add(const Place &place, bool held, const std::string &what) {
    constexpr std::size_t most_failures = 20;
    axes.resize(place.size());
    const auto count = [held](Count &c) {
        ++c.tried;
        c.held += held;
    };
    count(all);
    for (std::size_t i = 0; i < place.size(); ++i) {
        axes[i].name = place[i].first;
        count(axes[i].values[place[i].second]);
    }
    if (held || failures.size() >= most_failures) return;
    std::string where;
    for (const auto &[name, value] : place) where += fmt::format("{} {:.12g}, ", name, value);
    failures.push_back(where + what);
}

void Tally::expect_all() const {
    fmt::print("{}: {} of {} combinations hold\n", title, all.held, all.tried);
    for (const Axis &axis : axes) {
        fmt::print("  {:<12}", axis.name);
        for (const auto &[value, count] : axis.values) fmt::print("  {:.8g}: {}/{}", value, count.held, count.tried);
        fmt::print("\n");
    }
    for (const std::string &failure : failures) ADD_FAILURE() << failure;
    EXPECT_EQ(all.held, all.tried) << title;
    EXPECT_GT(all.tried, 0u) << title;
}

} // namespace nacre::stress
