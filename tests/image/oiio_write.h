#pragma once
#include <OpenImageIO/imageio.h>
#include <filesystem>
#include <vector>

namespace nacre {

/// Writes a test picture with OpenImageIO alone, so that our reader is not tested against our writer.
template <typename T>
void oiio_write(const std::filesystem::path &file, int width, int height, int channels, OIIO::TypeDesc type,
                const std::vector<T> &values, OIIO::ImageSpec spec = {}) {
    spec.width = spec.full_width = width;
    spec.height = spec.full_height = height;
    spec.nchannels = channels;
    spec.set_format(type);
    spec.default_channel_names();
    const auto out = OIIO::ImageOutput::create(file.string());
    if (!out || !out->open(file.string(), spec) || !out->write_image(OIIO::BaseTypeFromC<T>::value, values.data()) ||
        !out->close())
        throw std::runtime_error("test picture " + file.string() + ": " + (out ? out->geterror() : OIIO::geterror()));
}

} // namespace nacre
