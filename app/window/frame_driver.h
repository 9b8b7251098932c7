#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frame/frame_renderer.h"
#include "window/frame_times.h"
#include "window/preview_quality.h"

namespace timeshade {

/// Draws what the window wants to see: anew when anything has changed and not at all when nothing has; coarsely while
/// something moves, if it has to be; a technique that accumulates renders, a few of them at a time.
class FrameDriver {
  public:
    explicit FrameDriver(FrameRenderer& renderer);

    struct Wanted {
        FramePlanner* planner = nullptr;
        Technique* technique = nullptr;
        int scene = 0;  ///< a number that changes with the scene
        FrameRequest request;
        View view = View::Final;
        std::string techniqueView;  ///< of the technique's own, instead of `view`; empty for none
        int shaders = 0;            ///< a number that changes with the programs
        bool moving = false;        ///< it plays, or a mouse button is held
        bool hurry = false;         ///< the full picture at once, whatever moves
        bool once = false;          ///< no picture a second time, however much better it would become
    };

    enum class State {
        Nothing,  ///< nothing drawn yet
        Drawing,  ///< some renders are still to come
        Complete,
        Cancelled,  ///< the average of what had been drawn stays
        Failed,     ///< see failure()
    };

    /// Draws for about 30 ms, or one step where that takes longer. `now`: seconds of any steady clock. True if what is
    /// shown has changed.
    bool update(const Wanted& wanted, double now);
    /// Keeps what has been drawn of a picture that is accumulated, until something changes or resume() is called.
    void cancel();
    void resume();
    /// Draws the full picture anew as the first of a sequence: before it the frames that a technique with a history
    /// needs.
    void warmUp();
    /// Draws the full picture so many times more for its times, unless something changes first.
    void measure(int pictures);
    bool measuring() const { return toMeasure_ > 0; }

    State state() const { return state_; }
    const std::string& failure() const { return failure_; }
    /// Drawn with less than was asked for.
    bool preview() const { return level_ > 0; }
    /// The picture shown is all it can be.
    bool settled() const { return !refine_ && state_ != State::Drawing; }
    /// Seconds that the window may sleep before update() has work to do; nothing if only a change can bring any.
    std::optional<double> sleep(double now) const;

    /// Null as long as there is none.
    const gl::Texture* picture() const { return picture_; }
    /// The renderer holds a plan and a technique that are those of the picture.
    bool hasPlan() const { return hasPlan_; }
    const FrameRenderer& renderer() const { return renderer_; }
    const FrameTimes& times() const { return times_; }
    /// Pictures begun so far.
    int begun() const { return begun_; }

  private:
    bool noticeChange(const Wanted& wanted, double now);
    void begin(const Wanted& wanted, int level);
    void draw();
    void readTimes();
    void forgetTimes();
    void fail(const char* what);

    FrameRenderer& renderer_;
    PreviewQuality quality_;
    FrameTimes times_;
    std::vector<double> frameKey_, methodKey_;  ///< all that the picture depends on; the part that decides its cost
    double lastChange_ = -1e9;
    State state_ = State::Nothing;
    int level_ = 0;
    bool refine_ = false;
    bool hasPlan_ = false;
    bool warmUp_ = false;  ///< before the next picture
    int toMeasure_ = 0;
    int toSettle_ = 0;  ///< draws of the same moment still to come, for a technique with a history
    int begun_ = 0;
    std::string failure_;
    std::string techniqueName_, techniqueView_;
    const gl::Texture* picture_ = nullptr;
};

}  // namespace timeshade
