#pragma once

#include <string>

namespace timeshade {

/// The name of a scene in names of files: that of a file without folder and ending, other characters than letters,
/// digits, - and _ as _.
std::string sceneFileName(const std::string& scene);

}  // namespace timeshade
