// What the technique `history` says of itself.
#include <fmt/format.h>

#include "technique/fitted_map_prediction.h"
#include "techniques/history/history_shadow.h"
#include "techniques/history/map_raster.h"

namespace timeshade {

const TechniqueDescription& HistoryShadow::describe() {
    static const TechniqueDescription description{
        .name = "history",
        .title = "History buffer with confidence",
        .shortTitle = "History",
        .summary =
            "A coarse map whose raster changes every frame; each pixel keeps what earlier frames' tests were sure of: "
            "converges to pixel-sharp shadows where nothing moves.",
        .source = "Scherzer, Jeschke, Wimmer 2007",
        .wrong =
            "Motion: where a shadow may have changed, the past is dropped and the pixel begins again, so that fast "
            "casters have rough shadows. It takes one motion step.",
        .look = "chess: let it play, then stop; edges sharpen while nothing moves.",
        .picture = "chess while the queen slides: left history with a map of 256, right ground truth.",
        .references = {"D. Scherzer, S. Jeschke, M. Wimmer 2007: Pixel-correct shadow maps with temporal reprojection "
                       "and shadow test confidence. Eurographics Symposium on Rendering."},
    };
    return description;
}

std::optional<std::string> HistoryShadow::unsupported(const FramePlan& plan) const {
    if (plan.pieces.empty()) return std::nullopt;
    return fmt::format("its past is that of frames with one linear motion each; expected --motion-steps 1, not {}",
                       plan.pieces.size());
}

void HistoryShadow::visitSettings(SettingsVisitor& visitor) {
    visitor.number(
        "m", m_, 3.0, 0.0, 32.0, "exponent",
        "Exponent of the confidence while the camera moves (equation 6). More trusts sure tests alone: sharper, and "
        "slower to settle.");
    visitor.number("m_still", mStill_, 15.0, 0.0, 64.0, "exponent", "The exponent that a still camera comes to.");
    visitor.number("m_step", mStep_, 1.0, 0.0, 640.0, "exponent in ten frames",
                   "How fast the exponent rises once the camera stands.");
    visitor.choice("jitter", jitter_, 1, {"none", "shift", "shift-and-rotate"},
                   "Of the repaired form: how the map's raster changes from frame to frame: shifted within a texel, or "
                   "rotated, too. The paper needs the latter, which the published form always has; the repaired one "
                   "converges faster with shifts alone, which are spread evenly for every pixel.");
    visitor.choice("fit", fit_, 1, {"whole-light", "camera-view", "lispsm"},
                   "Of the repaired form: what the map covers: all that the light reaches; what the camera sees of it; "
                   "or that, with more texels for what is near (light space perspective shadow maps). The published "
                   "form always has the last.");
    visitor.number("bias", bias_, 0.0625, 0.0, 16.0, "texels",
                   "Of the repaired form: how much nearer to the light a caster must be before it counts. The test is "
                   "made on the receiver's own plane at the texel's centre, so that little is enough.");
    visitor.number(
        "slope_bias", slopeBias_, 1.0, 0.0, 8.0, "half texels of slope",
        "With published_bias only: further bias in proportion to how steeply the surface falls away from the light.");
    visitor.whole("pcf_radius", pcfRadius_, 0, 0, 3, "texels",
                  "Percentage-closer filtering of each frame's test over (2n + 1) x (2n + 1) texels: soft edges; 0 "
                  "switches it off.");
    visitor.number(
        "threshold", threshold_, 2.0, 0.0, 1000.0, "thousandths of the distance",
        "How far a pixel's past may lie off the receiver's plane (as published: how far its filtered depth may "
        "differ) before it is taken for another surface's.");
    visitor.number("sharpen", sharpen_, 256.0, 1.0, 4096.0, "times",
                   "With one sample a pixel and nothing moving, what is shown is drawn away from one half by up to "
                   "this factor once the "
                   "camera stands; hard shadows know only 0 and 1. 1 switches it off.");
    visitor.toggle("try_triangles", tryTriangles_, true,
                   "The triangles that the map saw around a receiver are tried against its own ray to the light, so "
                   "that edges are sharp whatever the "
                   "texels. Costs 4 bytes a texel of the map. Not with PCF.");
    visitor.toggle(
        "as_published", asPublished_, false,
        "All that the paper says, whatever the settings of the repaired form are: samples at pixel centres, a "
        "map with light space perspective that is shifted and turned in every frame, no bias, exponential "
        "smoothing, its result and the depth as 16-bit numbers for every fragment, bilinear lookup judged by "
        "its depth, nothing known of motion but the camera's.");
    visitor.number("published_bias", publishedBias_, 0.0, 0.0, 16.0, "texels",
                   "As published only, in place of bias. The paper has none; above 0, to see what that would hide, "
                   "slope_bias counts as well; 0.5 is usual.");
    visitor.whole("warm_up", warmUp_, 16, 0, 64, "frames",
                  "How many frames before a headless picture are drawn to fill the history.");
    visitor.whole(
        "hold", hold_, 0, 0, 240, "frames",
        "How many times a headless picture's own frame is drawn beforehand, as when a window stands still on it.");
}

/// Every sample of a pixel is handed the pixel's share.
Footprint HistoryShadow::footprint() const {
    Footprint footprint;
    footprint.time = Footprint::Time::Shutter;
    footprint.space = Footprint::Space::PixelSurface;
    footprint.filterTexels = Footprint::filterOf(pcfRadius_);
    return footprint;
}

SamplingTraits HistoryShadow::samplingTraits() const {
    // Which triangles a texel has seen depends on how a surface is cut.
    return {.times = SamplingTraits::Times::OneInstant,
            .texelCentres = true,
            .biasTexels = static_cast<double>(asPublished_ ? publishedBias_ : bias_),
            .triangulationError = triesTriangles() ? 0.005 : 0.0};
}

std::shared_ptr<const Prediction> HistoryShadow::prediction() const {
    return fit() != MapFit::Light ? std::make_shared<FittedMapPrediction>() : Technique::prediction();
}

/// The paper's frame buffer has one sample a pixel, at its centre, as rasterisers do: only so a texel of the history is
/// the same place of the image for every frame, and bilinear filtering of it (3.2) finds the place between.
FrameRequest HistoryShadow::asked(FrameRequest request) const {
    request.pixelCentres = request.pixelCentres || asPublished_;
    return request;
}

/// Of the first rasterisation: which way the map is turned does not matter.
std::vector<std::string> HistoryShadow::warnings(const FramePlan& plan) const {
    const std::string shortfall = mapRaster(plan, fit(), jitter(), 0).shortfall;
    if (shortfall.empty()) return {};
    return {fmt::format("{}: {}", fit() == MapFit::Warped ? "fit lispsm" : "fit camera-view", shortfall)};
}

std::vector<PassDecision> HistoryShadow::passes(const FramePlan& plan) const {
    static constexpr const char* rasters[] = {"the same raster every frame", "a raster shifted within a texel",
                                              "a raster shifted and turned"};
    std::vector<PassDecision> passes{
        {"history",
         fmt::format(
             "{} frames before the picture's and {} repetitions of it are drawn first; {}", warmUp_, hold_,
             asPublished_ ? "2 x 8 bytes a pixel" : "2 x 16 bytes a pixel, and 8 + 4 a sample while the camera stands"),
         0},
        {"build",
         fmt::format("one ordinary shadow map with {}, at u = 0.5 where time goes on{}",
                     rasters[static_cast<int>(jitter())],
                     triesTriangles() ? "; 8 bytes a texel, with its triangles" : ""),
         plan.motion.triangles}};
    if (!asPublished_ && plan.motion.movingTriangles > 0)
        passes.push_back(
            {"mask", "what moves, seen from the light: pixels behind it lose their past", plan.motion.movingTriangles});
    if (!asPublished_ && plan.motion.lightMoves)
        passes.push_back({"mask", "the light moves: every frame begins anew", 0});
    passes.push_back({"lookup",
                      triesTriangles() ? "all samples of a pixel against that map, merged with the pixel's past; while "
                                         "the camera stands, of pixels that still learn"
                                       : "all samples of a pixel against that map, merged with the pixel's past",
                      0});
    return passes;
}

std::vector<TechniqueView> HistoryShadow::views() const {
    return {{"confidence", "Confidence of this frame's tests", "", 0.0, 1.0, false},
            {"history-length", "Frames in the history", "frames", 1.0, 256.0, true},
            {"rejected", "Past rejected", "", 0.0, 1.0, false}};
}

}  // namespace timeshade
