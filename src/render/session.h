#pragma once
#include "device/program.h"
#include "render/film.h"
#include "render/statistics.h"
#include "render/upload.h"
#include <atomic>
#include <functional>
#include <memory>
#include <string>

namespace nacre::render {

struct Options {
    Layers layers;
    Crop crop; // empty: the whole image
    bool generic = false;
    bool exact = false;           // the same bits on every device
    double error = 0;             // > 0: adaptive, until this relative error is reached (allocation.h)
    double seconds = 0;           // > 0: ends with the first launch after so many seconds of the kernels
    bool profile = false;         // kernels that count what is in shared/counters.h under PROFILE_LIST
    std::string definitions{};    // for benches: -D options of what kernels leave to the compiler under #ifndef
    Timeline *timeline = nullptr; // gets what is done from here on, if there is one; must outlive the session
};

/// How far a render is.
struct Progress {
    std::uint64_t samples = 0, wanted = 0; // of all pixels; adaptive: as far as it is known what will be wanted
    double seconds = 0;                    // since the first launch
    double sampling = 0;                   // of them, seconds of the kernels alone
    double until = 0;                      // Options::seconds
    std::uint64_t rays = 0;
};

/// One scene on one device, from upload to picture. Not for more than one thread.
class Session {
  public:
    /// Uploads and compiles. Throws Error{Exit::device} or Error{Exit::input}.
    Session(device::Device device, const scene::Scene &scene, const Options &options);
    ~Session();

    /// Takes samples [0, spp) of every pixel; adaptive, at most so many, one half of them with a scrambling of its own.
    /// `report` is called after every launch (every 50-200 ms); `stop` ends
    /// after the current one, and the picture is then of what there is. Returns false only if `stop` ended it.
    bool render(std::uint32_t spp, const std::function<void(const Progress &)> &report = {},
                const std::atomic<bool> *stop = nullptr);

    io::Picture picture() const;
    Statistics statistics() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl;
};

} // namespace nacre::render
