// A picture that was written holds every channel and every word of metadata; one that could not be is not there.
#include "base/error.h"
#include "io/image.h"
#include "scratch.h"
#include <OpenImageIO/imageio.h>
#include <cmath>
#include <csignal>
#include <limits>
#include <sys/resource.h>

namespace nacre {
namespace {

io::Picture picture(int width, int height, std::vector<std::string> channels) {
    io::Picture p;
    p.width = width;
    p.height = height;
    p.channels = std::move(channels);
    p.pixels.resize(std::size_t(width) * height * p.channels.size());
    for (std::size_t i = 0; i < p.pixels.size(); ++i) p.pixels[i] = std::sin(float(i)) * 1000;
    return p;
}

std::vector<unsigned char> read_png(const std::filesystem::path &file, int channels) {
    const auto in = OIIO::ImageInput::open(file.string());
    if (!in || in->spec().nchannels != channels || in->spec().format != OIIO::TypeDesc::UINT8) return {};
    std::vector<unsigned char> codes(in->spec().image_pixels() * std::size_t(channels));
    in->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, codes.data());
    return codes;
}

class PictureFile : public Scratch {
  protected:
    Exit written(const std::filesystem::path &file, const io::Picture &p, std::string *message = nullptr) {
        try {
            io::write_picture(file, p, 0);
        } catch (const Error &error) {
            if (message) *message = error.what();
            return error.code;
        }
        return Exit::done;
    }
};

TEST_F(PictureFile, EveryChannelAndEveryWordComesBack) {
    // Not in EXR's own (alphabetical) order, and with values no half holds.
    io::Picture p = picture(37, 19,
                            {"R", "G", "B", "A", "albedo.R", "albedo.G", "albedo.B", "N.X", "N.Y", "N.Z", "depth.Z",
                             "variance.R", "variance.G", "variance.B", "samples", "subsurface.zero.R", "walk.steps"});
    p.pixels[3] = 1e-38f;
    p.pixels[4] = 3e38f;
    p.pixels[5] = std::numeric_limits<float>::quiet_NaN();
    p.metadata = {
        {"scene", "0123456789abcdef"}, {"device", "pthread, \"quoted\"\nand a line"}, {"seed", "18446744073709551615"}};
    io::write_picture(folder / "all.exr", p, 3);

    const auto in = OIIO::ImageInput::open((folder / "all.exr").string());
    ASSERT_TRUE(in);
    const OIIO::ImageSpec &spec = in->spec();
    ASSERT_EQ(spec.width, 37);
    ASSERT_EQ(spec.height, 19);
    ASSERT_EQ(std::size_t(spec.nchannels), p.channels.size());
    EXPECT_EQ(spec.format, OIIO::TypeDesc::FLOAT);
    for (const auto &[key, value] : p.metadata) EXPECT_EQ(spec.get_string_attribute("nacre:" + key), value);
    std::vector<float> values(p.pixels.size());
    ASSERT_TRUE(in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data()));
    const std::size_t n = p.channels.size();
    for (std::size_t c = 0; c < n; ++c) {
        const int at = spec.channelindex(p.channels[c]);
        ASSERT_GE(at, 0) << p.channels[c];
        for (std::size_t i = 0; i < p.pixels.size() / n; ++i) {
            const float want = p.pixels[i * n + c], got = values[i * n + std::size_t(at)];
            ASSERT_TRUE(want == got || (std::isnan(want) && std::isnan(got))) << p.channels[c] << " pixel " << i;
        }
    }
}

TEST_F(PictureFile, ACropKnowsItsPlace) {
    io::Picture p = picture(8, 4, {"R", "G", "B", "A"});
    p.crop_x = 3;
    p.crop_y = 5;
    p.full_width = 64;
    p.full_height = 48;
    io::write_picture(folder / "crop.exr", p, 0);
    io::write_picture(folder / "crop.png", p, 0);
    const auto in = OIIO::ImageInput::open((folder / "crop.exr").string());
    ASSERT_TRUE(in);
    const OIIO::ImageSpec &spec = in->spec();
    EXPECT_EQ((std::vector<int>{spec.x, spec.y, spec.width, spec.height}), (std::vector<int>{3, 5, 8, 4}));
    EXPECT_EQ((std::vector<int>{spec.full_x, spec.full_y, spec.full_width, spec.full_height}),
              (std::vector<int>{0, 0, 64, 48}));
    EXPECT_EQ(read_png(folder / "crop.png", 3).size(), 8u * 4 * 3);
}

