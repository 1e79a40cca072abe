#include "base/timeline.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace nacre {

using std::chrono::duration;

void Timeline::add(Track track, std::string name, Clock::time_point begin, Clock::time_point end, Arguments arguments) {
    if (spans.size() < capacity)
        spans.push_back({track, std::move(name), begin, end, std::move(arguments)});
    else
        ++lost;
}

std::string Timeline::json() const {
    const auto microseconds = [&](Clock::duration d) { return duration<double, std::micro>(d).count(); };
    // Written piece by piece: as one document in memory it would be several times the spans.
    std::string out = fmt::format("{{\"otherData\": {{\"dropped_spans\": {}}},\n\"traceEvents\": [", lost);
    for (const auto &[track, name] : {std::pair{Track::host, "host"}, {Track::device, "device queue"}})
        out +=
            fmt::format("{}{{\"ph\": \"M\", \"name\": \"thread_name\", \"pid\": 1, \"tid\": {}, \"args\": {{\"name\": "
                        "\"{}\"}}}}",
                        track == Track::host ? "\n" : ",\n", int(track), name);
    for (const Entry &span : spans) {
        out += fmt::format(",\n{{\"ph\": \"X\", \"name\": {}, \"pid\": 1, \"tid\": {}, \"ts\": {:.3f}, \"dur\": {:.3f}",
                           nlohmann::json(span.name).dump(), int(span.track), microseconds(span.begin - origin),
                           microseconds(span.end - span.begin));
        if (!span.arguments.empty()) {
            out += ", \"args\": ";
            char separator = '{';
            for (const auto &[key, value] : span.arguments) {
                out += fmt::format("{}\"{}\": {:.3f}", separator, key, value);
                separator = ',';
            }
            out += '}';
        }
        out += '}';
    }
    return out + "\n]}\n";
}

Span::Span(Timeline *timeline, const char *name, double *seconds) : timeline(timeline), name(name), seconds(seconds) {
    if (timeline || seconds) begin = Timeline::Clock::now();
}

Span::~Span() {
    if (!timeline && !seconds) return;
    const auto end = Timeline::Clock::now();
    if (timeline) timeline->add(Timeline::Track::host, name, begin, end);
    if (seconds) *seconds += duration<double>(end - begin).count();
}

} // namespace nacre
