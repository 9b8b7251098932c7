#pragma once

#include <filesystem>

namespace timeshade {

/// A new folder beside the one that it is to become: whole or not at all. As PartFile: its name cannot be foreseen,
/// only its user can look into it until it is renamed, it is deleted unless it is renamed, and so is what killed
/// programs left behind of the same folder. Throws Error that names the path and the system's reason.
class PartFolder {
  public:
    explicit PartFolder(std::filesystem::path target);
    ~PartFolder();
    PartFolder(const PartFolder&) = delete;
    PartFolder& operator=(const PartFolder&) = delete;

    const std::filesystem::path& path() const { return part_; }
    /// The target is nothing, or an empty folder.
    void renameOntoTarget();

  private:
    void removeLeftovers() const;

    std::filesystem::path target_, part_;
    int descriptor_ = -1;  ///< holds the lock that tells it from a leftover
    bool renamed_ = false;
};

}  // namespace timeshade
