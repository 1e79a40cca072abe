#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace nacre::io {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
    std::string name;
    bool list = false;
    PlyType count_type = PlyType::uint8; // of a list
    PlyType type = PlyType::float32;
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    enum class Format { ascii, little_endian, big_endian } format = Format::ascii;
    std::vector<PlyElement> elements;
    std::size_t size = 0; // bytes of the header, the body follows
};

std::size_t size_of(PlyType type);

/// Reads the header of `bytes`. Throws Error{Exit::input} with the line.
PlyHeader parse_ply_header(const std::string &bytes, const std::string &subject);

} // namespace nacre::io
