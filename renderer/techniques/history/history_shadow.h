#pragma once

#include <array>
#include <optional>

#include "gl/fragment_count.h"
#include "passes/shadow_map.h"
#include "shared/history.shared.h"
#include "technique/technique.h"
#include "techniques/history/converged_pixels.h"
#include "techniques/history/dynamic_mask.h"
#include "techniques/history/history_state.h"
#include "techniques/history/map_raster.h"

namespace timeshade {

/// Pixel-correct shadow maps with temporal reprojection and shadow test confidence (Scherzer, Jeschke, Wimmer 2007).
/// Each frame rasterises its map differently. A pixel accumulates the tests of earlier frames, each weighted by how
/// near to a texel's centre it was (equations 5 and 6), and is reprojected if the camera moves (equation 4).
///
/// As published, the past is smoothed exponentially (equation 3), which never averages more than 7 tests; see
/// published.frag. `as_published` is all of the paper at once: what the settings of the repaired form say then is of no
/// matter. The repaired form stores the sums of weights and of weighted tests, so that a static picture converges; it
/// rejects texels of the history one by one, by their distance from the receiver's plane; and with one sample per pixel
/// it moves values away from one half, since hard shadows are 0 or 1.
///
/// Beyond the paper the map also stores which triangle each texel saw. Averages of tests at texel centres, with any
/// weights, locate an edge to the spacing of the centres, which falls with the square root of the number of frames. But
/// near an edge, one of the four texels around a receiver nearly always saw the triangle that hides it, so these
/// triangles are tested against the receiver's own ray to the light. A hit is proof, needs no bias, and is valid while
/// nothing moves. Without a hit, where the four texels disagree, the receiver is lit, since in time a shadowed one will
/// be proven. If there is no such time, because something or the camera moves, this is done only if the nearest texel's
/// triangle is wider than a texel; smaller casters may be unseen, and the texel's test is used. Remaining errors are
/// casters that no texel around has seen yet: after 20 static frames fewer than one pixel in a thousand.
///
/// Also beyond the paper, moving receivers are followed, and the past is dropped for pixels behind something that has
/// moved (DynamicMask) and, if the light has moved, for all. While a moment is held, the map's instant runs through the
/// shutter, so that blurred shadows converge to their mean; then all tests have the same weight. Instants then lie as
/// densely as the shutter responds (exposedInstant), so that their plain mean is the weighted one. Where time goes on
/// there is one instant a frame, and a response changes nothing but how a pixel's samples count.
///
/// With a static camera converged pixels are tested less often (ConvergedPixels). With one sample per pixel and a
/// closed shutter these are only certain or proven pixels; otherwise, pixels near edges as well after twelve tests.
/// Once nothing moves, the map is drawn for the due pixels of four frames at a time, and not at all after 64 frames.
///
/// Memory: two buffers of 16 bytes per pixel (as published 8: the paper's 4, and for the views how many frames) and 8
/// bytes per texel of the map (4 without its triangles); once something has moved, 4 bytes per texel of the mask, 5 per
/// triangle and a copy of the triangles; with a static camera, 8 bytes per pixel and 4 per camera sample.
class HistoryShadow final : public Technique {
  public:
    static const TechniqueDescription& describe();
    explicit HistoryShadow(gl::ProgramCache& programs) : programs_(programs) { resetSettings(*this); }

    const TechniqueDescription& description() const override { return describe(); }
    void visitSettings(SettingsVisitor& visitor) override;
    /// A shutter of more than one motion step: a pixel's past is that of a whole frame before.
    std::optional<std::string> unsupported(const FramePlan& plan) const override;
    /// Of a frame without a past: an ordinary map at the centre of the shutter.
    Footprint footprint() const override;
    FrameRequest asked(FrameRequest request) const override;
    std::vector<std::string> warnings(const FramePlan& plan) const override;
    SamplingTraits samplingTraits() const override;
    std::shared_ptr<const Prediction> prediction() const override;
    std::vector<PassDecision> passes(const FramePlan& plan) const override;
    int warmUpFrames() const override { return warmUp_; }
    int heldFrames() const override { return hold_; }
    int settlingFrames() const override { return framesToSettle; }
    void forget() override;
    void build(const TechniqueFrame& frame) override;
    LookupProgram lookupProgram(const TechniqueFrame&, Casters) override { return {}; }
    bool hasOwnLookup() const override { return true; }
    void drawLookup(const TechniqueFrame& frame) override;
    std::vector<TechniqueView> views() const override;
    void drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values) override;
    /// A note: what it remembers is in the camera's pixels, and its map is turned from frame to frame.
    StoredAlongLine storedAlong(const TechniqueFrame&, const MapLine&) override;
    std::vector<TechniqueStatistic> statistics() const override;
    std::vector<const gl::Texture*> textures() const override;
    std::size_t bytes() const override;

    /// The output of the last lookup, RGBA32F, as published RGBA16F; for tests.
    const gl::Texture& written() const { return *buffers_[current_]; }

  private:
    static constexpr int framesToSettle = 64;
    std::vector<double> settingValues();
    /// What the published form has whatever is set: sections 3.3 and 4.
    MapFit fit() const { return asPublished_ ? MapFit::Warped : static_cast<MapFit>(fit_); }
    MapJitter jitter() const { return asPublished_ ? MapJitter::ShiftAndTurn : static_cast<MapJitter>(jitter_); }
    bool triesTriangles() const { return tryTriangles_ && !asPublished_ && pcfRadius_ == 0; }
    shared::HistoryBlock blockOf(const FramePlan& plan) const;
    void allocate(const FramePlan& plan);
    void uploadPrevious();
    void drawPublished(const TechniqueFrame& frame);
    void drawTested(const TechniqueFrame& frame, const gl::Program& program, int colors);
    void invalidateConverged(const TechniqueFrame& frame);
    gl::Inputs lookupInputs() const;
    bool masksDynamicCasters() const { return !transition_.dynamicCasters.empty() && !asPublished_; }
    gl::ShaderDefines mapTestDefines(const TechniqueFrame& frame) const;
    bool mayConverge(const FramePlan& plan) const;
    bool keepsProof(const FramePlan& plan) const;
    /// The number of frames whose due pixels are tested in this one; 0: none, and nothing is drawn.
    int framesDue(const FramePlan& plan) const;

    gl::ProgramCache& programs_;
    float m_{}, mStep_{}, mStill_{};
    int jitter_{}, fit_{};
    float bias_{}, slopeBias_{}, threshold_{}, sharpen_{};
    int pcfRadius_{};
    bool tryTriangles_{}, asPublished_{};
    float publishedBias_{};
    int warmUp_{}, hold_{};

    HistoryState state_;
    FrameTransition transition_;
    int framesDue_ = 1;  ///< as framesDue said of the frame drawn last
    std::optional<ShadowMap> map_;
    std::optional<DynamicMask> mask_;
    std::optional<ConvergedPixels> converged_;
    std::optional<gl::Buffer> block_, previous_;
    std::optional<gl::Texture> previousView_;
    std::shared_ptr<const MeshTexels> uploadedPrevious_;
    std::array<std::optional<gl::Texture>, 2> buffers_;
    bool holdsHalves_ = false;
    std::size_t current_ = 0;  ///< of the two: what was written last
    std::optional<gl::Framebuffer> target_;
    std::optional<gl::FragmentCount> tested_;
};

}  // namespace timeshade
