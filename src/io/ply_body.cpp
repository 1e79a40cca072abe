#include "io/ply_body.h"
#include "base/error.h"
#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace nacre::io {

namespace {

template <typename T> double as(const char *bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
}

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

} // namespace

double PlyBody::next(PlyType type) { return format == PlyHeader::Format::ascii ? next_ascii() : next_binary(type); }

double PlyBody::next_ascii() {
    while (offset < bytes.size() && is_space(bytes[offset])) ++offset;
    if (offset == bytes.size()) input_error(subject, "ends before its last element");
    const char *first = bytes.data() + offset, *last = bytes.data() + bytes.size();
    if (*first == '+') ++first; // from_chars does not take it
    double value = 0;
    const auto [end, error] = std::from_chars(first, last, value);
    // A number too large or too small for a double: infinity is refused later on, 0 is what it is.
    if (error == std::errc::result_out_of_range) value = std::strtod(std::string(first, end).c_str(), nullptr);
    if (error == std::errc::invalid_argument || (end != last && !is_space(*end))) {
        const char *word_end = std::find_if(first, last, is_space);
        input_error(subject, "byte {}: '{}' is not a number", offset,
                    std::string(first, std::min(word_end, first + 20)));
    }
    offset = end - bytes.data();
    return value;
}

double PlyBody::next_binary(PlyType type) {
    const std::size_t size = size_of(type);
    if (bytes.size() - offset < size) input_error(subject, "ends before its last element");
    char value[8];
    std::copy_n(bytes.data() + offset, size, value);
    offset += size;
    const bool little = format == PlyHeader::Format::little_endian;
    if (little != (std::endian::native == std::endian::little)) std::reverse(value, value + size);
    switch (type) {
    case PlyType::int8: return as<std::int8_t>(value);
    case PlyType::uint8: return as<std::uint8_t>(value);
    case PlyType::int16: return as<std::int16_t>(value);
    case PlyType::uint16: return as<std::uint16_t>(value);
    case PlyType::int32: return as<std::int32_t>(value);
    case PlyType::uint32: return as<std::uint32_t>(value);
    case PlyType::float32: return as<float>(value);
    case PlyType::float64: return as<double>(value);
    }
    return 0;
}

std::size_t PlyBody::next_count(PlyType count_type, PlyType item_type) {
    const double count = next(count_type);
    const std::size_t smallest = format == PlyHeader::Format::ascii ? 1 : size_of(item_type);
    if (!(count >= 0) || count != std::floor(count) || count * smallest > bytes.size() - offset)
        input_error(subject, "byte {}: a list of {} cannot be", offset, count);
    return static_cast<std::size_t>(count);
}

void PlyBody::expect(const PlyElement &element) const {
    std::size_t each = 0;
    for (const PlyProperty &property : element.properties)
        each += format == PlyHeader::Format::ascii ? 1 : size_of(property.list ? property.count_type : property.type);
    if (element.count > (bytes.size() - offset) / std::max<std::size_t>(each, 1))
        input_error(subject, "says it has {} of '{}', it is too short for that", element.count, element.name);
}

} // namespace nacre::io
