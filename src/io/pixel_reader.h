#pragma once
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace nacre::io {

/// Pixels of a picture file (its first sub-image) as floats, a strip of rows at a time, so that a large texture never
/// lies in memory twice. Everything throws Error{Exit::input} that names the picture and what to do.
class PixelReader {
  public:
    /// Opens a file of any format OpenImageIO knows; at most 65,536 pixels a side, not cropped.
    explicit PixelReader(const std::string &file);
    /// The same for a file that lies in memory; `name` is for messages.
    PixelReader(std::span<const unsigned char> bytes, const std::string &name);

    int width() const { return spec().width; }
    int height() const { return spec().height; }
    int channels() const { return spec().nchannels; }
    /// Integers hold encoded values (sRGB, unless the scene says otherwise), floating point is linear.
    bool integers() const { return !spec().format.is_floating_point(); }

    /// Calls `consume` with the values of each strip in turn, from the top: whole rows of the first `channels`
    /// channels, interleaved. Integers are scaled to 0..1.
    void read(int channels, const std::function<void(std::span<const float>)> &consume);

  private:
    const OIIO::ImageSpec &spec() const { return input->spec(); }
    void check();

    std::string name;
    std::unique_ptr<OIIO::Filesystem::IOMemReader> memory; // outlives `input`, which reads from it
    std::unique_ptr<OIIO::ImageInput> input;
};

} // namespace nacre::io
