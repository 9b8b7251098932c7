#pragma once

#include <filesystem>
#include <map>

namespace timeshade {

/// Notices when a file in the folder of the shaders is changed, made or taken away.
class ShaderWatch {
  public:
    ShaderWatch();
    /// True once after a change. Looks at the files at most twice a second. `now` in seconds of any steady clock.
    bool changed(double now);

  private:
    std::map<std::filesystem::path, std::filesystem::file_time_type> times_;
    double lastLook_ = -1e9;
};

}  // namespace timeshade
