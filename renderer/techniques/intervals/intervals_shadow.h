#pragma once

#include <memory>
#include <optional>

#include "passes/near_triangles.h"
#include "technique/technique.h"
#include "technique/view_target.h"
#include "techniques/intervals/interval_map.h"

namespace timeshade {

/// Analytical motion blurred shadows (Palmér 2011, after Gribel, Doggett and Akenine-Möller 2010): a map of intervals
/// (IntervalMap), each the time during which one triangle covers a texel's centre. A camera sample has one time; its
/// receiver is in shadow if an interval of its texel, of another triangle than its own, holds that time and is nearer.
/// No time is sampled for the map; on interval samples none for the receiver. By default repaired: what stands still is
/// in an ordinary map; lists hold what the light sees, as many intervals as there are; distances are within a stated
/// bound; the plane of the receiver's triangle is tested at the texel's centre. Either way, triangles that cross the
/// light's near plane are tested one by one.
class IntervalsShadow final : public Technique {
  public:
    static const TechniqueDescription& describe();
    explicit IntervalsShadow(gl::ProgramCache& programs) : programs_(programs) { resetSettings(*this); }

    const TechniqueDescription& description() const override { return describe(); }
    void visitSettings(SettingsVisitor& visitor) override;
    Footprint footprint() const override;
    SamplingTraits samplingTraits() const override;
    std::shared_ptr<const Prediction> prediction() const override;
    std::vector<std::string> warnings(const FramePlan& plan) const override;
    std::vector<PassDecision> passes(const FramePlan& plan) const override;
    bool solvesIntervals() const override { return true; }
    bool separatesStaticCasters() const override { return !asPublished_; }
    void build(const TechniqueFrame& frame) override;
    LookupProgram lookupProgram(const TechniqueFrame& frame, Casters casters) override;
    std::vector<TechniqueView> views() const override;
    void drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values) override;
    StoredAlongLine storedAlong(const TechniqueFrame& frame, const MapLine& line) override;
    std::vector<TechniqueStatistic> statistics() const override;
    std::size_t bytes() const override;

  private:
    float biasTexels() const { return asPublished_ ? publishedBias_ : bias_; }
    /// Intervals of a texel; 0: without a limit.
    std::uint32_t capacity() const;
    /// The plan's casters that have intervals, ascending.
    std::vector<std::uint32_t> listed(const FramePlan& plan) const;
    void buildMap(const TechniqueFrame& frame, const std::vector<std::uint32_t>& triangles);
    void addErrors(const IntervalCounts& counts, std::vector<TechniqueStatistic>& statistics) const;

    gl::ProgramCache& programs_;
    float bias_{}, publishedBias_{}, depthError_{};
    int capacity_{}, depthPieces_{}, pointsPerTexel_{}, leastPoints_{};
    bool asPublished_{}, bilinear_{}, visibleOnly_{};

    bool builtAsPublished_ = false;
    std::optional<IntervalMap> map_;
    const gl::Texture* staticMap_ = nullptr;  ///< the frame's; none as published
    NearTriangles near_;
    std::size_t listed_ = 0;
    double mapTexels_ = 0.0;
    ViewTarget viewTarget_;
};

}  // namespace timeshade
