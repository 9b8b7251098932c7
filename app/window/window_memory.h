#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace timeshade {

/// What a window is like that has nothing to do with the pictures in it.
struct WindowMemory {
    int width = 0, height = 0;  ///< screen coordinates; 0 where none is remembered
    double textScale = 1.0;
    std::map<std::string, bool>
        sections;  ///< of the side panel: unfolded or not, where that is not as at a first start
    std::vector<std::string> recentScenes;  ///< absolute paths, the last first
    bool storyClosed = false;               ///< the card at the start has been closed for good
    double panelWidth = 0.0;                ///< 0 as at a first start
    std::string preview = "automatic";      ///< full, automatic or coarse

    bool operator==(const WindowMemory&) const = default;
};

/// JSON; what is not mentioned is as at a first start, and what is unknown is a later version's. Throws Error that
/// names `path`.
WindowMemory memoryOfJson(const std::string& text, const std::string& path);
std::string jsonOf(const WindowMemory& memory);

/// A window's memory from run to run: window.json in $XDG_CONFIG_HOME/timeshade or ~/.config/timeshade; without a home
/// there is none. A file that can't be read or written is complained of once and makes no other difference.
class MemoryFile {
  public:
    MemoryFile();

    const WindowMemory& atStart() const { return written_; }
    /// What went wrong and has not been said yet.
    std::optional<std::string> takeComplaint();
    /// Writes it once it is other than what is in the file and has stayed so for a second. `seconds` of any steady
    /// clock.
    void keep(const WindowMemory& now, double seconds);
    /// Writes now what keep() was told last.
    void finish();

  private:
    void write();

    std::filesystem::path path_;  ///< empty: nothing is kept
    WindowMemory written_, wanted_;
    double changed_ = 0.0;
    std::optional<std::string> complaint_;
};

}  // namespace timeshade
