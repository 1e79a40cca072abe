// The timeline: what it writes is what happened, and it does not grow without end.
#include "base/timeline.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <thread>

namespace nacre {
namespace {

using namespace std::chrono_literals;
using Json = nlohmann::json;

/// The spans with this name, in the order they were added.
std::vector<Json> named(const Timeline &timeline, const std::string &name) {
    std::vector<Json> found;
    const Json trace = Json::parse(timeline.json());
    for (const Json &event : trace["traceEvents"])
        if (event["ph"] == "X" && event["name"] == name) found.push_back(event);
    return found;
}

TEST(Timeline, SpansEndWithTheirScope) {
    Timeline timeline;
    double seconds = 1;
    {
        const Span outer(&timeline, "outer");
        std::this_thread::sleep_for(2ms);
        const Span inner(&timeline, "inner", &seconds);
        std::this_thread::sleep_for(2ms);
    }
    const Json outer = named(timeline, "outer").at(0), inner = named(timeline, "inner").at(0);
    EXPECT_GE(inner["dur"].get<double>(), 2000);
    EXPECT_GE(inner["ts"].get<double>(), outer["ts"].get<double>() + 2000);
    EXPECT_LE(inner["ts"].get<double>() + inner["dur"].get<double>(),
              outer["ts"].get<double>() + outer["dur"].get<double>() + 0.002); // written to the nanosecond
    EXPECT_NEAR(seconds, 1 + 1e-6 * inner["dur"].get<double>(), 1e-8) << "seconds are added to what was there";
}

TEST(Timeline, WithoutOneSpansOnlyAddUp) {
    double seconds = 0;
    {
        const Span span(nullptr, "name", &seconds);
        std::this_thread::sleep_for(1ms);
    }
    EXPECT_GE(seconds, 1e-3);
    const Span nothing(nullptr, "name");
}

TEST(Timeline, TracksHaveNamesAndArgumentsAreKept) {
    Timeline timeline;
    const auto now = Timeline::Clock::now();
    timeline.add(Timeline::Track::device, "a \"kernel\"\n", now + 1500ns, now + 4us, {{"queued_us", 0.25}, {"n", 3}});
    const Json span = named(timeline, "a \"kernel\"\n").at(0);
    EXPECT_DOUBLE_EQ(span["dur"], 2.5);
    EXPECT_EQ(span["args"], (Json{{"queued_us", 0.25}, {"n", 3.0}}));
    std::map<int, std::string> tracks;
    const Json trace = Json::parse(timeline.json());
    for (const Json &event : trace["traceEvents"])
        if (event["ph"] == "M") tracks[event["tid"]] = event["args"]["name"];
    EXPECT_EQ(tracks[span["tid"]], "device queue");
    EXPECT_EQ(tracks.size(), 2u);
}

TEST(Timeline, WhatDoesNotFitIsCounted) {
    Timeline timeline(3);
    const auto now = Timeline::Clock::now();
    for (const char *name : {"a", "b", "c", "d", "e"}) timeline.add(Timeline::Track::host, name, now, now);
    EXPECT_EQ(timeline.size(), 3u);
    EXPECT_EQ(timeline.dropped(), 2u);
    EXPECT_EQ(Json::parse(timeline.json())["otherData"]["dropped_spans"], 2);
    EXPECT_EQ(named(timeline, "c").size(), 1u);
    EXPECT_TRUE(named(timeline, "d").empty());
}

} // namespace
} // namespace nacre
