#pragma once

namespace timeshade {

/// Which frame is shown, and whether it runs. Frames are whole while it plays; a frame given on the command line may
/// lie anywhere.
class Playback {
  public:
    /// `duration` in seconds; 0 where nothing moves.
    void setLoop(double duration, double framesPerSecond);
    void jump(double frame) { frame_ = frame; }

    /// Frames first .. last (within the loop) are what is played; another loop plays all of it.
    void setPart(int first, int last);
    int firstFrame() const { return first_; }
    int lastFrame() const { return last_; }
    /// 1 is real time; > 0.
    void setSpeed(double speed) { speed_ = speed; }
    double speed() const { return speed_; }

    bool playing() const { return playing_; }
    void play(bool on);
    /// Moves on by so many seconds of the clock, in whole frames, and starts anew at the end of the part.
    void advance(double seconds);
    /// Pauses and goes a whole frame on or back within the loop.
    void step(int frames);

    double frame() const { return frame_; }
    /// Frames of a loop, at least 1.
    int loopFrames() const { return loopFrames_; }
    /// The frame's place within the loop: 0 .. loopFrames() - 1.
    int frameInLoop() const;
    bool moves() const { return loopFrames_ > 1; }

  private:
    double frame_ = 0.0;
    double framesPerSecond_ = 24.0;
    double unspent_ = 0.0;  ///< frames of the clock that were not whole yet
    double speed_ = 1.0;
    int loopFrames_ = 1;
    int first_ = 0, last_ = 0;
    bool playing_ = false;
};

}  // namespace timeshade
