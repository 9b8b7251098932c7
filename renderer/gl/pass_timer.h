#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gl/object.h"

namespace timeshade::gl {

/// How long each named step of a frame took on the device. On hardware: 64-bit GL_TIMESTAMP pairs, read when they are
/// there. On a software renderer: the wall clock around glFinish, since a timestamp there says when a command was
/// rasterised and leaves out the vertex work; pauses (core/pause.h) are left out. Steps of one name within a frame add
/// up. A step inside another is named "build/collect" and is part of that one's time: who adds up a frame leaves names
/// with a slash out.
class PassTimer {
  public:
    enum class Clock { Timestamps, Finish };
    explicit PassTimer(Clock clock);
    ~PassTimer();
    PassTimer(const PassTimer&) = delete;
    PassTimer& operator=(const PassTimer&) = delete;

    class Scope {
      public:
        Scope(PassTimer& timer, std::string name);
        ~Scope();
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

      private:
        PassTimer& timer_;
        std::size_t step_;
    };
    [[nodiscard]] Scope scope(std::string name) { return {*this, std::move(name)}; }

    struct Reading {
        std::string name;
        double milliseconds = 0.0;
        double hostMilliseconds =
            0.0;  ///< that the processor spent on telling the device; the same on a software renderer
        bool isPart() const { return name.find('/') != std::string::npos; }  ///< of another reading
    };
    /// Closes the frame and starts a new one. Returns the readings of the newest frame whose figures have arrived
    /// (in order of first use), or nothing.
    std::optional<std::vector<Reading>> endFrame();
    /// The same, waiting for the frame just drawn.
    std::vector<Reading> finishFrame();
    /// Readings of the newest closed frame whose figures have arrived since they were asked for last, or nothing.
    std::optional<std::vector<Reading>> arrived();
    /// Figures of closed frames are still on their way.
    bool awaits() const { return !pending_.empty(); }
    /// Gives up the figures of the frame that is not closed yet.
    void dropFrame();
    /// Gives up those of all frames.
    void dropAll();

  private:
    struct Step {
        std::string name;
        GLuint beginQuery = 0, endQuery = 0;
        std::chrono::steady_clock::time_point begin, end;
        double paused = 0.0;  ///< milliseconds, before it began; then within it
    };
    using Frame = std::vector<Step>;
    GLuint timestamp();
    void closeFrame();
    std::vector<Reading> read(const Frame& frame);
    void recycle(const Frame& frame);

    Clock clock_;
    Frame current_;
    std::vector<Frame> pending_;
    std::vector<GLuint> freeQueries_;
};

/// Time of all steps that are not part of another, in milliseconds.
double totalOf(const std::vector<PassTimer::Reading>& readings);

}  // namespace timeshade::gl
