#include "base/error.h"
#include "io/image.h"
#include "io/pixel_reader.h"
#include "io/srgb.h"
#include <Imath/half.h>
#include <algorithm>
#include <array>
#include <cmath>

namespace nacre::io {
namespace {

// Of every 16-bit code; 8-bit codes are among them (code * 257). A power per texel would take seconds on large files.
const std::array<float, 65536> &srgb_table() {
    static const auto table = [] {
        std::array<float, 65536> values{};
        for (std::size_t code = 0; code < values.size(); ++code) values[code] = float(srgb_to_linear(code / 65535.0));
        return values;
    }();
    return table;
}

std::uint16_t to_half(float value) {
    // Half floats end at 65504. A texel beyond is clamped, not made infinite: infinity would spread over the picture.
    // It costs nothing that is meant as a colour, a roughness or a normal.
    return Imath::half(std::clamp(value, -65504.0f, 65504.0f)).bits();
}

scene::Image decode(PixelReader &reader, const std::string &name, ColorSpace space) {
    scene::Image image;
    image.name = name;
    image.width = std::uint32_t(reader.width());
    image.height = std::uint32_t(reader.height());
    const int read = reader.channels() <= 2 ? 1 : std::min(reader.channels(), 4); // of grey + alpha: the grey
    image.channels = read == 1 ? 1 : 4;
    image.halves.reserve(std::size_t(image.width) * image.height * image.channels);

    const bool curved = space == ColorSpace::srgb && reader.integers();
    const std::uint16_t opaque = to_half(1);
    std::size_t not_a_number = 0;
    reader.read(read, [&](std::span<const float> values) {
        for (std::size_t i = 0; i < values.size(); i += std::size_t(read)) {
            for (int c = 0; c < read; ++c) {
                float value = values[i + std::size_t(c)];
                not_a_number += std::isnan(value);
                if (curved && c < 3) value = srgb_table()[std::size_t(std::lround(value * 65535.0f))];
                image.halves.push_back(to_half(value));
            }
            if (read == 3) image.halves.push_back(opaque);
        }
    });
    if (not_a_number) {
        input_error(name,
                    "{} of its values are not a number: mend it, for example with oiiotool IN --fixnan box3 -o OUT",
                    not_a_number);
    }
    return image;
}

} // namespace

scene::Image load_texture(const std::filesystem::path &file, ColorSpace space) {
    PixelReader reader(file.string());
    return decode(reader, file.string(), space);
}

scene::Image decode_texture(std::span<const unsigned char> bytes, const std::string &name, ColorSpace space) {
    PixelReader reader(bytes, name);
    return decode(reader, name, space);
}

} // namespace nacre::io
