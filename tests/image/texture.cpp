// What a texture file says and what the kernels then read are the same colours.
#include "base/error.h"
#include "io/image.h"
#include "oiio_write.h"
#include "scratch.h"
#include <Imath/half.h>
#include <cmath>
#include <limits>

namespace nacre {
namespace {

using io::ColorSpace;

class TextureFile : public Scratch {
  protected:
    static float texel(const scene::Image &image, std::size_t i) {
        Imath::half value;
        value.setBits(image.halves.at(i));
        return value;
    }
    static std::uint16_t half_bits(double value) { return Imath::half(float(value)).bits(); }
    void expect_refused(const std::filesystem::path &file, const std::string &word) {
        try {
            io::load_texture(file, ColorSpace::srgb);
            FAIL() << "was read";
        } catch (const Error &error) {
            EXPECT_EQ(error.code, Exit::input);
            EXPECT_NE(std::string(error.what()).find(file.filename().string()), std::string::npos) << error.what();
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
        }
    }
};

TEST_F(TextureFile, EightBitColoursFollowTheCurveOfTheStandard) {
    std::vector<unsigned char> codes;
    for (int code = 0; code < 256; ++code) codes.insert(codes.end(), 3, static_cast<unsigned char>(code));
    oiio_write(folder / "ramp.png", 16, 16, 3, OIIO::TypeDesc::UINT8, codes);
    const scene::Image image = io::load_texture(folder / "ramp.png", ColorSpace::srgb);
    ASSERT_EQ(image.channels, 4u);
    ASSERT_EQ(image.halves.size(), 16u * 16 * 4);
    for (int code = 0; code < 256; ++code) {
        const double s = code / 255.0; // IEC 61966-2-1
        const double linear = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
        for (int c = 0; c < 3; ++c) EXPECT_EQ(image.halves[std::size_t(code * 4 + c)], half_bits(linear)) << code;
        EXPECT_EQ(texel(image, std::size_t(code * 4 + 3)), 1.0f);
    }
}

TEST_F(TextureFile, LinearColoursStayAsTheyAreRoundedToTheNearestHalf) {
    std::vector<std::uint16_t> codes;
    for (unsigned i = 0; i < 4096; ++i) codes.push_back(std::uint16_t(i * 16));
    oiio_write(folder / "linear.png", 64, 64, 1, OIIO::TypeDesc::UINT16, codes);
    const scene::Image image = io::load_texture(folder / "linear.png", ColorSpace::linear);
    ASSERT_EQ(image.channels, 1u);
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const double value = codes[i] / 65535.0;
        const double step = std::ldexp(1.0, std::max(std::ilogb(std::max(value, 1e-9)), -14) - 10);
        EXPECT_LE(std::abs(texel(image, i) - value), step * 0.5000001) << codes[i];
    }
}

TEST_F(TextureFile, ChannelsBecomeOneOrFour) {
    oiio_write<unsigned char>(folder / "grey_alpha.png", 2, 1, 2, OIIO::TypeDesc::UINT8, {255, 10, 0, 200});
    const scene::Image grey = io::load_texture(folder / "grey_alpha.png", ColorSpace::linear);
    EXPECT_EQ(grey.channels, 1u);
    EXPECT_EQ(texel(grey, 0), 1.0f);
    EXPECT_EQ(texel(grey, 1), 0.0f);

    // A transparent texel keeps its colour: it is the colour of a surface, not of a composite.
    oiio_write<unsigned char>(folder / "rgba.png", 1, 1, 4, OIIO::TypeDesc::UINT8, {255, 102, 0, 51}, [] {
        OIIO::ImageSpec spec;
        spec.attribute("oiio:UnassociatedAlpha", 1);
        return spec;
    }());
    const scene::Image rgba = io::load_texture(folder / "rgba.png", ColorSpace::linear);
    EXPECT_EQ(rgba.channels, 4u);
    EXPECT_EQ(rgba.halves, (std::vector<std::uint16_t>{half_bits(1), half_bits(0.4), 0, half_bits(0.2)}));
}

TEST_F(TextureFile, FirstRowIsTheTop) {
    oiio_write<unsigned char>(folder / "top.png", 1, 2, 1, OIIO::TypeDesc::UINT8, {255, 0});
    EXPECT_EQ(texel(io::load_texture(folder / "top.png", ColorSpace::linear), 0), 1.0f);
}

TEST_F(TextureFile, FloatsAreLinearAndClampedToWhatAHalfHolds) {
    oiio_write<float>(folder / "big.exr", 4, 1, 1, OIIO::TypeDesc::FLOAT, {0.5f, 1e9f, -1e9f, INFINITY});
    const scene::Image image = io::load_texture(folder / "big.exr", ColorSpace::srgb);
    EXPECT_EQ(texel(image, 0), 0.5f);
    EXPECT_EQ(texel(image, 1), 65504.0f);
    EXPECT_EQ(texel(image, 2), -65504.0f);
    EXPECT_EQ(texel(image, 3), 65504.0f);
}

TEST_F(TextureFile, TiledFilesAreReadToTheirEdges) {
    std::vector<float> values(70 * 50);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = float(i % 1000);
    OIIO::ImageSpec spec;
    spec.tile_width = spec.tile_height = 32;
    oiio_write(folder / "tiled.exr", 70, 50, 1, OIIO::TypeDesc::FLOAT, values, spec);
    const scene::Image image = io::load_texture(folder / "tiled.exr", ColorSpace::linear);
    ASSERT_EQ(image.halves.size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) ASSERT_EQ(texel(image, i), values[i]) << i;
}

TEST_F(TextureFile, IsTheSameFromMemory) {
    for (const char *file : {"a.png", "a.jpg", "a.exr", "a.tif"}) {
        std::vector<unsigned char> codes(32 * 32 * 3);
        for (std::size_t i = 0; i < codes.size(); ++i) codes[i] = static_cast<unsigned char>(i * 7 % 256);
        oiio_write(folder / file, 32, 32, 3, OIIO::TypeDesc::UINT8, codes);
        const std::string bytes = bytes_of(folder / file);
        const auto image = io::decode_texture({reinterpret_cast<const unsigned char *>(bytes.data()), bytes.size()},
                                              "image 0", ColorSpace::srgb);
        EXPECT_EQ(image.halves, io::load_texture(folder / file, ColorSpace::srgb).halves) << file;
        EXPECT_EQ(image.name, "image 0");
    }
}

TEST_F(TextureFile, NonsenseIsRefusedWithItsName) {
    put(folder / "text.png", "this is no picture");
    put(folder / "empty.exr", "");
    oiio_write<float>(folder / "nan.exr", 2, 1, 1, OIIO::TypeDesc::FLOAT, {1, NAN});
    oiio_write<unsigned char>(folder / "wide.png", 65537, 1, 1, OIIO::TypeDesc::UINT8,
                              std::vector<unsigned char>(65537));
    expect_refused(folder / "text.png", "cannot be read");
    expect_refused(folder / "empty.exr", "cannot be read");
    expect_refused(folder / "missing.png", "no such");
    expect_refused(folder / "nan.exr", "1 of its values");
    expect_refused(folder / "wide.png", "65537");
    expect_refused(folder, "folder");
    const std::string bytes = bytes_of(folder / "text.png");
    EXPECT_THROW(io::decode_texture({reinterpret_cast<const unsigned char *>(bytes.data()), bytes.size()}, "image 3",
                                    ColorSpace::srgb),
                 Error);
}

TEST_F(TextureFile, CutShortIsRefused) {
    std::vector<unsigned char> codes(200 * 200 * 3);
    for (std::size_t i = 0; i < codes.size(); ++i) codes[i] = static_cast<unsigned char>(i * i % 251);
    for (const char *file : {"a.png", "a.exr", "a.tif"}) {
        oiio_write(folder / file, 200, 200, 3, OIIO::TypeDesc::UINT8, codes);
        const std::string bytes = bytes_of(folder / file);
        put(folder / file, bytes.substr(0, bytes.size() / 2));
        expect_refused(folder / file, "cannot be read");
    }
}

} // namespace
} // namespace nacre
