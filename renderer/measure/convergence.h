#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "chart/chart.h"
#include "frame/frame_renderer.h"

namespace timeshade {

/// One technique that goes on improving a still picture (Technique::settlingFrames), watched while it converges.
struct ConvergenceCurve {
    std::string name;                  ///< the variant, and how it begins
    std::string variant;               ///< a TechniqueVariant
    bool afterMotion = false;          ///< the camera has just stopped; else the history is empty
    std::vector<double> offBy30{};     ///< percent of the picture's pixels, one for each of the frames asked for
    std::vector<double> offFromOwn{};  ///< the same against the variant's own converged picture
    std::vector<DisplayImage> pictures{};
};

/// How often a variant draws the still moment, from an empty history, until its picture is taken for its own converged
/// one: Scherzer, Jeschke, Wimmer 2007 (section 4, figure 3) measure against "the fully converged solution". An
/// exponent that rises by 0.1 a frame from 3 to 15 takes 120 of them.
inline constexpr int convergedFrames = 256;

/// What a still picture is compared with.
enum class ConvergenceTarget {
    RayTraced,  ///< the oracle's hard shadow
    Own,        ///< the variant's own converged picture, as in the paper
};

/// The techniques that converge, as they are by default.
std::vector<std::string> convergingTechniques();

/// Two curves for each variant: from an empty history, and after motion. Throws UsageError for a technique that draws
/// a still picture once; it names those that converge.
std::vector<ConvergenceCurve> convergenceCurves(const std::vector<std::string>& variants);

/// A moment that is held, of one variant's own request (Technique::asked).
struct StillMoment {
    FramePlan plan;
    std::vector<FramePlan> approach;  ///< drawn before and not counted, for a curve after motion
};

/// The pictures that a variant's curves are compared with.
struct ConvergenceReferences {
    DisplayImage rayTraced, own;
};

/// The variant with `settings` ("tsm.bias", "0.5"), which hold for all curves, before its own.
std::unique_ptr<Technique> convergingTechnique(FrameRenderer& renderer, const std::string& variant,
                                               const std::vector<std::pair<std::string, std::string>>& settings);

/// The plan's picture with the oracle's lit, and with the technique's own after convergedFrames from an empty history.
ConvergenceReferences convergenceReferences(FrameRenderer& renderer, const FramePlan& plan, Technique& technique);

/// Draws the moment again and again with a technique that has no past, and compares the picture with both references
/// after each of `frames` (ascending): the share of pixels that differ by more than 30 of 255 in a channel.
void measureConvergence(FrameRenderer& renderer, const StillMoment& moment, Technique& technique,
                        const ConvergenceReferences& references, const std::vector<int>& frames,
                        ConvergenceCurve& curve);

/// Rows of numbers as Markdown; with commas, both targets; and as a chart.
std::string convergenceTable(const std::vector<ConvergenceCurve>& curves, const std::vector<int>& frames,
                             ConvergenceTarget target);
std::string convergenceCsv(const std::vector<ConvergenceCurve>& curves, const std::vector<int>& frames);
Chart convergenceChart(const std::string& scene, const std::vector<ConvergenceCurve>& curves,
                       const std::vector<int>& frames, ConvergenceTarget target);

}  // namespace timeshade
