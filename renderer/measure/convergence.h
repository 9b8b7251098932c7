#pragma once

#include <string>
#include <utility>
#include <vector>

#include "chart/chart.h"
#include "frame/frame_renderer.h"

namespace timeshade {

/// One way of using a technique with a history, to be watched while it converges.
struct ConvergenceCurve {
    std::string name;
    std::vector<std::pair<std::string, std::string>> settings{};  ///< "m", "15"
    bool afterMotion = false;       ///< the camera has just come to rest; else the history is empty
    std::vector<double> offBy30{};  ///< percent of the picture's pixels, one for each of the frames asked for
    std::vector<DisplayImage> pictures{};
};

/// The ways of figure 3 of Scherzer, Jeschke, Wimmer 2007 and the repaired ones, in the order of the table.
std::vector<ConvergenceCurve> historyCurves();

/// The plan's picture with the oracle's lit.
DisplayImage referencePicture(FrameRenderer& renderer, const FramePlan& plan);

/// Draws the plan's moment again and again and compares the picture with the reference after each of `frames`
/// (ascending): the share of pixels that differ by more than 30 of 255 in a channel. `approach` is drawn before and not
/// counted, for a curve after motion. `settings` hold for all curves, before their own.
void measureConvergence(FrameRenderer& renderer, const std::vector<FramePlan>& approach, const FramePlan& plan,
                        const DisplayImage& reference, const std::string& technique,
                        const std::vector<std::pair<std::string, std::string>>& settings,
                        const std::vector<int>& frames, ConvergenceCurve& curve);

/// Rows of numbers as Markdown; the same with commas; and as a chart.
std::string convergenceTable(const std::vector<ConvergenceCurve>& curves, const std::vector<int>& frames);
std::string convergenceCsv(const std::vector<ConvergenceCurve>& curves, const std::vector<int>& frames);
Chart convergenceChart(const std::string& scene, const std::vector<ConvergenceCurve>& curves,
                       const std::vector<int>& frames);

}  // namespace timeshade
