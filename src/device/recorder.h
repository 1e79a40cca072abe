#pragma once
#include "base/timeline.h"
#include "device/context.h"
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

namespace nacre::device {

/// What went through a device's in-order queue: always how often and how long each kernel ran; every launch and copy
/// where there is a timeline.
class Recorder {
  public:
    using Clock = Timeline::Clock;

    explicit Recorder(Timeline *timeline) : timeline(timeline) {}

    struct Kernel {
        std::string name;
        std::uint64_t launches = 0;
        double seconds = 0;         // on the device, of all launches
        double code_generation = 0; // the first launch's seconds that it did not run: PoCL makes machine code there
    };

    /// Launches a kernel with all its arguments for `items` work-items, rounded up to the device's work-groups, and
    /// waits for it. Returns the seconds it ran.
    double run(const Device &device, const cl::Kernel &kernel, std::size_t items);

    /// Where the copy that is enqueued next shall put its event: null, which is "no event" to OpenCL, if there is no
    /// timeline.
    cl::Event *copy(const char *name);

    /// Waits for the copies so far and puts them on the timeline.
    void settle();

    const std::vector<Kernel> &kernels() const { return ran; }
    /// Sum over the kernels.
    double code_generation() const;

  private:
    struct Copy {
        const char *name;
        Clock::time_point enqueued;
        cl::Event event;
    };
    Timeline *timeline;
    std::vector<Kernel> ran;
    std::deque<Copy> copies; // a deque does not move what OpenCL was given the address of
    // Least host time - device time seen at the end of a command. The device has its own clock, and the host sees an
    // end somewhat later than it was: the least is the best.
    Clock::duration offset = Clock::duration::max();

    double launched(const cl::Kernel &kernel, const cl::Event &event, Clock::time_point enqueued);
    Clock::time_point draw(const std::string &name, const cl::Event &event, Clock::time_point enqueued);
};

} // namespace nacre::device
