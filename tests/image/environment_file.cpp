// The light in the file is the light in the scene, or a message.
#include "base/error.h"
#include "io/image.h"
#include "oiio_write.h"
#include "scratch.h"
#include <cmath>

namespace nacre {
namespace {

class EnvironmentFile : public Scratch {};

TEST_F(EnvironmentFile, FloatsArriveUnchanged) {
    std::vector<float> values(16 * 8 * 3);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = float(i) * 123.25f;
    values[5] = 1e30f; // beyond any half
    oiio_write(folder / "sky.exr", 16, 8, 3, OIIO::TypeDesc::FLOAT, values);
    scene::Light light;
    io::load_environment(folder / "sky.exr", light);
    EXPECT_EQ(light.kind, shared::LIGHT_ENVIRONMENT_IMAGE);
    EXPECT_EQ(light.width, 16u);
    EXPECT_EQ(light.height, 8u);
    EXPECT_EQ(light.image_name, (folder / "sky.exr").string());
    EXPECT_EQ(light.pixels, values);
}

TEST_F(EnvironmentFile, GreyIsRepeatedAndAlphaIsNotLight) {
    oiio_write<float>(folder / "grey.exr", 2, 1, 1, OIIO::TypeDesc::FLOAT, {1, 2});
    oiio_write<float>(folder / "rgba.exr", 1, 1, 4, OIIO::TypeDesc::FLOAT, {1, 2, 3, 0.5f});
    scene::Light light;
    io::load_environment(folder / "grey.exr", light);
    EXPECT_EQ(light.pixels, (std::vector<float>{1, 1, 1, 2, 2, 2}));
    io::load_environment(folder / "rgba.exr", light);
    EXPECT_EQ(light.pixels, (std::vector<float>{1, 2, 3}));
}

TEST_F(EnvironmentFile, EightBitPicturesAreLinearised) {
    oiio_write<unsigned char>(folder / "sky.png", 1, 1, 3, OIIO::TypeDesc::UINT8, {0, 188, 255});
    scene::Light light;
    io::load_environment(folder / "sky.png", light);
    EXPECT_EQ(light.pixels[0], 0);
    EXPECT_NEAR(light.pixels[1], std::pow((188 / 255.0 + 0.055) / 1.055, 2.4), 1e-6);
    EXPECT_EQ(light.pixels[2], 1);
}

TEST_F(EnvironmentFile, WhatNoLightIsIsRefusedAndCounted) {
    for (const float bad : {-0.001f, float(NAN), float(INFINITY)}) {
        std::vector<float> values(4 * 4 * 3, 1);
        values[7] = values[8] = values[30] = bad; // two pixels
        oiio_write(folder / "bad.exr", 4, 4, 3, OIIO::TypeDesc::FLOAT, values);
        scene::Light light;
        light.image_name = "before";
        try {
            io::load_environment(folder / "bad.exr", light);
            FAIL() << bad << " was read";
        } catch (const Error &error) {
            EXPECT_EQ(error.code, Exit::input);
            EXPECT_NE(std::string(error.what()).find("2 of its 16 pixels"), std::string::npos) << error.what();
        }
        EXPECT_EQ(light.image_name, "before");
    }
}

TEST_F(EnvironmentFile, APartOfAPictureIsRefused) {
    io::Picture crop;
    crop.width = crop.height = 2;
    crop.channels = {"R", "G", "B"};
    crop.pixels.assign(12, 1);
    crop.full_width = crop.full_height = 4;
    io::write_picture(folder / "crop.exr", crop, 0);
    scene::Light light;
    EXPECT_THROW(io::load_environment(folder / "crop.exr", light), Error);
}

} // namespace
} // namespace nacre
