#include "error_time/plot.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace nacre::bench {
namespace {

constexpr double left = 70, top = 14, width = 430, height = 300, legend = 240;

/// Far apart in hue, neighbours too: steps of the golden angle.
std::string color(std::size_t index) {
    return fmt::format("hsl({:.0f},65%,{}%)", std::fmod(210 + 137.508 * double(index), 360.0), index % 2 ? 38 : 50);
}

/// Decimal logarithms from `low` to `high` on `length` pixels that begin at `start`; negative `length`: upwards.
struct Axis {
    double low, high, start, length;
    double at(double value) const { return start + (std::log10(value) - low) / (high - low) * length; }
};

Axis axis_of(const std::vector<Curve> &curves, std::vector<double> Curve::*values, double start, double length) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const Curve &curve : curves)
        for (const double value : curve.*values)
            if (value > 0 && std::isfinite(value)) {
                low = std::min(low, std::log10(value));
                high = std::max(high, std::log10(value));
            }
    if (!(low <= high)) low = high = 0;
    const double margin = std::max(.05 * (high - low), .02);
    return {low - margin, high + margin, start, length};
}

/// 1, 2 and 5 times powers of ten that are on the axis.
std::vector<double> ticks(const Axis &axis) {
    std::vector<double> found;
    for (int decade = int(std::floor(axis.low)); decade <= int(std::ceil(axis.high)); ++decade)
        for (const double digit : {1., 2., 5.})
            if (const double value = digit * std::pow(10., decade);
                std::log10(value) >= axis.low && std::log10(value) <= axis.high)
                found.push_back(value);
    return found;
}

std::string text(double x, double y, const char *anchor, const std::string &content, const std::string &more = {}) {
    return fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='{}' {}>{}</text>", x, y, anchor, more,
                       escaped(content));
}

std::string segment(double x0, double y0, double x1, double y1, const std::string &style) {
    return fmt::format("<line x1='{:.1f}' y1='{:.1f}' x2='{:.1f}' y2='{:.1f}' style='{}'/>", x0, y0, x1, y1, style);
}

std::string frame(const Axis &x, const Axis &y, const std::string &x_title, const std::string &y_title) {
    std::string out;
    const double bottom = top + height;
    for (const double value : ticks(x)) {
        out += segment(x.at(value), top, x.at(value), bottom, "stroke:#ddd");
        out += text(x.at(value), bottom + 15, "middle", fmt::format("{:g}", value));
    }
    for (const double value : ticks(y)) {
        out += segment(left, y.at(value), left + width, y.at(value), "stroke:#ddd");
        out += text(left - 5, y.at(value) + 4, "end", fmt::format("{:g}", value));
    }
    out += text(left + width / 2, bottom + 32, "middle", x_title);
    const double middle = top + height / 2;
    return out + text(14, middle, "middle", y_title, fmt::format("transform='rotate(-90 14 {:.1f})'", middle));
}

} // namespace

std::string plot_curves(const std::vector<Curve> &curves, const std::string &x_title, const std::string &y_title) {
    const Axis x = axis_of(curves, &Curve::x, left, width), y = axis_of(curves, &Curve::y, top + height, -height);
    std::string out = fmt::format("<svg width='{}' height='{}'>", left + width + legend, top + height + 40);
    out += frame(x, y, x_title, y_title);
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const Curve &curve = curves[i];
        std::vector<double> on;
        for (std::size_t k = 0; k < curve.x.size(); ++k) {
            if (!(curve.x[k] > 0 && curve.y[k] > 0)) continue;
            on.push_back(curve.x[k]);
            out += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='3' fill='{}'/>", x.at(curve.x[k]), y.at(curve.y[k]),
                               color(i));
        }
        if (!on.empty()) {
            const auto ends = std::minmax_element(on.begin(), on.end());
            const auto height_at = [&](double value) { return y.at(std::exp(curve.power.at(std::log(value)))); };
            out += segment(x.at(*ends.first), height_at(*ends.first), x.at(*ends.second), height_at(*ends.second),
                           "stroke:" + color(i));
        }
        const double line = top + 10 + 16 * double(i);
        out += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='4' fill='{}'/>", left + width + 14, line - 4, color(i));
        out += text(left + width + 24, line, "start", curve.name);
    }
    return out + "</svg>";
}

std::string plot_bars(const std::vector<Bar> &bars, const std::string &title) {
    constexpr double names = 150, row = 18;
    double longest = 0;
    for (const Bar &bar : bars) longest = std::max(longest, bar.length.high);
    const auto at = [&](double value) { return names + (longest > 0 ? value / longest : 0) * width; };
    std::string out = fmt::format("<svg width='{}' height='{}'>", names + width + 90, row * double(bars.size()) + 24);
    out += text(names, 12, "start", title);
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const Interval &length = bars[i].length;
        const double y = 20 + row * double(i), middle = y + row / 2 - 2;
        out += text(names - 6, y + 12, "end", bars[i].name);
        out += fmt::format("<rect x='{}' y='{:.1f}' width='{:.1f}' height='{}' fill='hsl(210,50%,65%)'/>", names, y,
                           at(length.value) - names, row - 5);
        out += segment(at(length.low), middle, at(length.high), middle, "stroke:#000");
        out += text(at(length.high) + 6, y + 12, "start", fmt::format("{:.4g}", length.value));
    }
    return out + "</svg>";
}

std::string escaped(const std::string &text) {
    std::string out;
    for (const char c : text) {
        if (c == '<')
            out += "&lt;";
        else if (c == '&')
            out += "&amp;";
        else
            out += c;
    }
    return out;
}

} // namespace nacre::bench
