#pragma once

#include <string>
#include <vector>

namespace timeshade {

/// Scenes that were opened from files, by their absolute paths, the last first. At most eight.
class RecentFiles {
  public:
    /// Puts a scene in front; built-in scenes are not listed.
    void add(const std::string& sceneName);
    const std::vector<std::string>& paths() const { return paths_; }

  private:
    std::vector<std::string> paths_;
};

}  // namespace timeshade
