#include "json_lines.h"

#include <vector>

#include <nlohmann/json.hpp>

namespace timeshade {

std::map<std::string, int> linesOfKeys(const std::string& json) {
    std::map<std::string, int> lines;
    std::vector<std::string> around;  // the keys whose values are open
    std::string key;
    int line = 1;
    for (std::size_t at = 0; at < json.size(); ++at) {
        const char c = json[at];
        if (c == '\n') ++line;
        if (c == '{' || c == '[') around.push_back(key);
        if ((c == '}' || c == ']') && !around.empty()) around.pop_back();
        if (c != '"') continue;
        const std::size_t begin = at;
        for (++at; at < json.size() && json[at] != '"'; ++at)
            if (json[at] == '\\') ++at;
        const std::size_t next = json.find_first_not_of(" \t\r\n", at + 1);
        if (next == std::string::npos || json[next] != ':') continue;  // a value
        key = nlohmann::json::parse(json.substr(begin, at + 1 - begin)).get<std::string>();
        std::string path;
        for (std::size_t i = 1; i < around.size(); ++i) path += around[i] + "/";
        lines[path + key] = line;
    }
    return lines;
}

}  // namespace timeshade
