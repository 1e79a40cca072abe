#include "app/compare_report.h"
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace nacre::app {
namespace {

using compare::Family, compare::Verdict;

std::string probability(double p) { return p < 1e-300 ? "below 1e-300" : fmt::format("{:.3g}", p); }

/// Where the worst difference of a family is; `side` pixels wide and high, 0: all of them.
std::string place(const Comparison &c, const Family &family, int side) {
    const int x = c.a.crop_x + family.x, y = c.a.crop_y + family.y;
    const char channel = "RGB"[family.channel];
    if (side == 0) return fmt::format("{}", channel);
    if (side == 1) return fmt::format("{} at {}, {}", channel, x, y);
    return fmt::format("{} at {}, {} to {}, {}", channel, x, y, c.a.crop_x + std::min(family.x + side, c.a.width) - 1,
                       c.a.crop_y + std::min(family.y + side, c.a.height) - 1);
}

std::string family_line(const Comparison &c, const char *name, const Family &family, int side) {
    return fmt::format("  {:<8}{:>9}{:>9}{:>9.2f}{:>9.2f}  {:<12}  {}\n", name, family.tested, family.beyond,
                       family.limit, family.z, probability(family.p), place(c, family, side));
}

std::string verdict_text(const Comparison &c, const Verdict &v) {
    std::string text = fmt::format("\n  {:<8}{:>9}{:>9}{:>9}{:>9}  {:<12}  {}\n", "test", "tested", "beyond", "limit",
                                   "z", "p", "worst");
    text += family_line(c, "pixels", v.pixels, 1) + family_line(c, "tiles", v.tiles, compare::tile_size) +
            family_line(c, "picture", v.picture, 0);
    text += "\n  mean          A            B        A - B\n";
    for (int channel = 0; channel < 3; ++channel) {
        const compare::Channel &mean = v.channels[channel];
        const double unit = mean.mean_b != 0 ? 100 / std::abs(mean.mean_b) : 0;
        text += fmt::format("  {}  {:>12.6g} {:>12.6g}  {:>+9.3f} % +- {:.3f} %, z {:.2f}\n", "RGB"[channel],
                            mean.mean_a, mean.mean_b, (mean.mean_a - mean.mean_b) * unit, mean.error * unit, mean.z);
    }
    text += "\n";
    if (v.not_finite > 0)
        text += fmt::format("pixels with infinity, no number or a variance below 0: {}, the first at {}, {}\n",
                            v.not_finite, c.a.crop_x + v.not_finite_x, c.a.crop_y + v.not_finite_y);
    if (v.untested > 0) text += fmt::format("pixels without samples, not tested: {}\n", v.untested);
    return text +
           fmt::format("{}: p {}, at alpha {:g}\n", v.different() ? "different" : "alike", probability(v.p), v.alpha);
}

/// JSON knows no infinity.
nlohmann::ordered_json number(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json();
}

nlohmann::ordered_json family_json(const Comparison &c, const Family &family, bool with_place) {
    nlohmann::ordered_json worst{{"channel", std::string(1, "RGB"[family.channel])}, {"z", family.z}};
    if (with_place) {
        worst["x"] = c.a.crop_x + family.x;
        worst["y"] = c.a.crop_y + family.y;
    }
    return {{"tested", family.tested},
            {"beyond", family.beyond},
            {"limit", number(family.limit)},
            {"p", family.p},
            {"worst", worst}};
}

nlohmann::ordered_json verdict_json(const Comparison &c, const Verdict &v) {
    auto channels = nlohmann::ordered_json::array();
    for (int channel = 0; channel < 3; ++channel) {
        const compare::Channel &mean = v.channels[channel];
        channels.push_back({{"channel", std::string(1, "RGB"[channel])},
                            {"mean_a", mean.mean_a},
                            {"mean_b", mean.mean_b},
                            {"error", mean.error},
                            {"z", mean.z}});
    }
    return {{"different", v.different()},
            {"alpha", v.alpha},
            {"p", v.p},
            {"pixels", family_json(c, v.pixels, true)},
            {"tiles", family_json(c, v.tiles, true)},
            {"picture", family_json(c, v.picture, false)},
            {"channels", channels},
            {"tile_size", compare::tile_size},
            {"not_finite",
             {{"pixels", v.not_finite}, {"x", c.a.crop_x + v.not_finite_x}, {"y", c.a.crop_y + v.not_finite_y}}},
            {"untested", v.untested}};
}

nlohmann::ordered_json picture_json(const std::string &file, const io::Picture &picture, double samples) {
    return {{"file", file}, {"samples", samples}, {"metadata", picture.metadata}};
}

} // namespace

std::string as_text(const Comparison &c) {
    std::string text = fmt::format("A  {}, {:.6g} samples a pixel\nB  {}, {:.6g} samples a pixel\n\n", c.file_a,
                                   c.samples_a, c.file_b, c.samples_b);
    text += fmt::format("  MSE     {:.6g}\n  relMSE  {:.6g}\n  PSNR    {:.2f} dB\n", c.metrics.mse, c.metrics.relmse,
                        c.metrics.psnr);
    text += fmt::format("  FLIP    {:.6g}, at most {:.4g} at {}, {}\n", c.flip, c.flip_largest, c.flip_x, c.flip_y);
    return c.verdict ? text + verdict_text(c, *c.verdict) : text;
}

std::string as_json(const Comparison &c) {
    const nlohmann::ordered_json document{
        {"a", picture_json(c.file_a, c.a, c.samples_a)},
        {"b", picture_json(c.file_b, c.b, c.samples_b)},
        {"size", {c.a.width, c.a.height}},
        {"metrics",
         {{"mse", c.metrics.mse},
          {"relmse", number(c.metrics.relmse)},
          {"psnr", number(c.metrics.psnr)},
          {"flip", {{"mean", c.flip}, {"largest", c.flip_largest}, {"x", c.flip_x}, {"y", c.flip_y}}}}},
        {"test", c.verdict ? verdict_json(c, *c.verdict) : nlohmann::ordered_json()},
        {"remarks", c.remarks}};
    return document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace nacre::app
