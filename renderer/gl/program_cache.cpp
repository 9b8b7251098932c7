#include "gl/program_cache.h"

#include <algorithm>

#include "core/error.h"
#include "core/pause.h"

namespace timeshade::gl {

const Program& ProgramCache::get(const ProgramDescription& description) {
    std::string key;
    for (const std::string& stage : description.stages()) key += stage + "|";
    for (const auto& [name, value] : description.defines) key += "|" + name + "=" + value;
    auto found = programs_.find(key);
    if (found == programs_.end()) {
        announceWork("building shader " + description.label);
        found = programs_.emplace(std::move(key), Entry{Program(description), description, 0}).first;
        ++compiled_;
    }
    found->second.lastUse = ++uses_;
    return found->second.program;
}

void ProgramCache::keepNewest(std::size_t count) {
    while (programs_.size() > count)
        programs_.erase(std::min_element(programs_.begin(), programs_.end(), [](const auto& a, const auto& b) {
            return a.second.lastUse < b.second.lastUse;
        }));
}

std::vector<std::string> ProgramCache::reload() {
    std::vector<std::string> complaints;
    for (auto& [key, entry] : programs_) {
        try {
            entry.program = Program(entry.description);
            ++compiled_;
        } catch (const Error& error) {
            complaints.emplace_back(error.what());
        }
    }
    return complaints;
}

}  // namespace timeshade::gl
