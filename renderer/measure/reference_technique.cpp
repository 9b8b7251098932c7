#include "measure/reference_technique.h"

#include "gl/read_back.h"

namespace timeshade {

const TechniqueDescription& ReferenceTechnique::description() const {
    static const TechniqueDescription truth{
        .name = "truth",
        .title = "Ground truth by ray tracing",
        .shortTitle = "Ground truth",
        .summary = "Embree's motion-blurred shadow rays, one per camera sample.",
        .source = "Embree 3 (Wald et al. 2014)",
        .wrong = {},
        .look = {},
        .picture = {},
        .references = {},
    };
    return truth;
}

std::vector<PassDecision> ReferenceTechnique::passes(const FramePlan& plan) const {
    return {{"build", "acceleration structure over both ends of the shutter", plan.motion.triangles},
            {"lookup", "one shadow ray per camera sample", 0}};
}

void ReferenceTechnique::build(const TechniqueFrame& frame) {
    if (oracle_ && builtFor_ == frame.plan.texels) return;
    oracle_ = std::make_unique<Oracle>(frame.plan);
    builtFor_ = frame.plan.texels;
}

void ReferenceTechnique::drawLookup(const TechniqueFrame& frame) {
    const gl::Texture& ids = frame.samples.ids();
    const auto triangles = gl::readTexture<std::uint32_t>(ids, GL_RED_INTEGER, GL_UNSIGNED_INT);
    const std::vector<OracleAnswer> answers = oracle_->answer(frame.plan, triangles);
    std::vector<float> lit(answers.size());
    for (std::size_t i = 0; i < lit.size(); ++i)
        lit[i] = !answers[i].hit || (answers[i].tested && answers[i].lit) ? 1.0f : 0.0f;
    const gl::Texture& visibility = frame.visibility.lit();
    glTextureSubImage3D(visibility.name(), 0, 0, 0, 0, visibility.width(), visibility.height(), visibility.layers(),
                        GL_RED, GL_FLOAT, lit.data());
}

}  // namespace timeshade
