#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "compare/compared_techniques.h"
#include "frame/frame_renderer.h"
#include "record/script.h"
#include "scene/scene.h"

namespace timeshade {

/// Draws the frames of one part in order. The frame's number is the only clock. A technique with a history is warmed up
/// before the first, and goes on from frame to frame.
class PartPainter {
  public:
    /// All must outlive it. Throws UsageError for a camera that the scene does not have.
    PartPainter(FrameRenderer& renderer, const ScriptPart& part, const Scene& scene, const PictureText& text);

    int frames() const { return frames_; }
    /// The next frame; nothing where a stop signal came before it was whole.
    std::optional<DisplayImage> next();

  private:
    FrameRequest requestNow() const;
    std::optional<DisplayImage> pictureOf(const ComparedTechnique& compared, const FrameRequest& request);
    std::optional<DisplayImage> drawn(Technique& technique, const FrameRequest& request);

    FrameRenderer& renderer_;
    const ScriptPart& part_;
    const Scene& scene_;
    const PictureText& text_;
    FramePlanner planner_;
    FrameRequest first_;
    std::optional<std::size_t> cameraTo_;
    std::vector<ComparedTechnique> techniques_;
    int frames_ = 0, done_ = 0;
};

}  // namespace timeshade
