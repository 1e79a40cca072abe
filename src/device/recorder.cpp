#include "device/recorder.h"
#include <algorithm>
#include <chrono>

namespace nacre::device {
namespace {

using std::chrono::duration;
using std::chrono::nanoseconds;

double microseconds(cl_ulong from, cl_ulong to) { return 1e-3 * double(to - from); }

} // namespace

/// Puts a command that has ended on the timeline; returns when it began to run.
Recorder::Clock::time_point Recorder::draw(const std::string &name, const cl::Event &event,
                                           Clock::time_point enqueued) {
    const auto queued = event.getProfilingInfo<CL_PROFILING_COMMAND_QUEUED>();
    const auto submitted = event.getProfilingInfo<CL_PROFILING_COMMAND_SUBMIT>();
    const auto start = event.getProfilingInfo<CL_PROFILING_COMMAND_START>();
    const auto end = event.getProfilingInfo<CL_PROFILING_COMMAND_END>();
    offset = std::min(offset, Clock::now().time_since_epoch() - nanoseconds(end));
    // Clocks drift apart: no command was queued before the host began to enqueue it.
    offset = std::max(offset, enqueued.time_since_epoch() - nanoseconds(queued));
    const auto on_host = [&](cl_ulong time) { return Clock::time_point(nanoseconds(time) + offset); };
    timeline->add(Timeline::Track::device, name, on_host(start), on_host(end),
                  {{"queued_us", microseconds(queued, submitted)}, {"submitted_us", microseconds(submitted, start)}});
    return on_host(start);
}

double Recorder::launched(const cl::Kernel &kernel, const cl::Event &event, Clock::time_point enqueued) {
    const auto ended = Clock::now();
    const double seconds = 1e-9 * double(event.getProfilingInfo<CL_PROFILING_COMMAND_END>() -
                                         event.getProfilingInfo<CL_PROFILING_COMMAND_START>());
    const std::string name = kernel.getInfo<CL_KERNEL_FUNCTION_NAME>();
    auto of_name = std::find_if(ran.begin(), ran.end(), [&](const Kernel &known) { return known.name == name; });
    const bool first = of_name == ran.end();
    if (first) {
        of_name = ran.insert(ran.end(), {.name = name});
        of_name->code_generation = std::max(0.0, duration<double>(ended - enqueued).count() - seconds);
    }
    of_name->launches += 1;
    of_name->seconds += seconds;
    if (timeline) {
        const auto began = draw(name, event, enqueued);
        settle(); // after the launch, whose end the host has just seen
        if (first) timeline->add(Timeline::Track::host, "generate code: " + name, enqueued, began);
    }
    return seconds;
}

double Recorder::run(const Device &device, const cl::Kernel &kernel, std::size_t items) {
    const std::size_t group = std::size_t(device.quirks.work_group), global = (items + group - 1) / group * group;
    const auto enqueued = Clock::now();
    cl::Event event;
    device.queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(global), cl::NDRange(group), nullptr, &event);
    event.wait();
    return launched(kernel, event, enqueued);
}

cl::Event *Recorder::copy(const char *name) {
    if (!timeline) return nullptr;
    return &copies.emplace_back(Copy{name, Clock::now(), {}}).event;
}

void Recorder::settle() {
    for (const Copy &copy : copies) {
        if (copy.event() == nullptr) continue; // enqueueing it failed
        copy.event.wait();
        draw(copy.name, copy.event, copy.enqueued);
    }
    copies.clear();
}

double Recorder::code_generation() const {
    double sum = 0;
    for (const Kernel &kernel : ran) sum += kernel.code_generation;
    return sum;
}

} // namespace nacre::device