TEST_F(PictureFile, PngIsSrgbRoundedToNearestWithoutAlpha) {
    io::Picture p = picture(256, 1, {"R", "G", "B", "A", "albedo.R"});
    for (int i = 0; i < 256; ++i) {
        const double s = i / 255.0;
        const double linear = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
        for (int c = 0; c < 3; ++c) p.pixels[std::size_t(i * 5 + c)] = float(linear);
        p.pixels[std::size_t(i * 5 + 3)] = i % 2 ? 0.0f : 0.3f; // no code may depend on alpha
    }
    io::write_picture(folder / "ramp.png", p, 0);
    const std::vector<unsigned char> codes = read_png(folder / "ramp.png", 3);
    ASSERT_EQ(codes.size(), 256u * 3);
    for (int i = 0; i < 256; ++i) EXPECT_EQ(codes[std::size_t(i * 3 + 1)], i);
}

TEST_F(PictureFile, PngExposureIsInStopsAndWhatHasNoCodeIsClamped) {
    io::Picture p = picture(5, 1, {"Y"});
    p.pixels = {0.25f, -1, 1e30f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()};
    io::write_picture(folder / "grey.PNG", p, 1);
    const std::vector<unsigned char> codes = read_png(folder / "grey.PNG", 3);
    ASSERT_EQ(codes.size(), 15u);
    EXPECT_EQ(codes[0], 188); // .5 is 187.5 in sRGB codes
    EXPECT_EQ(codes[1], codes[0]);
    EXPECT_EQ(codes[3], 0);
    EXPECT_EQ(codes[6], 255);
    EXPECT_EQ(codes[9], 0);
    EXPECT_EQ(codes[12], 255);
}

TEST_F(PictureFile, EqualPicturesAreEqualFiles) {
    for (const char *kind : {"exr", "png"}) {
        const io::Picture p = picture(40, 30, {"R", "G", "B", "A"});
        const auto a = folder / (std::string("a.") + kind), b = folder / (std::string("b.") + kind);
        io::write_picture(a, p, 0);
        io::write_picture(b, p, 0);
        EXPECT_EQ(bytes_of(a), bytes_of(b));
        EXPECT_FALSE(bytes_of(a).empty());
    }
}

TEST_F(PictureFile, ReplacesTheOldOneAndLeavesNothingElse) {
    put(folder / "a.exr", "old");
    std::filesystem::create_symlink(folder / "a.exr", folder / "link.exr");
    EXPECT_EQ(written(folder / "link.exr", picture(8, 8, {"R", "G", "B"})), Exit::done);
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.exr"));
    EXPECT_GT(bytes_of(folder / "a.exr").size(), 300u);
    EXPECT_EQ(files(), 2u);
}

TEST_F(PictureFile, AFullDiskLeavesTheOldPictureAndNoLitter) {
    // A limit on file sizes stands in for a full disk: the write fails half-way, and anyone may set it. Random bits, as
    // a picture that compresses well would fit.
    io::Picture p = picture(256, 256, {"R", "G", "B", "A"});
    std::uint32_t state = 1;
    for (float &value : p.pixels) value = float((state = state * 1664525u + 1013904223u)) / 4294967296.0f;
    for (const char *name : {"a.exr", "a.png"}) {
        put(folder / name, "old");
        rlimit limit{};
        getrlimit(RLIMIT_FSIZE, &limit);
        const rlimit before = limit;
        const auto handler = std::signal(SIGXFSZ, SIG_IGN);
        limit.rlim_cur = 65536;
        setrlimit(RLIMIT_FSIZE, &limit);
        std::string message;
        const Exit code = written(folder / name, p, &message);
        setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, handler);
        EXPECT_EQ(code, Exit::output);
        EXPECT_NE(message.find(name), std::string::npos) << message;
        EXPECT_NE(message.find("limit"), std::string::npos) << message;
        EXPECT_EQ(bytes_of(folder / name), "old");
        EXPECT_EQ(files(), 1u);
        EXPECT_EQ(written(folder / name, p), Exit::done) << "once there is room";
        std::filesystem::remove(folder / name);
    }
}

TEST_F(PictureFile, WhereNoFileCanBeIsAMessage) {
    const io::Picture p = picture(2, 2, {"R", "G", "B"});
    std::string message;
    EXPECT_EQ(written(folder / "no" / "such" / "a.exr", p, &message), Exit::output);
    EXPECT_NE(message.find("no folder"), std::string::npos) << message;
    EXPECT_EQ(written("/proc/a.exr", p), Exit::output);
    std::filesystem::create_directory(folder / "folder.png");
    EXPECT_EQ(written(folder / "folder.png", p, &message), Exit::output);
    EXPECT_NE(message.find("is a folder"), std::string::npos) << message;
    EXPECT_EQ(files(), 1u);
    EXPECT_EQ(written(folder / "a.jpg", p, &message), Exit::usage);
    EXPECT_NE(message.find(".exr or .png"), std::string::npos) << message;
    EXPECT_EQ(written(folder / "a", p), Exit::usage);
}

} // namespace
} // namespace nacre
