#include "cli/cli.h"
#include <OpenImageIO/imageio.h>
#include <algorithm>

namespace nacre {

std::vector<std::string> Cli::small_render(const std::string &scene, const std::string &name,
                                           const std::vector<std::string> &more) const {
    std::vector<std::string> arguments{"render", scene, "-o", path(name)};
    for (const auto &[option, value] : {std::pair{"--size", "16x12"}, {"--spp", "1"}})
        if (std::find(more.begin(), more.end(), option) == more.end())
            arguments.insert(arguments.end(), {option, value});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

std::optional<PictureFile> read_picture(const std::filesystem::path &file) {
    const auto input = OIIO::ImageInput::open(file.string());
    if (!input) return {};
    const OIIO::ImageSpec &spec = input->spec();
    PictureFile picture{spec.width,       spec.height,       spec.x, spec.y, spec.full_width,
                        spec.full_height, spec.channelnames, {},     {}};
    for (const auto &attribute : spec.extra_attribs)
        picture.metadata[attribute.name().string()] = attribute.get_string();
    picture.pixels.resize(std::size_t(spec.width) * std::size_t(spec.height) * std::size_t(spec.nchannels));
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, picture.pixels.data())) return {};
    return picture;
}

void expect_error(const Outcome &outcome, int code, const std::string &text) {
    EXPECT_EQ(outcome.code, code) << "signal " << outcome.signal << "\n" << outcome.err;
    EXPECT_EQ(outcome.err.rfind("nacre: error: ", 0), 0u) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_NE(outcome.err.find(text), std::string::npos) << "no '" << text << "' in: " << outcome.err;
    EXPECT_EQ(outcome.out, "");
}

} // namespace nacre
