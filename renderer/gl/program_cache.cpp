#include "gl/program_cache.h"

#include <algorithm>

namespace timeshade::gl {

const Program& ProgramCache::get(const ProgramDescription& description) {
    std::string key;
    for (const std::string& stage : description.stages()) key += stage + "|";
    for (const auto& [name, value] : description.defines) key += "|" + name + "=" + value;
    auto found = programs_.find(key);
    if (found == programs_.end()) found = programs_.emplace(std::move(key), Entry{Program(description), 0}).first;
    found->second.lastUse = ++uses_;
    return found->second.program;
}

void ProgramCache::keepLatest(std::size_t count) {
    while (programs_.size() > count)
        programs_.erase(std::min_element(programs_.begin(), programs_.end(),
                                         [](const auto& a, const auto& b) { return a.second.lastUse < b.second.lastUse; }));
}

} // namespace timeshade::gl
