#include "io/pixel_reader.h"
#include "base/error.h"
#include <algorithm>
#include <filesystem>
#include <vector>

namespace nacre::io {
namespace {

constexpr int LARGEST_SIDE = 65536;

// Colour that alpha has been multiplied into is no colour of a surface: keep it as the file has it.
OIIO::ImageSpec open_options() {
    OIIO::ImageSpec options;
    options.attribute("oiio:UnassociatedAlpha", 1);
    return options;
}

std::string first_line(const std::string &text) { return text.substr(0, text.find('\n')); }

} // namespace

PixelReader::PixelReader(const std::string &file) : name(file) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) input_error(name, "no such picture: check the path");
    if (std::filesystem::is_directory(file, ignored)) input_error(name, "is a folder: name a picture in it");
    const OIIO::ImageSpec options = open_options();
    input = OIIO::ImageInput::open(file, &options);
    check();
}

PixelReader::PixelReader(std::span<const unsigned char> bytes, const std::string &name)
    : name(name), memory(std::make_unique<OIIO::Filesystem::IOMemReader>(bytes.data(), bytes.size())) {
    const OIIO::ImageSpec options = open_options();
    // Not `open`, which in 2.4 forgets the bytes after it has found out by them which format they are.
    input = OIIO::ImageInput::create("picture", false, &options, memory.get());
    OIIO::ImageSpec found;
    if (input && input->set_ioproxy(memory.get()) && !input->open("picture", found, options)) {
        input_error(name, "cannot be read as a picture ({}): check that it is whole, or convert it to PNG or EXR",
                    first_line(input->geterror()));
    }
    check();
}

void PixelReader::check() {
    if (!input) {
        input_error(name, "cannot be read as a picture ({}): check that it is whole, or convert it to PNG or EXR",
                    first_line(OIIO::geterror()));
    }
    const OIIO::ImageSpec &s = spec();
    if (s.width < 1 || s.height < 1 || s.nchannels < 1 || s.depth > 1 || s.deep)
        input_error(name, "holds no flat picture (or is deep or a volume): convert it to PNG or EXR");
    if (s.width > LARGEST_SIDE || s.height > LARGEST_SIDE)
        input_error(name, "is {} x {} pixels, at most {} a side can be used: scale it down", s.width, s.height,
                    LARGEST_SIDE);
    if (s.x != s.full_x || s.y != s.full_y || s.width != s.full_width || s.height != s.full_height)
        input_error(name,
                    "holds a part of a picture (data window unlike display window): fill it out, for example with "
                    "oiiotool IN --croptofull -o OUT");
}

void PixelReader::read(int channels, const std::function<void(std::span<const float>)> &consume) {
    const OIIO::ImageSpec &s = spec();
    const bool tiled = s.tile_width > 0;
    const int rows = tiled ? s.tile_height : 64;
    std::vector<float> strip(std::size_t(rows) * s.width * channels);
    for (int y = 0; y < s.height; y += rows) {
        const int end = std::min(y + rows, s.height);
        const bool ok = tiled ? input->read_tiles(0, 0, s.x, s.x + s.width, s.y + y, s.y + end, 0, 1, 0, channels,
                                                  OIIO::TypeDesc::FLOAT, strip.data())
                              : input->read_scanlines(0, 0, s.y + y, s.y + end, 0, 0, channels, OIIO::TypeDesc::FLOAT,
                                                      strip.data());
        if (!ok) {
            input_error(name, "cannot be read beyond row {} of {} ({}): the file is damaged or cut short, get it again",
                        y, s.height, first_line(input->geterror()));
        }
        consume({strip.data(), std::size_t(end - y) * s.width * channels});
    }
}

} // namespace nacre::io
