#include "json_lines.h"

#include <algorithm>
#include <cstddef>

#include <nlohmann/json.hpp>

namespace timeshade {

namespace {

/// Goes through a valid JSON text from one bracket or string to the next.
class JsonWalk {
  public:
    explicit JsonWalk(const std::string& json) : json_(json) {}

    /// False at the end. Then `mark` is a bracket, or a quotation mark for a whole string.
    bool next() {
        if (ended_) at = end;
        for (ended_ = true; at < json_.size(); ++at) {
            mark = json_[at];
            if (mark == '\n') ++line;
            if (opens()) ++depth;
            if (mark == '}' || mark == ']') --depth;
            if (mark == '"') skipString();
            end = mark == '"' ? end : at + 1;
            if (mark == '"' || mark == '}' || mark == ']' || opens()) return true;
        }
        return false;
    }

    bool opens() const { return mark == '{' || mark == '['; }
    /// Whether it is a string that is a key.
    bool isKey() const {
        const std::size_t colon = json_.find_first_not_of(" \t\r\n", end);
        return mark == '"' && colon != std::string::npos && json_[colon] == ':';
    }
    std::string string() const { return nlohmann::json::parse(json_.substr(at, end - at)).get<std::string>(); }

    char mark = 0;
    std::size_t at = 0, end = 0;  ///< of the mark
    int depth = 0;                ///< behind the mark
    int line = 1;

  private:
    void skipString() {
        for (end = at + 1; end < json_.size() && json_[end] != '"'; ++end)
            if (json_[end] == '\\') ++end;
        end = std::min(end + 1, json_.size());
    }

    const std::string& json_;
    bool ended_ = false;
};

}  // namespace

std::map<std::string, int> linesOfKeys(const std::string& json) {
    std::map<std::string, int> lines;
    std::string outer;  // the last key of the whole object
    bool inSet = false;
    for (JsonWalk walk(json); walk.next();) {
        if (walk.depth == 2 && walk.opens()) inSet = walk.mark == '{' && outer == "set";
        const bool listed = walk.depth == 1 || (walk.depth == 2 && inSet);
        if (!listed || !walk.isKey()) continue;
        const std::string key = walk.string();
        if (walk.depth == 1) outer = key;
        lines[walk.depth == 1 ? key : "set/" + key] = walk.line;
    }
    return lines;
}

std::vector<JsonPiece> objectsUnder(const std::string& json, const std::string& key) {
    std::vector<JsonPiece> pieces;
    bool inside = false, list = false;
    std::size_t begin = 0;
    int line = 1;
    for (JsonWalk walk(json); walk.next();) {
        if (walk.depth == 1 && walk.isKey()) {
            inside = walk.string() == key;
            if (inside) pieces.clear();
        }
        if (!inside || walk.mark == '"') continue;
        if (walk.depth == 2 && walk.mark == '[') list = true;
        if (walk.depth == 2 && walk.mark == '{') list = false;
        const bool opens = walk.mark == '{' && walk.depth == (list ? 3 : 2);
        const bool closes = walk.mark == '}' && walk.depth == (list ? 2 : 1);
        if (opens) {
            begin = walk.at;
            line = walk.line;
        }
        if (closes) pieces.push_back({json.substr(begin, walk.end - begin), line});
        if (walk.depth == 1) inside = false;
    }
    return pieces;
}

}  // namespace timeshade
