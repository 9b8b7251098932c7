#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gl/texture.h"
#include "measure/diagnostic_views.h"
#include "measure/reference.h"
#include "measure/verification.h"
#include "window/accuracy_probe.h"

namespace timeshade {

struct Session;

/// The views error and disagreement of the window: made from a small copy of the picture once that is still, a step on
/// every frame, with a renderer of its own.
class DiagnosticPicture {
  public:
    /// Does one step after the picture of this frame has been drawn. True if the window has to be drawn again.
    bool update(Session& session, int pictureWidth);

    /// Null until it has been made; the picture is shown meanwhile.
    const gl::Texture* picture() const { return complete() ? &*texture_ : nullptr; }
    /// The same for a file.
    const DisplayImage& image() const { return image_; }
    bool complete() const { return texture_.has_value(); }
    /// What it shows, or how far it has got, or why there is none.
    const std::string& caption() const { return caption_; }
    bool failed() const { return failed_; }

  private:
    void begin(Session& session, std::vector<double> key, const ProbeSubject& subject);
    void step();
    void compareWithReference();
    void verify();
    /// Draws the final picture for about 30 ms. True when it is whole.
    bool drawFinal();
    void finish(DisplayImage image, std::string caption);

    std::optional<FrameRenderer> renderer_;  ///< made when first needed
    ReferenceCache cache_;
    std::vector<double> key_;
    ProbeSubject subject_;
    int enlarged_ = 1;
    bool ofError_ = true;

    std::optional<FramePlan> plan_;
    std::unique_ptr<Technique> technique_;
    std::unique_ptr<ReferenceBuilder> reference_;
    std::unique_ptr<DisagreementView> disagreement_;
    std::unique_ptr<FrameVerification> verification_;
    bool drawing_ = false;

    std::optional<gl::Texture> texture_;
    DisplayImage image_;
    std::string caption_;
    bool failed_ = false;
};

}  // namespace timeshade
