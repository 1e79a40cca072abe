#pragma once
#include "io/ply_header.h"

namespace nacre::io {

/// The numbers of a PLY file after its header, one after the other, whatever the format.
class PlyBody {
  public:
    PlyBody(const std::string &bytes, const PlyHeader &header, const std::string &subject)
        : bytes(bytes), subject(subject), format(header.format), offset(header.size) {}

    /// The next number. Throws Error{Exit::input} where the file ends or (ASCII) has no number.
    double next(PlyType type);

    /// A list's length. Throws where the rest of the file cannot hold it.
    std::size_t next_count(PlyType count_type, PlyType item_type);

    /// Throws where the rest of the file cannot hold `count` of an element: nothing is allocated for a false count.
    void expect(const PlyElement &element) const;

  private:
    double next_ascii();
    double next_binary(PlyType type);

    const std::string &bytes, &subject;
    PlyHeader::Format format;
    std::size_t offset;
};

} // namespace nacre::io
