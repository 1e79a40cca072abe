#pragma once
#include <cstdint>
#include <cstring>
#include <string>

namespace nacre {

/// `value` as bytes of a file of either byte order.
template <typename T> std::string bytes_as(T value, bool big_endian = false) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

/// A tetrahedron as PLY, with all its numbers in `format`.
inline std::string tetrahedron_ply(const std::string &format) {
    std::string ply = "ply\nformat " + format +
                      " 1.0\ncomment made by a test\nelement vertex 4\nproperty float x\nproperty double y\n"
                      "property float z\nproperty uchar red\nelement face 4\nproperty list uchar int vertex_indices\n"
                      "end_header\n";
    const double corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
    const std::int32_t faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    if (format == "ascii") {
        for (const auto &c : corners)
            ply += std::to_string(c[0]) + " " + std::to_string(c[1]) + " " + std::to_string(c[2]) + " 255\n";
        for (const auto &f : faces)
            ply += "3 " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " + std::to_string(f[2]) + "\n";
        return ply;
    }
    const bool big = format == "binary_big_endian";
    for (const auto &c : corners)
        ply += bytes_as(float(c[0]), big) + bytes_as(c[1], big) + bytes_as(float(c[2]), big) + '\xff';
    for (const auto &f : faces) ply += '\x03' + bytes_as(f[0], big) + bytes_as(f[1], big) + bytes_as(f[2], big);
    return ply;
}

inline const std::string tetrahedron_obj = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

} // namespace nacre
