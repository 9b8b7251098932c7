#pragma once

#include <map>
#include <string>

namespace timeshade {

/// The line of every key of a valid JSON text, by its path: "spp", "set/tsm.bias". Of a key that is there twice, the
/// last.
std::map<std::string, int> linesOfKeys(const std::string& json);

}  // namespace timeshade
