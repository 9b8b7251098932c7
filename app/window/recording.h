#pragma once

#include <memory>
#include <string>

#include "record/frame_sink.h"

namespace timeshade {

struct Session;

/// The window's own recording: every frame of the playback drawn whole, one after the other, from the one that is shown
/// when it begins, with what `record` draws before that. How long a frame takes makes no difference.
class Recording {
  public:
    bool on() const { return sink_ != nullptr; }
    int frames() const { return frames_; }
    const std::string& path() const { return path_; }
    /// The last one that was finished; empty if there is none.
    const std::string& lastPath() const { return lastPath_; }

    /// Into "timeshade-SCENE-TECHNIQUE.mp4", under a number where there is one,
    /// at the picture's size (made even) and the playback's rate. Says what is
    /// wrong as a notice.
    void start(Session& session);
    /// Closes the file.
    void stop(Session& session);
    /// To be called when the picture may be whole: takes it and goes a frame on. True if the window has to be drawn
    /// again.
    bool update(Session& session);

  private:
    void fail(Session& session, const std::string& why);

    std::unique_ptr<FrameSink> sink_;
    std::string path_, lastPath_;
    int width_ = 0, height_ = 0;
    int frames_ = 0;
};

}  // namespace timeshade
