#include "patch/plot.h"
#include <algorithm>
#include <fmt/format.h>
#include <set>
#include <vector>

namespace nacre::patch {
namespace {

constexpr double width = 720, height = 520, left = 70, top = 40, side = 420; // the square that holds the curves

double across(double color) { return left + side * color; }
double down(double albedo) { return top + side * (1 - std::clamp(albedo, 0.0, 1.05)); }

std::string axes() {
    std::string text;
    for (int i = 0; i <= 5; ++i) {
        const double at = i / 5.0;
        text += fmt::format("<path d='M{0:.1f} {1:.1f}V{2:.1f}M{3:.1f} {4:.1f}H{5:.1f}' stroke='#ddd'/>", across(at),
                            down(0), down(1), across(0), down(at), across(1));
        text +=
            fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='middle'>{:.1f}</text>", across(at), down(0) + 18, at);
        text += fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='end'>{:.1f}</text>", left - 8, down(at) + 4, at);
    }
    text += fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='middle'>colour</text>", across(0.5), down(0) + 38);
    text += fmt::format("<text transform='translate({:.1f},{:.1f}) rotate(-90)' text-anchor='middle'>"
                        "single-scattering albedo</text>",
                        left - 42, down(0.5));
    return text;
}

} // namespace

std::string plot_fit(const Survey &survey, const albedo::MemoFit &fit, const std::string &title) {
    std::set<double> all;
    for (const Survey::Point &point : survey.points) all.insert(point.g);
    const std::vector<double> sorted(all.begin(), all.end());
    std::string text =
        fmt::format("<svg xmlns='http://www.w3.org/2000/svg' width='{0}' height='{1}' viewBox='0 0 {0} {1}' "
                    "font-family='sans-serif' font-size='13'><rect width='100%' height='100%' fill='white'/>"
                    "<text x='{2}' y='24' font-size='15'>{3}</text>",
                    width, height, left, title) +
        axes();
    constexpr std::size_t curves = 6;
    for (std::size_t k = 0; k < curves && !sorted.empty(); ++k) {
        const double g = sorted[k * (sorted.size() - 1) / (curves - 1)];
        const std::string color = fmt::format("hsl({:.0f},70%,42%)", 220 - 220.0 * double(k) / (curves - 1));
        std::string line;
        for (int i = 0; i <= 200; ++i)
            line += fmt::format("{}{:.1f} {:.1f}", i ? "L" : "M", across(i / 200.0),
                                down(albedo::memo_albedo(fit, i / 200.0, g)));
        text += fmt::format("<path d='{}' fill='none' stroke='{}' stroke-width='1.5'/>", line, color);
        for (const Survey::Point &point : survey.points)
            if (point.g == g)
                text += fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='2.5' fill='{}'/>", across(point.color),
                                    down(point.albedo), color);
        text += fmt::format("<text x='{:.1f}' y='{:.1f}' fill='{}'>g {:.2f}</text>", left + side + 24,
                            top + 20 + 22 * double(k), color, g);
    }
    return text + "</svg>\n";
}

} // namespace nacre::patch
