#pragma once
#include "scene/scene.h"
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace nacre::io {

enum class ColorSpace { srgb, linear };

/// Reads a texture (any format OpenImageIO knows) into linear half floats: 1 channel stays 1, all else becomes RGBA.
/// `space` says what integers mean; floating-point files (EXR, HDR) are linear whatever it says. At most 65,536 pixels
/// a side. Throws Error{Exit::input} naming the file.
scene::Image load_texture(const std::filesystem::path &file, ColorSpace space);

/// The same for a picture that is inside another file (GLB); `name` is for messages.
scene::Image decode_texture(std::span<const unsigned char> bytes, const std::string &name, ColorSpace space);

/// Makes `light` a latitude-longitude environment: linear RGB floats (3 per pixel), row 0 at the top. Refuses pixels
/// that are negative, infinite or not a number. Throws Error{Exit::input}.
void load_environment(const std::filesystem::path &file, scene::Light &light);

/// A finished picture: planes of float, each with its channel names ("R", "G", "B", "A", "albedo.R", "depth.Z", …).
struct Picture {
    int width = 0, height = 0;
    std::vector<std::string> channels;
    std::vector<float> pixels;                                   // width * height * channels.size(), row 0 at the top
    std::map<std::string, std::string> metadata;                 // written as "nacre:KEY"
    int crop_x = 0, crop_y = 0, full_width = 0, full_height = 0; // data window within the full image
};

/// Writes `picture` as float EXR, or as 8-bit sRGB PNG (its first three channels, times 2^exposure; no alpha: what the
/// eye sees over black) by the extension of `file`. Goes to a temporary file beside it, is flushed to disk and renamed:
/// `file` is whole or untouched. Throws Error{Exit::output}; Error{Exit::usage} for another extension.
void write_picture(const std::filesystem::path &file, const Picture &picture, double exposure);

/// Reads an EXR back with all its channels (half ones become float) and what `metadata` was written with. Throws
/// Error{Exit::input} that names the file and what to do.
Picture read_picture(const std::filesystem::path &file);

} // namespace nacre::io
