#include "gl/program_cache.h"

namespace timeshade::gl {

const Program& ProgramCache::get(const ProgramDescription& description) {
    std::string key;
    for (const std::string& stage : description.stages()) key += stage + "|";
    for (const auto& [name, value] : description.defines) key += "|" + name + "=" + value;
    const auto found = programs_.find(key);
    if (found != programs_.end()) return found->second;
    return programs_.emplace(std::move(key), Program(description)).first->second;
}

} // namespace timeshade::gl
