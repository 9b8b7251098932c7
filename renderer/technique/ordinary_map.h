#pragma once

#include "technique/technique.h"

namespace timeshade {

/// One ordinary shadow map of an instant, and its test: for techniques that are no more than that.
class OrdinaryMap {
  public:
    /// Declares the settings of the test: bias, slope_bias, pcf_radius.
    void visitSettings(SettingsVisitor& visitor);
    /// An instant at a point, filtered where PCF is on.
    Footprint footprint() const;
    SamplingTraits samplingTraits() const;
    /// The centre of the plan's shutter (or its one sample time), where the map is drawn.
    static float instantOf(const FramePlan& plan);
    void build(const TechniqueFrame& frame) { map_ = &frame.maps.atInstant(instantOf(frame.plan)); }
    LookupProgram lookupProgram(const TechniqueFrame& frame, Casters casters) const;
    /// What the map holds, as of [uFrom, uTo]: for storedAlong.
    StoredAlongLine storedAlong(const TechniqueFrame& frame, const MapLine& line, double uFrom, double uTo) const;
    int pcfRadius() const { return pcfRadius_; }

  private:
    float bias_{}, slopeBias_{};
    int pcfRadius_{};
    const gl::Texture* map_ = nullptr;  ///< the frame's
};

}  // namespace timeshade
