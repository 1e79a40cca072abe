#pragma once
#include "base/vector.h"
#include "io/source.h"
#include "io/tree.h"
#include <cstdint>
#include <span>

namespace nacre::io {

/// A word and what it means.
struct Choice {
    const char *name;
    int value;
};

/// The fields of one JSON object. Each read_* leaves its argument alone where the field is absent, and throws
/// Error{Exit::input} naming the path where its type or value is wrong. What was never asked for is unknown: `finish`.
class Fields {
  public:
    /// `kind` ("camera", "light") chooses the ranges of numbers. Throws where `tree` is not an object.
    Fields(const Json &tree, std::string path, std::string kind, const Source &source);

    const Json *find(const std::string &name); // null: absent
    void read(const std::string &name, double &value);
    void read(const std::string &name, int &value);
    void read(const std::string &name, std::uint32_t &value);
    void read(const std::string &name, bool &value);
    void read(const std::string &name, std::string &value);
    void read(const std::string &name, Vec2 &value);
    void read(const std::string &name, Vec3 &value);
    void read_color(const std::string &name, Vec3 &value); // three numbers, or one for all three
    template <typename Enum> void read_choice(const std::string &name, std::span<const Choice> choices, Enum &value) {
        int chosen = static_cast<int>(value);
        choose(name, choices, chosen);
        value = static_cast<Enum>(chosen);
    }

    /// Throws for a field that nobody asked for, naming the nearest one that was.
    void finish() const;

    std::string path(const std::string &name) const { return join(here, name); }
    [[noreturn]] void fail(const std::string &name, const std::string &message) const;
    const Source &source() const { return origin; }

  private:
    void choose(const std::string &name, std::span<const Choice> choices, int &value);
    double number(const std::string &name, const Json &value) const;
    template <typename Vector> void read_vector(const std::string &name, Vector &value);

    const Json &tree;
    const std::string here, kind;
    const Source &origin;
    std::vector<std::string> known; // names asked for
};

/// "an array of 2", "a string", …: what a value is, for messages.
std::string describe(const Json &value);

} // namespace nacre::io
