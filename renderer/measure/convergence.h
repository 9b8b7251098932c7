#pragma once

#include <string>
#include <utility>
#include <vector>

#include "chart/chart.h"
#include "frame/frame_renderer.h"

namespace timeshade {

/// One technique that goes on improving a still picture (Technique::settlingFrames), watched while it converges.
struct ConvergenceCurve {
    std::string name;               ///< the variant, and how it begins
    std::string variant;            ///< a TechniqueVariant
    bool afterMotion = false;       ///< the camera has just stopped; else the history is empty
    std::vector<double> offBy30{};  ///< percent of the picture's pixels, one for each of the frames asked for
    std::vector<DisplayImage> pictures{};
};

/// The techniques that converge, as they are by default.
std::vector<std::string> convergingTechniques();

/// Two curves for each variant: from an empty history, and after motion. Throws UsageError for a technique that draws
/// a still picture once; it names those that converge.
std::vector<ConvergenceCurve> convergenceCurves(const std::vector<std::string>& variants);

/// The plan's picture with the oracle's lit.
DisplayImage referencePicture(FrameRenderer& renderer, const FramePlan& plan);

/// Draws the plan's moment again and again and compares the picture with the reference after each of `frames`
/// (ascending): the share of pixels that differ by more than 30 of 255 in a channel. `approach` is drawn before and not
/// counted, for a curve after motion. `settings` ("tsm.bias", "0.5") hold for all curves, before a variant's own.
void measureConvergence(FrameRenderer& renderer, const std::vector<FramePlan>& approach, const FramePlan& plan,
                        const DisplayImage& reference, const std::vector<std::pair<std::string, std::string>>& settings,
                        const std::vector<int>& frames, ConvergenceCurve& curve);

/// Rows of numbers as Markdown; the same with commas; and as a chart.
std::string convergenceTable(const std::vector<ConvergenceCurve>& curves, const std::vector<int>& frames);
std::string convergenceCsv(const std::vector<ConvergenceCurve>& curves, const std::vector<int>& frames);
Chart convergenceChart(const std::string& scene, const std::vector<ConvergenceCurve>& curves,
                       const std::vector<int>& frames);

}  // namespace timeshade
