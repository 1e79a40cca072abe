#include "io/tree.h"
#include "base/error.h"
#include <algorithm>
#include <set>
#include <vector>

namespace nacre::io {

namespace {

constexpr int deepest = 64; // scenes need 5; trees are walked recursively, so depth is stack

// Watches the parser: the library itself would silently keep one of two equal keys.
class Watch {
  public:
    explicit Watch(const std::string &subject) : subject(subject) {}

    bool operator()(int depth, Json::parse_event_t event, Json &parsed) {
        if (depth > deepest) input_error(subject, "nested deeper than {} levels", deepest);
        if (event == Json::parse_event_t::object_start) keys.emplace_back();
        if (event == Json::parse_event_t::object_end) keys.pop_back();
        if (event == Json::parse_event_t::key && !keys.back().insert(parsed.get<std::string>()).second)
            input_error(subject, "'{}' is given twice in one object", parsed.get<std::string>());
        return true;
    }

  private:
    const std::string &subject;
    std::vector<std::set<std::string>> keys; // of the objects that are open
};

// "[json.exception.parse_error.101] parse error at line 3, column 5: …" without the library's own heading.
std::string without_heading(const std::string &what) {
    const std::size_t end = what.find("] ");
    return end == std::string::npos ? what : what.substr(end + 2);
}

} // namespace

Json parse_json(const std::string &text, const std::string &subject) {
    try {
        return Json::parse(text, Watch(subject));
    } catch (const Json::exception &error) {
        input_error(subject, "not valid JSON: {}", without_heading(error.what()));
    }
}

} // namespace nacre::io
