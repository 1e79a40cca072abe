// The HTML page: everything inline, so that it can be sent on as one file.
#include "error_time/plot.h"
#include "error_time/report.h"
#include <fmt/format.h>

namespace nacre::bench {
namespace {

constexpr const char *style = "body{font:14px sans-serif;max-width:1100px;margin:2em auto;padding:0 1em;color:#222}"
                              "svg text{font:11px sans-serif}svg{display:block;margin:1em 0}"
                              "table{border-collapse:collapse}td,th{padding:2px 9px;text-align:right}"
                              "td:first-child,th:first-child{text-align:left}tr:nth-child(even){background:#f4f4f4}"
                              ".fails{color:#b00}";

constexpr const char *legend =
    "<p>Each point is a budget: the mean over independent seeds, none left out. relMSE is the mean of (A - B)&sup2; / "
    "(B&sup2; + (mean of B / 10)&sup2;) to a reference B made of other seeds, whose own noise is taken off. Seconds "
    "are "
    "those of sampling alone; start-up and compiling are in a table of their own. Efficiency is 1 / (relative variance "
    "x seconds) at the largest budget with its 95 % bootstrap interval. 99.9 %: this share of all pixels has a smaller "
    "relative error. FLIP: HDR-FLIP, mean. Bias: of the mean of all pixels, and in standard errors (z). Equal time: "
    "relMSE "
    "over that of the default in the same time; equal error: seconds over those of the default for the same relMSE. A "
    "mode "
    "whose pictures fail nacre compare's test against the reference has no score.</p>";

std::vector<const Result *> scored(const SceneReport &scene) {
    std::vector<const Result *> all;
    for (const auto *results : {&scene.modes, &scene.peers})
        for (const Result &result : *results)
            if (result.passes) all.push_back(&result);
    return all;
}

std::string plots(const SceneReport &scene) {
    std::vector<Curve> curves;
    std::vector<Bar> bars;
    for (const Result *result : scored(scene)) {
        Curve &curve = curves.emplace_back();
        curve.name = fmt::format("{}, slope {:.2f}", result->name, result->slope.value);
        curve.power = result->power;
        for (const Budget &budget : result->budgets) {
            curve.x.push_back(budget.seconds);
            curve.y.push_back(budget.relmse);
        }
        bars.push_back({result->name, result->largest().efficiency});
    }
    return plot_curves(curves, "seconds of sampling", "relMSE") +
           plot_bars(bars, "Efficiency: 1 / (relative variance x seconds)");
}

std::string row(const Result &result, const Budget &b) {
    std::string out =
        fmt::format("<tr><td>{}</td><td>{}</td><td>{:.4f}</td><td>{:.3g}</td><td>{:.3f}</td><td>{:.4f}</td>"
                    "<td>{:+.3f} %</td><td>{:+.2f}</td>",
                    escaped(result.name), b.spp, b.seconds, b.relmse, b.worst, b.flip, 100 * b.bias, b.bias_z);
    if (!result.passes) return out + "<td class='fails' colspan='3'>fails the check</td></tr>";
    out +=
        fmt::format("<td>{:.4g} ({:.4g} &ndash; {:.4g})</td>", b.efficiency.value, b.efficiency.low, b.efficiency.high);
    if (&b != &result.largest()) return out + "<td></td><td></td></tr>";
    return out + fmt::format("<td>{:.2f}</td><td>{:.2f}</td></tr>", result.equal_time, result.equal_error);
}

std::string figures(const SceneReport &scene) {
    std::string out = "<table><tr><th></th><th>spp</th><th>seconds</th><th>relMSE</th><th>99.9 %</th><th>FLIP</th>"
                      "<th>bias</th><th>z</th><th>efficiency</th><th>equal time</th><th>equal error</th></tr>";
    for (const auto *results : {&scene.modes, &scene.peers})
        for (const Result &result : *results)
            for (const Budget &budget : result.budgets) out += row(result, budget);
    return out + "</table>";
}

std::string startup(const SceneReport &scene) {
    std::string out = "<h3>Start-up, apart</h3><table><tr><th></th><th>BVH s</th><th>clearance s</th><th>compile s</th>"
                      "<th>code generation s</th><th>first pixel s</th><th>check p</th></tr>";
    for (const Result &result : scene.modes) {
        const render::Startup &s = result.startup;
        out += fmt::format("<tr><td>{}</td><td>{:.3f}</td><td>{:.3f}</td><td>{:.3f}</td><td>{:.3f}</td><td>{:.3f}</td>"
                           "<td>{}</td></tr>",
                           escaped(result.name), s.bvh, s.clearance, s.compile, s.code_generation, s.first_pixel,
                           result.p ? fmt::format("{:.3g}", *result.p) : "");
    }
    return out + "</table>";
}

std::string gains(const SceneReport &scene) {
    std::string out;
    for (const Result &peer : scene.peers) {
        const Interval better = gain(scene.modes.front(), peer, &Distance::seconds);
        const Interval cpu = gain(scene.modes.front(), peer, &Distance::cpu);
        out +=
            fmt::format("<p>1 / (variance x seconds), nacre's default over {}: <b>{:.2f}</b> ({:.2f} &ndash; {:.2f}); "
                        "by CPU time <b>{:.2f}</b> ({:.2f} &ndash; {:.2f}).</p>",
                        escaped(peer.name), better.value, better.low, better.high, cpu.value, cpu.low, cpu.high);
    }
    return out;
}

} // namespace

std::string to_page(const Report &report) {
    std::string out = fmt::format(
        "<!doctype html><html lang='en'><head><meta charset='utf-8'><title>nacre: error and time</title><style>{}"
        "</style></head><body><h1>Error and time</h1><p>{}</p>{}",
        style, escaped(report.device), legend);
    for (const std::string &remark : report.remarks) out += "<p>" + escaped(remark) + "</p>";
    for (const SceneReport &scene : report.scenes) {
        const std::string what = fmt::format("{}; {} x {} pixels, reference of {} samples a pixel", scene.shows,
                                             scene.width, scene.height, scene.reference_spp);
        out += fmt::format("<h2>{}</h2><p>{}</p>{}{}{}{}\n", escaped(scene.name), escaped(what), gains(scene),
                           plots(scene), figures(scene), startup(scene));
    }
    return out + "</body></html>\n";
}

} // namespace nacre::bench
