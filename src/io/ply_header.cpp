#include "io/ply_header.h"
#include "base/error.h"
#include <map>
#include <sstream>

namespace nacre::io {

namespace {

// The format has two names for each type.
const std::map<std::string, PlyType> type_names{
    {"char", PlyType::int8},       {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},     {"short", PlyType::int16},     {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},   {"uint16", PlyType::uint16},   {"int", PlyType::int32},
    {"int32", PlyType::int32},     {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
    {"float", PlyType::float32},   {"float32", PlyType::float32}, {"double", PlyType::float64},
    {"float64", PlyType::float64},
};

const std::map<std::string, PlyHeader::Format> format_names{
    {"ascii", PlyHeader::Format::ascii},
    {"binary_little_endian", PlyHeader::Format::little_endian},
    {"binary_big_endian", PlyHeader::Format::big_endian},
};

class HeaderParser {
  public:
    HeaderParser(const std::string &bytes, const std::string &subject) : bytes(bytes), subject(subject) {}

    PlyHeader parse() {
        if (next_line() != "ply") fail("does not begin with 'ply'");
        bool has_format = false;
        while (true) {
            std::istringstream words(next_line());
            std::string keyword;
            words >> keyword;
            if (keyword == "end_header") break;
            if (keyword == "format") {
                format(words);
                has_format = true;
            } else if (keyword == "element") {
                element(words);
            } else if (keyword == "property") {
                property(words);
            } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
                fail("unknown keyword '" + keyword + "'");
            }
        }
        if (!has_format) fail("has no format");
        header.size = offset;
        return header;
    }

  private:
    [[noreturn]] void fail(const std::string &message) const {
        input_error(subject, "PLY header, line {}: {}", line, message);
    }

    std::string next_line() {
        ++line;
        const std::size_t end = bytes.find('\n', offset);
        if (end == std::string::npos) fail("the header does not end");
        std::string text = bytes.substr(offset, end - offset);
        if (!text.empty() && text.back() == '\r') text.pop_back();
        offset = end + 1;
        return text;
    }

    void format(std::istringstream &words) {
        std::string name, version;
        words >> name >> version;
        const auto found = format_names.find(name);
        if (found == format_names.end() || version != "1.0") fail("unknown format '" + name + " " + version + "'");
        header.format = found->second;
    }

    void element(std::istringstream &words) {
        PlyElement element;
        long long count = -1;
        if (!(words >> element.name >> count) || count < 0) fail("an element needs a name and a count");
        element.count = static_cast<std::size_t>(count);
        header.elements.push_back(element);
    }

    PlyType type(std::istringstream &words) const {
        std::string name;
        words >> name;
        const auto found = type_names.find(name);
        if (found == type_names.end()) fail("unknown type '" + name + "'");
        return found->second;
    }

    void property(std::istringstream &words) {
        if (header.elements.empty()) fail("a property before the first element");
        PlyProperty property;
        const std::streampos start = words.tellg();
        std::string word;
        words >> word;
        property.list = word == "list";
        if (property.list)
            property.count_type = type(words);
        else
            words.seekg(start);
        property.type = type(words);
        if (!(words >> property.name)) fail("a property without a name");
        header.elements.back().properties.push_back(property);
    }

    const std::string &bytes, &subject;
    PlyHeader header;
    std::size_t offset = 0;
    int line = 0;
};

} // namespace

std::size_t size_of(PlyType type) {
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<int>(type)];
}

PlyHeader parse_ply_header(const std::string &bytes, const std::string &subject) {
    return HeaderParser(bytes, subject).parse();
}

} // namespace nacre::io
