#pragma once
#include <map>
#include <string>
#include <vector>

namespace nacre::stress {

/// Counts what was tried and what held, for every value of every axis, and prints the table.
class Tally {
  public:
    explicit Tally(std::string title) : title(std::move(title)) {}

    /// The values of a combination, one for every axis, in the same order each time.
    using Place = std::vector<std::pair<const char *, double>>;

    /// Says whether a combination held. Of those that did not, the first few are kept, with `what` was found.
    void add(const Place &place, bool held, const std::string &what);

    std::size_t tried() const { return all.tried; }

    /// Prints the table and fails the test with those that were kept unless all held.
    void expect_all() const;

  private:
    struct Count {
        std::size_t tried = 0, held = 0;
    };
    struct Axis {
        std::string name;
        std::map<double, Count> values;
    };
    std::string title;
    Count all;
    std::vector<Axis> axes;
    std::vector<std::string> failures;
};

} // namespace nacre::stress
