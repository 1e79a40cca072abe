#include "sheet/text.h"
#include "base/error.h"
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

namespace nacre::sheet {
namespace {

constexpr const char *font = "DejaVuSans.ttf"; // OpenImageIO looks for it in the system's folders of fonts

} // namespace

int text_width(const std::string &text, int size) {
    const OIIO::ROI box = OIIO::ImageBufAlgo::text_size(text, size, font);
    return box.defined() ? box.xend : 0;
}

void draw_text(io::Picture &picture, int x, int y, const std::string &text, int size,
               const std::array<float, 3> &color) {
    if (text.empty()) return;
    const OIIO::ImageSpec spec(picture.width, picture.height, int(picture.channels.size()), OIIO::TypeDesc::FLOAT);
    OIIO::ImageBuf target(spec, picture.pixels.data()); // draws in place
    if (!OIIO::ImageBufAlgo::render_text(target, x, y, text, size, font, color))
        throw Error(
            Exit::failed, "captions",
            fmt::format("OpenImageIO cannot draw text ({}); it needs the font {} (Debian: fonts-dejavu-core) and "
                        "to have been built with FreeType",
                        target.geterror(), font));
}

void check_text() {
    io::Picture picture{.width = 16, .height = 16, .channels = {"R", "G", "B"}, .pixels = {}, .metadata = {}};
    picture.pixels.resize(16 * 16 * 3);
    draw_text(picture, 0, 12, "x", 12, {1, 1, 1});
}

} // namespace nacre::sheet
