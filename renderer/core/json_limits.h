#pragma once

#include <cstddef>
#include <string_view>

namespace timeshade {

/// How deep the JSON of any file may be nested: recursive code relies on it.
inline constexpr int deepestJson = 256;

/// Whether brackets outside of strings are nested more deeply than that. The text need not be valid.
bool isNestedTooDeeply(std::string_view json);

/// How many bytes a file of settings, a script or a window's memory may have.
inline constexpr std::size_t largestSettingsFile = std::size_t{4} << 20;

}  // namespace timeshade
