#pragma once
#include "io/image.h"
#include <array>
#include <string>

namespace nacre::sheet {

/// Pixels of a line of text.
int text_width(const std::string &text, int size);

/// Draws a line of text into a picture whose first three channels are linear RGB; (x, y) is the left end of its
/// baseline. What is beyond the picture's edge is cut off.
void draw_text(io::Picture &picture, int x, int y, const std::string &text, int size,
               const std::array<float, 3> &color);

/// Throws Error{Exit::failed} where text cannot be drawn: no such font, or OpenImageIO was built without FreeType.
void check_text();

} // namespace nacre::sheet
