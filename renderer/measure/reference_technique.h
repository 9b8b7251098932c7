#pragma once

#include <memory>

#include "oracle/oracle.h"
#include "technique/technique.h"

namespace timeshade {

/// Reference technique: reads the samples back, has the oracle test them and uploads the truth, so that the one frame
/// function shades it. What references are made of, and the Embree row of every measurement. Not in the
/// registry: it is no real-time technique.
class ReferenceTechnique final : public Technique {
  public:
    const TechniqueDescription& description() const override;
    void visitSettings(SettingsVisitor&) override {}
    std::vector<PassDecision> passes(const FramePlan& plan) const override;
    /// Builds Embree's scene unless the mesh is the one of before.
    void build(const TechniqueFrame& frame) override;
    LookupProgram lookupProgram(const TechniqueFrame&, Casters) override { return {}; }
    bool hasOwnLookup() const override { return true; }
    void drawLookup(const TechniqueFrame& frame) override;
    std::size_t bytes() const override { return 0; }

  private:
    std::unique_ptr<Oracle> oracle_;
    std::shared_ptr<const MeshTexels> builtFor_;
};

}  // namespace timeshade
