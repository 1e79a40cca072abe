#include "base/error.h"
#include "io/atomic_file.h"
#include "io/image.h"
#include "io/srgb.h"
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <cmath>
#include <exception>

namespace nacre::io {
namespace {

// Where OpenImageIO's encoders write to. They lose errors (OpenEXR writes its last table in a destructor), so the first
// one is kept here and raised afterwards.
class Sink : public OIIO::Filesystem::IOProxy {
  public:
    explicit Sink(const std::filesystem::path &path) : IOProxy(path.string(), Write), file(path) {}
    const char *proxytype() const override { return "nacre"; }
    bool seek(int64_t offset) override {
        m_pos = offset;
        return true;
    }
    size_t write(const void *bytes, size_t size) override {
        if (failure) return 0;
        try {
            file.write(bytes, size, size_t(m_pos));
        } catch (...) {
            failure = std::current_exception(); // not thrown through the encoders: they are partly C
            return 0;
        }
        m_pos += int64_t(size);
        end = std::max(end, size_t(m_pos));
        return size;
    }
    size_t size() const override { return end; }
    void check() const {
        if (failure) std::rethrow_exception(failure);
    }
    void commit() { file.commit(); }

  private:
    AtomicFile file;
    std::exception_ptr failure;
    size_t end = 0;
};

// What the eye sees over black: colour is premultiplied and an environment has colour where alpha is 0, so neither
// alpha nor a division by it belongs in the PNG. Rounded to the nearest code, no dither: equal renders are equal files.
std::vector<unsigned char> to_srgb8(const Picture &picture, double exposure) {
    const std::size_t channels = picture.channels.size();
    const double scale = std::exp2(exposure);
    std::vector<unsigned char> codes;
    codes.reserve(picture.pixels.size() / channels * 3);
    for (std::size_t i = 0; i < picture.pixels.size(); i += channels) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double value = picture.pixels[i + (channels < 3 ? 0 : c)] * scale;
            // `value > 0` is false for NaN too, which has no code: black, and the statistics count it.
            const double shown = value > 0 ? std::min(value, 1.0) : 0;
            codes.push_back(static_cast<unsigned char>(linear_to_srgb(shown) * 255 + 0.5));
        }
    }
    return codes;
}

OIIO::ImageSpec exr_spec(const Picture &picture) {
    OIIO::ImageSpec spec(picture.width, picture.height, int(picture.channels.size()), OIIO::TypeDesc::FLOAT);
    spec.channelnames = picture.channels;
    spec.x = picture.crop_x;
    spec.y = picture.crop_y;
    spec.full_width = picture.full_width > 0 ? picture.full_width : picture.width;
    spec.full_height = picture.full_height > 0 ? picture.full_height : picture.height;
    spec.attribute("compression", "zip");
    return spec;
}

OIIO::ImageSpec png_spec(const Picture &picture) {
    OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    return spec;
}

} // namespace

void write_picture(const std::filesystem::path &file, const Picture &picture, double exposure) {
    std::string kind = file.extension().string();
    std::transform(kind.begin(), kind.end(), kind.begin(), [](unsigned char c) { return std::tolower(c); });
    if (kind != ".exr" && kind != ".png")
        throw Error(Exit::usage, file.string(), "a picture is written as .exr or .png: give it one of these endings");

    const bool exr = kind == ".exr";
    OIIO::ImageSpec spec = exr ? exr_spec(picture) : png_spec(picture);
    for (const auto &[key, value] : picture.metadata) spec.attribute("nacre:" + key, value);

    Sink sink(file);
    const auto output = OIIO::ImageOutput::create(kind.substr(1), &sink);
    bool ok = output && output->open(file.string(), spec);
    if (ok && exr) ok = output->write_image(OIIO::TypeDesc::FLOAT, picture.pixels.data());
    if (ok && !exr) ok = output->write_image(OIIO::TypeDesc::UINT8, to_srgb8(picture, exposure).data());
    ok = ok && output->close();
    sink.check();
    if (!ok)
        throw Error(Exit::output, file.string(),
                    "cannot be written: " + (output ? output->geterror() : OIIO::geterror()));
    sink.commit();
}

} // namespace nacre::io
