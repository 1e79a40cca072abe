#include "io/glb.h"
#include "base/error.h"
#include <cstdint>

namespace nacre::io {

namespace {

// Of the glTF 2.0 specification, section 4 (GLB File Format); all numbers are little-endian.
constexpr std::uint32_t magic = 0x46546C67, version = 2, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;

std::uint32_t number_at(std::string_view bytes, std::size_t offset) {
    std::uint32_t value = 0;
    for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(bytes[offset + i]);
    return value;
}

void put_number(std::string &bytes, std::size_t value) {
    for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<char>(value >> 8 * i));
}

void put_chunk(std::string &bytes, std::uint32_t type, std::string_view content, char padding) {
    const std::size_t padded = (content.size() + 3) / 4 * 4;
    put_number(bytes, padded);
    put_number(bytes, type);
    bytes.append(content);
    bytes.append(padded - content.size(), padding);
}

} // namespace

Glb split_glb(std::string_view bytes, const std::string &subject) {
    if (bytes.size() < 12 || number_at(bytes, 0) != magic) input_error(subject, "is not a GLB file");
    if (number_at(bytes, 4) != version)
        input_error(subject, "is glTF version {}, nacre reads version 2", number_at(bytes, 4));
    const std::size_t length = number_at(bytes, 8);
    if (length > bytes.size()) input_error(subject, "is cut short: {} bytes of {}", bytes.size(), length);
    Glb parts;
    for (std::size_t offset = 12; offset + 8 <= length;) {
        const std::size_t size = number_at(bytes, offset), type = number_at(bytes, offset + 4);
        if (size > length - offset - 8) input_error(subject, "a chunk of {} bytes does not fit in the file", size);
        if (type == json_chunk && parts.json.empty()) parts.json = bytes.substr(offset + 8, size);
        if (type == binary_chunk && parts.binary.empty()) parts.binary = bytes.substr(offset + 8, size);
        offset += 8 + size;
    }
    if (parts.json.empty()) input_error(subject, "has no JSON chunk");
    return parts;
}

std::string join_glb(const Glb &parts) {
    std::string chunks;
    put_chunk(chunks, json_chunk, parts.json, ' ');
    if (!parts.binary.empty()) put_chunk(chunks, binary_chunk, parts.binary, '\0');
    std::string bytes;
    put_number(bytes, magic);
    put_number(bytes, version);
    put_number(bytes, 12 + chunks.size());
    return bytes + chunks;
}

} // namespace nacre::io
