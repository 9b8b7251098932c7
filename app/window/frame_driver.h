#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "frame/frame_renderer.h"
#include "gl/fence.h"
#include "window/frame_times.h"
#include "window/preview_quality.h"
#include "window/shown_picture.h"

namespace timeshade {

/// Draws what the window wants to see: anew when anything has changed and not at all when nothing has; coarsely while
/// something moves, if it has to be; a technique that accumulates renders, a few of them at a time. The picture of
/// before stays until the next is there, so that there is one to be seen whenever drawing pauses. It never waits for
/// the device (but for a software renderer's times): what that has not done yet is looked at by the next update.
class FrameDriver {
  public:
    explicit FrameDriver(FrameRenderer& renderer);

    struct Wanted {
        FramePlanner* planner = nullptr;
        Technique* technique = nullptr;
        int scene = 0;  ///< a number that changes with the scene
        FrameRequest request;
        View view = View::Final;
        std::string techniqueView;      ///< of the technique's own, instead of `view`; empty for none
        int shaders = 0;                ///< a number that changes with the programs
        bool moving = false;            ///< it plays, or a mouse button is held
        bool hurry = false;             ///< the full picture at once, whatever moves
        bool once = false;              ///< no picture a second time, however much better it would become
        std::optional<double> instant;  ///< of the shutter, where the request is of one alone
    };

    enum class State {
        Nothing,  ///< nothing drawn yet
        Drawing,  ///< some renders are still to come
        Complete,
        Cancelled,  ///< what had been drawn stays: a preview, or the average of some renders
        Failed,     ///< see failure()
    };

    /// Draws for about 30 ms, or one step where that takes longer. `now`: seconds of any steady clock. True if what is
    /// shown has changed. Drawing may pause; where a pause ends it, the picture is begun anew by the next update.
    bool update(const Wanted& wanted, double now);
    /// Within a pause of update(): is what is being drawn not worth its end any more? While something moves, a frame is
    /// drawn to its end although that something has moved on: otherwise none would ever be.
    bool outdated(const Wanted& wanted) const;
    /// It is at work in update().
    bool drawing() const { return drawing_; }
    /// The picture that is shown or drawn is the one that is wanted.
    bool follows(const Wanted& wanted) const;
    /// Keeps what has been drawn so far, until something changes or resume() is called.
    void cancel();
    void resume();
    /// Draws the full picture now, without waiting for what moves to have come to rest.
    void hurry() { lastChange_ = -1e9; }
    /// Draws the full picture once more; the renderer's caches have been emptied.
    void drawUncached() { refine_ = uncached_ = true; }
    void setPreview(PreviewQuality::Choice choice) { quality_.setChoice(choice); }
    /// Draws the full picture anew as the first of a sequence: before it the frames that a technique with a history
    /// needs.
    void warmUp();
    /// Draws the full picture so many times more for its times, unless something changes first.
    void measure(int pictures);
    bool measuring() const { return toMeasure_ > 0 || measureNext_ > 0; }

    State state() const { return state_; }
    const std::string& failure() const { return failure_; }
    /// What is shown was drawn with less than was asked for.
    bool preview() const { return shown_.preview; }
    /// The full picture is being drawn, in one render, and how much of that is done.
    std::optional<double> progress() const;
    /// The picture shown is all it can be.
    bool settled() const { return !refine_ && !restart_ && state_ != State::Drawing; }
    /// Seconds that the window may sleep before update() has work to do; nothing if only a change can bring any.
    std::optional<double> sleep(double now) const;

    /// Null as long as there is none.
    const gl::Texture* picture() const { return copy_ && shown_.number > 0 ? &*copy_ : nullptr; }
    /// What that is.
    const ShownPicture& shown() const { return shown_; }
    /// The renderer holds a plan and a technique that are those of the picture.
    bool hasPlan() const { return hasPlan_; }
    const FrameRenderer& renderer() const { return renderer_; }
    const FrameTimes& times() const { return times_; }
    /// Pictures begun so far.
    int begun() const { return begun_; }

  private:
    bool noticeChange(const Wanted& wanted, double now);
    void proceed(const Wanted& wanted, bool changed, double now);
    void begin(const Wanted& wanted, int level);
    void draw(const Wanted& wanted);
    bool isHeldBack(const Wanted& wanted, bool& changed);
    void step();
    bool isBehind();
    ShownPicture described(const Wanted& wanted) const;
    void show(ShownPicture picture);
    void showProven();
    void giveUp();
    void readTimes();
    void takeTimes();
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
    bool warmUp_ = false;    ///< before the next picture
    bool drawing_ = false;   ///< within update()
    bool moving_ = false;    ///< as the picture was begun
    bool restart_ = false;   ///< a pause has ended the last picture
    bool uncached_ = false;  ///< the next picture uses nothing of those before
    bool stop_ = false;      ///< cancel() was called
    int toMeasure_ = 0;
    int measureNext_ = 0;  ///< asked for within a pause, perhaps
    int toSettle_ = 0;     ///< draws of the same moment still to come, for a technique with a history
    int begun_ = 0;
    std::string failure_;
    std::string techniqueName_, techniqueView_;
    std::optional<gl::Texture> copy_;  ///< of the renderer's picture
    ShownPicture shown_;
    std::optional<ShownPicture> unproven_;  ///< complete, and not known yet whether its lists had room
    std::deque<gl::Fence> steps_;           ///< behind those that the device has not done yet
    StaticVersions versions_;               ///< of the picture before
};

}  // namespace timeshade
