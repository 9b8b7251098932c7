#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frame/frame_renderer.h"
#include "measure/case_matrix.h"

namespace timeshade {

struct Session;

/// What every technique measures of the analytic case that is shown: one technique a step, on the case's own small
/// picture, while the panel that shows it can be seen.
class CaseStudy {
  public:
    /// To be called on every frame in which the panel can be seen.
    void keepOn() { wanted_ = true; }
    /// Does one step after the picture of this frame has been drawn. True if the window has to be drawn again.
    bool update(Session& session);

    /// The case of that scene; null for others.
    static const ClosedFormCase* caseOf(const std::string& scene);
    /// So far, in the order of the registry; the technique that is shown as it is set, the others as at a start.
    const std::vector<CaseResult>& results() const { return results_; }

  private:
    std::optional<FrameRenderer> renderer_;  ///< there while it works
    std::vector<CaseResult> results_;
    std::string case_;
    std::vector<double> key_;  ///< what the results depend on, besides the case
    bool wanted_ = false;
};

}  // namespace timeshade
