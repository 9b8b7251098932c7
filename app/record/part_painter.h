#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "compare/compared_techniques.h"
#include "frame/frame_renderer.h"
#include "record/script.h"
#include "scene/scene.h"

namespace timeshade {

/// Draws the frames of one part in order. The frame's number is the only clock. A technique with a history is warmed up
/// before the first, and goes on from frame to frame. Pictures are read two frames after they were drawn, so that the
/// device is never waited for while it draws.
class PartPainter {
  public:
    /// All must outlive it. Throws UsageError for a camera that the scene does not have.
    PartPainter(FrameRenderer& renderer, const ScriptPart& part, const Scene& scene, const PictureText& text);

    int frames() const { return frames_; }
    /// The next frame; nothing where there is none, or a stop signal came before it was whole.
    std::optional<DisplayImage> next();

  private:
    /// Drawn by the device, or without it.
    using DrawnPicture = std::variant<LatePicture, DisplayImage>;

    double shareOfPart(int frame) const;
    FrameRequest requestOf(int frame) const;
    /// Tells the device to draw the next frame. False where a stop signal came before it was whole.
    bool drawNext();
    std::optional<DrawnPicture> pictureOf(const ComparedTechnique& compared, const FrameRequest& request);
    std::optional<DrawnPicture> drawn(Technique& technique, const FrameRequest& request);

    FrameRenderer& renderer_;
    const ScriptPart& part_;
    const Scene& scene_;
    const PictureText& text_;
    FramePlanner planner_;
    FrameRequest first_;
    std::optional<std::size_t> cameraTo_;
    std::vector<ComparedTechnique> techniques_;
    int frames_ = 0, drawn_ = 0, done_ = 0;
    std::deque<std::vector<DrawnPicture>> unread_;  ///< of frames done_ to drawn_
};

}  // namespace timeshade
