#include "base/error.h"
#include "io/image.h"
#include <OpenImageIO/imageio.h>
#include <algorithm>

namespace nacre::io {
namespace {

std::string first_line(const std::string &text) { return text.substr(0, text.find('\n')); }

} // namespace

Picture read_picture(const std::filesystem::path &file) {
    const std::string name = file.string();
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) input_error(name, "no such picture: check the path");
    if (std::filesystem::is_directory(file, ignored)) input_error(name, "is a folder: name a picture in it");
    const auto input = OIIO::ImageInput::open(name);
    if (!input)
        input_error(name, "cannot be read as a picture ({}): check that it is whole", first_line(OIIO::geterror()));
    const OIIO::ImageSpec &spec = input->spec();
    if (std::string(input->format_name()) != "openexr" || spec.deep)
        input_error(name, "is no flat EXR: pixels have to be linear and with layers, as `nacre render -o FILE.exr` "
                          "writes them");

    Picture picture;
    picture.width = spec.width;
    picture.height = spec.height;
    picture.channels = spec.channelnames;
    picture.crop_x = spec.x - spec.full_x;
    picture.crop_y = spec.y - spec.full_y;
    picture.full_width = spec.full_width;
    picture.full_height = spec.full_height;
    const std::string ours = "nacre:";
    for (const auto &attribute : spec.extra_attribs)
        if (const std::string key = attribute.name().string(); key.rfind(ours, 0) == 0)
            picture.metadata[key.substr(ours.size())] = attribute.get_string();
    picture.pixels.resize(spec.image_pixels() * std::size_t(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, picture.pixels.data()))
        input_error(name, "cannot be read to its end ({}): the file is damaged or cut short, make it again",
                    first_line(input->geterror()));
    return picture;
}

} // namespace nacre::io
