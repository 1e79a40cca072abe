#pragma once
#include "error_time/figures.h"
#include <string>
#include <vector>

namespace nacre::bench {

/// Points in one colour; `line`, a power law, is drawn through them.
struct Curve {
    std::string name;
    std::vector<double> x, y; // > 0; others are left out of the drawing alone
    Line power;
};

/// Both axes logarithmic, a legend beside. An <svg> element.
std::string plot_curves(const std::vector<Curve> &curves, const std::string &x_title, const std::string &y_title);

struct Bar {
    std::string name;
    Interval length;
};

/// Bars from 0 with their intervals. An <svg> element.
std::string plot_bars(const std::vector<Bar> &bars, const std::string &title);

/// Text as HTML.
std::string escaped(const std::string &text);

} // namespace nacre::bench
