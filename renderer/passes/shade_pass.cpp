#include "passes/shade_pass.h"

#include "core/hash.h"
#include "gl/depth_equal.h"
#include "shared/shutter_response.shared.h"

namespace timeshade {

namespace {

const std::string colourName = "shade: still";

struct StillColours {
    StillColours(int width, int height) : colours(gl::Texture::image2D("still colours", GL_RGBA32F, width, height)) {}
    std::size_t bytes() const { return colours.bytes(); }
    gl::Texture colours;
};

/// What of the frame itself decides how it is shaded.
gl::ShaderDefines definesOf(const FramePlan& plan, View view) {
    gl::ShaderDefines defines;
    if (plan.camera.turns) defines.emplace_back("CAMERA_TURNS", "1");
    if (view == View::Visibility) {
        defines.emplace_back("VIEW_VISIBILITY", "1");
        return defines;
    }
    if (!plan.mesh->topology->colours.empty()) defines.emplace_back("VERTEX_COLOURS", "1");
    if (!plan.mesh->topology->moreCoordinates.empty()) defines.emplace_back("MORE_COORDINATES", "1");
    return defines;
}

}  // namespace

const gl::Program& ShadePass::programOf(const FramePlan& plan, View view) {
    gl::ShaderDefines defines = definesOf(plan, view);
    // A single sample is its own mean.
    if (plan.block.response != SHUTTER_BOX && plan.block.wholeStrata > 1) defines.emplace_back("SHUTTER_WEIGHTS", "1");
    return programs_.get({"shade", "passes/fullscreen.vert", "passes/shade.frag", defines});
}

void ShadePass::drawOntoStill(const FramePlan& plan, const Fullscreen& fullscreen, const SampleBuffer& samples,
                              const VisibilityBuffer& visibility, View view, const StillPixels& still,
                              const gl::Texture& radiance) {
    const int width = radiance.width(), height = radiance.height();
    const gl::Program& program = programOf(plan, view);
    auto& entry = caches_.entry<StillColours>(colourName);
    const CacheKey key =
        Hash().add(still.key).add(plan.versions.shading).add(static_cast<std::uint64_t>(view)).value() | 1;
    const bool held = entry.holds(key);
    const gl::Texture& colours = entry.get(width, height).colours;
    if (!held) {
        still.ids->bind(SAMPLE_IDS_UNIT);
        still.lit->bind(VISIBILITY_UNIT);
        target_.attach(GL_COLOR_ATTACHMENT0, colours);
        target_.setColorCount(1);
        target_.bindForDrawing(width, height);
        fullscreen.draw(program);
        entry.setKey(key);
    }
    glCopyImageSubData(colours.name(), GL_TEXTURE_2D, 0, 0, 0, 0, radiance.name(), GL_TEXTURE_2D, 0, 0, 0, 0, width,
                       height, 1);
    if (still.others == nullptr) return;
    samples.ids().bind(SAMPLE_IDS_UNIT);
    visibility.lit().bind(VISIBILITY_UNIT);
    still.others->setColorCount(1);
    still.others->attach(GL_COLOR_ATTACHMENT0, radiance);
    still.others->bindForDrawing(width, height);
    const gl::DepthEqual othersAlone;
    fullscreen.draw(program);
    still.others->detach(GL_COLOR_ATTACHMENT0);
}

void ShadePass::draw(const FramePlan& plan, const Fullscreen& fullscreen, const SampleBuffer& samples,
                     const VisibilityBuffer& visibility, View view, bool add, const gl::Texture& radiance) {
    const gl::Program& program = programOf(plan, view);
    samples.ids().bind(SAMPLE_IDS_UNIT);
    visibility.lit().bind(VISIBILITY_UNIT);
    target_.attach(GL_COLOR_ATTACHMENT0, radiance);
    target_.setColorCount(1);
    target_.bindForDrawing(radiance.width(), radiance.height());
    if (add) {
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
    }
    fullscreen.draw(program);
    glDisable(GL_BLEND);
}

void ShadePass::draw(const FramePlan& plan, const Fullscreen& fullscreen, const Parts& parts, View view,
                     const gl::Texture& radiance) {
    gl::ShaderDefines defines = definesOf(plan, view);
    defines.emplace_back("INTERVAL_SAMPLES", "1");
    if (parts.solved) defines.emplace_back("SOLVES_INTERVALS", "1");
    const gl::Program& program =
        programs_.get({"shade intervals", "passes/fullscreen.vert", "passes/shade.frag", defines});
    gl::Inputs inputs;
    inputs.texture("seenParts", parts.parts)
        .texture("partsOfPositions", parts.heads)
        .texture("visibilityOfParts", parts.values);
    program.use(inputs);
    target_.attach(GL_COLOR_ATTACHMENT0, radiance);
    target_.setColorCount(1);
    target_.bindForDrawing(radiance.width(), radiance.height());
    fullscreen.draw(program);
}

}  // namespace timeshade
