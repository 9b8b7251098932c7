#pragma once

#include <memory>
#include <optional>

#include "passes/near_triangles.h"
#include "technique/technique.h"
#include "technique/view_target.h"
#include "techniques/temporal/tuple_lists.h"

namespace timeshade {

/// Temporal shadow maps (Hong and Oh 2017). For each texel of the light's map and each moving triangle that visits it,
/// a tuple says when the triangle is there and how far away: (begin, end, distance at begin, distance at end,
/// triangle). A receiver is in shadow if a tuple of its texel, of another triangle than its own, holds its time and is
/// nearer than it. No time is sampled for the map, so there is no time mismatch. What remains is the map's resolution
/// in space. The coverage map spares tuples behind a triangle that covers the texel all the time. Still triangles go to
/// an ordinary map. Triangles that cross the light's near plane are tested exactly by each sample. By default repaired
/// (ExactTuples); `as_published` is the paper step by step (PublishedTuples).
class TemporalShadow final : public Technique {
  public:
    static const TechniqueDescription& describe();
    explicit TemporalShadow(gl::ProgramCache& programs) : programs_(programs) { resetSettings(*this); }

    const TechniqueDescription& description() const override { return describe(); }
    void visitSettings(SettingsVisitor& visitor) override;
    Footprint footprint() const override;
    SamplingTraits samplingTraits() const override;
    std::shared_ptr<const Prediction> prediction() const override;
    std::vector<PassDecision> passes(const FramePlan& plan) const override;
    bool separatesStaticCasters() const override { return !asPublished_; }
    void build(const TechniqueFrame& frame) override;
    LookupProgram lookupProgram(const TechniqueFrame& frame, Casters casters) override;
    std::vector<TechniqueView> views() const override;
    void drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values) override;
    StoredAlongLine storedAlong(const TechniqueFrame& frame, const MapLine& line) override;
    std::vector<TechniqueStatistic> statistics() const override;
    std::vector<const gl::Texture*> textures() const override;
    std::size_t bytes() const override;

  private:
    /// The plan's casters that have tuples, by the form's own way.
    std::vector<std::uint32_t> listed(const FramePlan& plan) const;
    void buildLists(const TechniqueFrame& frame, const std::vector<std::uint32_t>& triangles);

    gl::ProgramCache& programs_;
    float bias_{}, slopeBias_{}, publishedBias_{};
    int pcfRadius_{};
    bool asPublished_{}, coverageMap_{};

    bool builtAsPublished_ = false, builtWithCoverage_ = false;
    std::unique_ptr<TupleLists> lists_;
    const gl::Texture* staticMap_ = nullptr;  ///< the frame's; none as published
    NearTriangles near_;
    std::size_t staticCasters_ = 0, moving_ = 0, nonTranslating_ = 0;
    ViewTarget viewTarget_;
};

}  // namespace timeshade
