#include "support/drawn_view.h"

#include "passes/frame_uniforms.h"
#include "support/gl_environment.h"

namespace timeshade {

std::vector<float> drawnView(const FramePlan& plan, Technique& technique, const std::string& name) {
    const int width = plan.request.width, height = plan.request.height, strata = plan.request.samplesPerPixel;
    FrameUniforms uniforms;
    Fullscreen fullscreen;
    GpuMesh mesh;
    SamplePass samplePass(sharedRenderer().programs());
    const SampleBuffer samples(width, height, strata);
    const VisibilityBuffer visibility(width, height, strata);
    gl::PassTimer timer(gl::PassTimer::Clock::Finish);
    mesh.update(plan);
    uniforms.set(plan);
    mesh.bind();
    samplePass.draw(plan, mesh, samples);
    LookupPass lookup(sharedRenderer().programs());
    const TechniqueFrame frame{plan, mesh, samples, visibility, fullscreen, timer, lookup};
    technique.build(frame);
    technique.lookup(frame);
    const gl::Texture values = gl::Texture::image2D("view values", GL_R32F, width, height);
    technique.drawView(frame, name, values);
    std::vector<float> read(values.bytes() / sizeof(float));
    glGetTextureImage(values.name(), 0, GL_RED, GL_FLOAT, static_cast<GLsizei>(values.bytes()), read.data());
    return read;
}

}  // namespace timeshade
