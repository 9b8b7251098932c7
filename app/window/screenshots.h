#pragma once

#include <string>

namespace timeshade {

struct Session;

/// Saves the picture that is shown, as PNG or EXR, under a name that no file has yet.
class Screenshots {
  public:
    /// Saves what is requested once the picture is whole. True when the request has been answered.
    bool update(Session& session);

    /// The last one that was saved; empty if there is none.
    const std::string& lastPath() const { return lastPath_; }
    int count() const { return count_; }

  private:
    void save(Session& session, bool exr);

    std::string lastPath_;
    int count_ = 0;
};

/// "timeshade-SCENE-TECHNIQUE-0012.png"
std::string screenshotName(const Session& session);

}  // namespace timeshade
