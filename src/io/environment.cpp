#include "base/error.h"
#include "io/image.h"
#include "io/pixel_reader.h"
#include "io/srgb.h"
#include <algorithm>
#include <cmath>

namespace nacre::io {

void load_environment(const std::filesystem::path &file, scene::Light &light) {
    const std::string name = file.string();
    PixelReader reader(name);
    const int read = reader.channels() < 3 ? 1 : 3;
    std::vector<float> pixels;
    pixels.reserve(std::size_t(reader.width()) * reader.height() * 3);
    std::size_t bad = 0;
    reader.read(read, [&](std::span<const float> values) {
        for (std::size_t i = 0; i < values.size(); i += std::size_t(read)) {
            bool good = true;
            for (int c = 0; c < 3; ++c) {
                const float value = values[i + std::size_t(std::min(c, read - 1))];
                good = good && std::isfinite(value) && value >= 0;
                pixels.push_back(reader.integers() ? float(srgb_to_linear(value)) : value);
            }
            bad += !good;
        }
    });
    // Not mended here: a light that is silently not the one in the file is worse than a message.
    if (bad) {
        input_error(name,
                    "{} of its {} pixels are negative, infinite or not a number, which no light is: mend it, for "
                    "example with oiiotool IN --fixnan box3 --clamp:min=0 -o OUT",
                    bad, pixels.size() / 3);
    }
    light.kind = shared::LIGHT_ENVIRONMENT_IMAGE;
    light.image_name = name;
    light.width = std::uint32_t(reader.width());
    light.height = std::uint32_t(reader.height());
    light.pixels = std::move(pixels);
}

} // namespace nacre::io
