#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "gl/read_back.h"
#include "oracle/oracle.h"
#include "technique/technique.h"

namespace timeshade {

/// For tests of how techniques are measured: its values are what a function makes of the plan and the samples, and its
/// footprint is what the test declares. Values where nothing is tested do not matter.
class GivenVisibilityTechnique final : public Technique {
  public:
    /// lit of all camera samples, [stratum][row from the bottom][column], from the triangles that they see.
    using Values =
        std::function<std::vector<float>(const Oracle&, const FramePlan&, const std::vector<std::uint32_t>&)>;

    GivenVisibilityTechnique(Footprint footprint, Values values) : footprint_(footprint), values_(std::move(values)) {}

    const TechniqueDescription& description() const override {
        static const TechniqueDescription description{
            "given", "Given", "Given", "Values from a function.", "a test", {}, {}, {}, {}};
        return description;
    }
    void visitSettings(SettingsVisitor&) override {}
    const Values& values() const { return values_; }
    Footprint footprint() const override { return footprint_; }
    std::vector<PassDecision> passes(const FramePlan&) const override { return {}; }
    void build(const TechniqueFrame&) override {}
    LookupProgram lookupProgram(const TechniqueFrame&, Casters) override { return {}; }
    bool hasOwnLookup() const override { return true; }
    void drawLookup(const TechniqueFrame& frame) override {
        const gl::Texture& ids = frame.samples.ids();
        const auto triangles = gl::readTexture<std::uint32_t>(ids, GL_RED_INTEGER, GL_UNSIGNED_INT);
        const Oracle oracle(frame.plan);
        const std::vector<float> lit = values_(oracle, frame.plan, triangles);
        const gl::Texture& visibility = frame.visibility.lit();
        glTextureSubImage3D(visibility.name(), 0, 0, 0, 0, visibility.width(), visibility.height(), visibility.layers(),
                            GL_RED, GL_FLOAT, lit.data());
    }
    std::size_t bytes() const override { return 0; }

  private:
    Footprint footprint_;
    Values values_;
};

}  // namespace timeshade
