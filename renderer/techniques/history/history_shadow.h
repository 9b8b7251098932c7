#pragma once

#include <array>
#include <optional>

#include "gl/query.h"
#include "passes/shadow_map.h"
#include "shared/history.shared.h"
#include "technique/technique.h"
#include "techniques/history/converged_pixels.h"
#include "techniques/history/dynamic_mask.h"
#include "techniques/history/history_state.h"

namespace timeshade {

/// Pixel-correct shadow maps with temporal reprojection and shadow test confidence (Scherzer, Jeschke, Wimmer 2007).
/// Each frame's map has a rasterisation of its own; a pixel keeps what the tests of earlier frames have said of its
/// surface, each weighted by how near to a texel's centre it fell (equations 5 and 6), and finds it again when the
/// camera moves (equation 4).
///
/// As published the past is smoothed exponentially (equation 3), in which no more than 7 tests ever count. Repaired,
/// the sums of weights and of weighted tests are kept, so that a still picture goes on converging; texels of the
/// history are rejected one by one by their distance from the receiver's plane; and what is shown of a pixel with one
/// sample is drawn away from one half, since hard shadows know no other values than 0 and 1.
///
/// Beyond the paper the map remembers which triangle each texel saw. Averaging tests made at texels' centres, whatever
/// the weights, moves an edge by the centres' spacing, which falls with the root of the number of frames; but near an
/// edge one of the four texels around a receiver nearly always saw the very triangle that hides it. So these are tried
/// against the receiver's own ray to the light. A hit is proof, needs no bias, and is kept for as long as nothing
/// moves. No hit where the four disagree means lit, as whatever is dark finds its proof in time; where there is no
/// time, since something moves or the camera does, only if the nearest texel's triangle is wider than a texel: of
/// smaller ones the next may hide the receiver, unseen, and the texel's answer stands. What remains are casters that no
/// texel around has seen yet, and every new raster sees others: 20 frames leave fewer than one pixel in a thousand.
///
/// Also beyond the paper a receiver is followed where it moves, and a pixel behind something that has moved
/// (DynamicMask) loses its past, as all do when the light has moved. While a moment is held the map's instant runs
/// through the shutter, so that blurred shadows converge to their mean; then all answers weigh alike.
///
/// And nothing is asked in vain: while the camera stands, pixels that have learned enough rest (ConvergedPixels) until
/// something moves by them. With one sample a pixel and a closed shutter only those rest that are sure or proven, and
/// an edge is asked about in every frame; else, where the answers are averaged, edges rest as well after twelve tests.
/// Once nothing at all moves the map is drawn for four frames' pixels at a time, and not at all after 64.
///
/// Memory: two buffers of 16 bytes a pixel, 8 bytes a texel of the map (4 without its triangles); 4 bytes a texel of
/// the mask, 5 a triangle and a copy of the triangles once something has moved; 8 bytes a pixel and 4 a camera sample
/// while the camera stands.
class HistoryShadow final : public Technique {
  public:
    static const TechniqueDescription& describe();
    explicit HistoryShadow(gl::ProgramCache& programs) : programs_(programs) { resetSettings(*this); }

    const TechniqueDescription& description() const override { return describe(); }
    void visitSettings(SettingsVisitor& visitor) override;
    /// Of a frame without a past: an ordinary map of the middle of the shutter.
    Footprint footprint() const override;
    SamplingTraits samplingTraits() const override;
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
    std::vector<TechniqueStatistic> statistics() const override;
    std::vector<const gl::Texture*> textures() const override;
    std::size_t bytes() const override;

    /// What the last lookup wrote, RGBA32F: for tests.
    const gl::Texture& written() const { return *buffers_[current_]; }

  private:
    static constexpr int framesToSettle = 64;
    std::vector<double> settingValues();
    bool triesTriangles() const { return tryTriangles_ && !asPublished_ && pcfRadius_ == 0; }
    shared::HistoryBlock blockOf(const FramePlan& plan) const;
    void allocate(const FramePlan& plan);
    void uploadPrevious();
    void invalidateConverged(const TechniqueFrame& frame);
    gl::Inputs lookupInputs() const;
    bool masksDynamicCasters() const { return !transition_.dynamicCasters.empty() && !asPublished_; }
    gl::ShaderDefines mapTestDefines(const TechniqueFrame& frame) const;
    bool mayConverge(const FramePlan& plan) const;
    bool keepsProof(const FramePlan& plan) const;
    /// Frames whose due pixels are asked in this one; 0: none is, and nothing is drawn.
    int framesDue(const FramePlan& plan) const;

    gl::ProgramCache& programs_;
    float m_{}, mStep_{}, mStill_{};
    int jitter_{}, fit_{};
    float bias_{}, slopeBias_{}, threshold_{}, sharpen_{};
    int pcfRadius_{};
    bool tryTriangles_{}, asPublished_{};
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
    std::size_t current_ = 0;  ///< of the two: what was written last
    std::optional<gl::Framebuffer> target_;
    std::optional<gl::FragmentCount> tested_;
};

}  // namespace timeshade
