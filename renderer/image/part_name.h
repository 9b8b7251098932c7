#pragma once

#include <filesystem>
#include <string>

namespace timeshade {

// Names of what is being made beside its target: NAME.16 random digits.part.

/// The beginning of the names of a target's parts.
std::string stemOfParts(const std::filesystem::path& target);

/// Beside the target, with digits that cannot be foreseen. Throws Error where the system has none.
std::filesystem::path newPartName(const std::filesystem::path& target);

/// Whether a name in the target's folder is that of one of its parts.
bool isPartName(const std::string& name, const std::string& stem);

/// Where the target's parts lie.
std::filesystem::path folderOfParts(const std::filesystem::path& target);

}  // namespace timeshade
