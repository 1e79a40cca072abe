#pragma once
#include <string>

namespace nacre::io {

/// The values a number may take.
struct Range {
    double lower, upper;
    bool lower_open = false, upper_open = false; // the end itself is not allowed
    bool whole = false;                          // integers only

    bool holds(double value) const;
    std::string text() const; // "in (0, 180)", for messages
};

/// The range of a field by its full name ("camera.fov"). Every number in a scene has one; a name that has none is a
/// bug.
const Range &range_of(const std::string &field);

} // namespace nacre::io
