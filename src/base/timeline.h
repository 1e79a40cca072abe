#pragma once
#include <chrono>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace nacre {

/// What happened when, as spans on a few tracks, for chrome://tracing and Perfetto. Used from one thread.
class Timeline {
  public:
    using Clock = std::chrono::steady_clock;
    enum class Track { host = 1, device = 2 };
    using Arguments = std::vector<std::pair<const char *, double>>;

    /// The first `capacity` spans are kept (some 200 bytes each), those after are only counted.
    explicit Timeline(std::size_t capacity = 1 << 18) : capacity(capacity) {}

    void add(Track track, std::string name, Clock::time_point begin, Clock::time_point end, Arguments arguments = {});

    std::size_t size() const { return spans.size(); }
    std::size_t dropped() const { return lost; }

    /// Trace-event JSON: complete events ("ph": "X"), ts and dur in microseconds since the timeline was made.
    std::string json() const;

  private:
    struct Entry {
        Track track;
        std::string name;
        Clock::time_point begin, end;
        Arguments arguments;
    };
    Clock::time_point origin = Clock::now();
    std::size_t capacity, lost = 0;
    std::vector<Entry> spans;
};

/// From here to the end of the scope: a span of the host on `timeline`, and its seconds added to `seconds`, where they
/// are not null. With neither it does nothing.
class Span {
  public:
    Span(Timeline *timeline, const char *name, double *seconds = nullptr);
    ~Span();
    Span(const Span &) = delete;
    Span &operator=(const Span &) = delete;

  private:
    Timeline *timeline;
    const char *name;
    double *seconds;
    Timeline::Clock::time_point begin{};
};

} // namespace nacre
