#include "frame/lookup_pass.h"

#include <vector>

#include "core/work_part.h"
#include "gl/depth_equal.h"

namespace timeshade {

namespace {

const std::string bufferName = "lookup: buffer", staticName = "lookup: static", reachedName = "lookup: reached";

/// The widest filter for which DynamicCasterMask leaves room on each side, in texels.
constexpr double widestCachedFilter = 7.0;

bool mayCacheStatic(const Footprint& footprint) {
    return footprint.time == Footprint::Time::Instant && footprint.space == Footprint::Space::Point &&
           footprint.filterTexels <= widestCachedFilter;
}

}  // namespace

const gl::Program& programOf(gl::ProgramCache& programs, const TechniqueFrame& frame, const Lookup& lookup,
                             const LookupProgram& wanted, const gl::ShaderDefines& purpose) {
    gl::ShaderDefines defines = frame.defines();
    if (lookup.footprint.time == Footprint::Time::Stratum) defines.emplace_back("FOOTPRINT_STRATUM", "1");
    if (lookup.footprint.time == Footprint::Time::Shutter) defines.emplace_back("FOOTPRINT_SHUTTER", "1");
    for (const gl::ShaderDefines* more : {&purpose, &wanted.defines})
        defines.insert(defines.end(), more->begin(), more->end());
    return programs.get({wanted.label, "passes/fullscreen.vert", wanted.fragment, std::move(defines)});
}

LookupPass::StaticVisibility::StaticVisibility(int width, int height, int strata)
    : lit(gl::Texture::array2D("cached visibility", GL_R32F, width, height, strata)),
      cells(gl::Texture::image2D("cells of cached visibility", GL_RGBA16F, width, height)),
      target("cached visibility target") {
    target.setColorCount(2);
    target.attach(GL_COLOR_ATTACHMENT1, cells);
}

LookupPass::ReachedPixels::ReachedPixels(int width, int height)
    : cells(gl::Texture::image2D("reached cells", GL_R8UI, DynamicCasterMask::side, DynamicCasterMask::side)),
      depth(gl::Texture::array2D("reached pixels", GL_DEPTH_COMPONENT32F, width, height, 1)),
      target("reached pixels target") {
    target.attach(GL_DEPTH_ATTACHMENT, depth);
}

std::optional<StillPixels> LookupPass::draw(const TechniqueFrame& frame, const Lookup& lookup) {
    auto& buffer = caches_.entry<NoContent>(bufferName);
    const bool again = buffer.wantedAgain(lookup.key);
    const bool nothingMoves = frame.plan.casters.nothingMoves() && frame.plan.camera.dynamicTriangles.empty();
    if (nothingMoves && again && buffer.holds(lookup.key))
        return StillPixels{lookup.key, &frame.samples.ids(), &frame.visibility.lit(), nullptr};
    buffer.setKey(nothingMoves ? lookup.key : 0);
    if (again && !nothingMoves && lookup.staticIds != nullptr && mayCacheStatic(lookup.footprint))
        return drawReached(frame, lookup);
    const gl::Program& program = use(frame, lookup, Casters::All, {});
    frame.samples.ids().bind(SAMPLE_IDS_UNIT);
    target_.setColorCount(1);
    drawStrata(frame, program, target_, frame.visibility.lit());
    return std::nullopt;
}

/// The lookup's program with its inputs, in use.
const gl::Program& LookupPass::use(const TechniqueFrame& frame, const Lookup& lookup, Casters casters,
                                   const gl::ShaderDefines& purpose) {
    const LookupProgram wanted = lookup.program(casters);
    gl::ShaderDefines defines;
    if (casters == Casters::Static) defines.emplace_back("STATIC_CASTERS_ONLY", "1");
    defines.insert(defines.end(), purpose.begin(), purpose.end());
    const gl::Program& program = programOf(programs_, frame, lookup, wanted, defines);
    program.use(wanted.inputs);
    return program;
}

void LookupPass::drawStrata(const TechniqueFrame& frame, const gl::Program& program, const gl::Framebuffer& target,
                            const gl::Texture& lit) {
    for (std::uint32_t stratum = 0; stratum < frame.plan.block.strata; ++stratum) {
        const WorkPart part = workPart(static_cast<int>(stratum), static_cast<int>(frame.plan.block.strata));
        target.attach(GL_COLOR_ATTACHMENT0, lit, static_cast<int>(stratum));
        target.bindForDrawing(lit.width(), lit.height());
        program.set("stratum", stratum);
        frame.fullscreen.draw(program);
    }
}

LookupPass::StaticVisibility& LookupPass::staticVisibility(const TechniqueFrame& frame, const Lookup& lookup) {
    const gl::Texture& lit = frame.visibility.lit();
    auto& entry = caches_.entry<StaticVisibility>(staticName);
    const bool held = entry.holds(lookup.key);
    StaticVisibility& cached = entry.get(lit.width(), lit.height(), lit.layers());
    if (held) return cached;
    // Of the cells the least of all strata is kept.
    const GLfloat none[4] = {NO_CELL, NO_CELL, NO_CELL, NO_CELL};
    glClearTexImage(cached.cells.name(), 0, GL_RGBA, GL_FLOAT, none);
    const gl::Program& program = use(frame, lookup, Casters::Static, {{"CACHE_STATIC", "1"}});
    lookup.staticIds->bind(SAMPLE_IDS_UNIT);
    glEnablei(GL_BLEND, 1);
    glBlendEquationi(1, GL_MIN);
    drawStrata(frame, program, cached.target, cached.lit);
    glBlendEquationi(1, GL_FUNC_ADD);
    glDisablei(GL_BLEND, 1);
    entry.setKey(lookup.key);
    return cached;
}

/// Marks the pixels that are to be tested in a depth buffer, so that the technique's own program is not even begun for
/// the others.
void LookupPass::markReached(const TechniqueFrame& frame, const StaticVisibility& cached, ReachedPixels& reached) {
    constexpr int side = DynamicCasterMask::side;
    static_assert(side == REACHED_SIDE);
    const std::vector<std::uint8_t> nowhere(frame.plan.reached.cells.empty() ? std::size_t{side} * side : 0);
    glTextureSubImage2D(reached.cells.name(), 0, 0, 0, side, side, GL_RED_INTEGER, GL_UNSIGNED_BYTE,
                        nowhere.empty() ? frame.plan.reached.cells.data() : nowhere.data());
    gl::ShaderDefines defines;
    gl::Inputs inputs;
    inputs.texture("cachedCells", cached.cells).texture("reachedCells", reached.cells);
    if (const gl::Texture* dynamicPixels = frame.samples.dynamicPixels()) {
        defines.emplace_back("DYNAMIC_SEEN", "1");
        inputs.texture("dynamicPixels", *dynamicPixels);
    }
    const gl::Program& marking =
        programs_.get({"reached pixels", "passes/fullscreen.vert", "passes/reached.frag", defines});
    marking.use(inputs);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_ALWAYS);
    reached.target.setColorCount(0);
    reached.target.bindForDrawing(reached.depth.width(), reached.depth.height());
    const float unmarked = 1.0f;
    glClearNamedFramebufferfv(reached.target.name(), GL_DEPTH, 0, &unmarked);
    frame.fullscreen.draw(marking);
    glDepthFunc(GL_GREATER);
    glDisable(GL_DEPTH_TEST);
}

StillPixels LookupPass::drawReached(const TechniqueFrame& frame, const Lookup& lookup) {
    const StaticVisibility& cached = staticVisibility(frame, lookup);
    const gl::Texture& lit = frame.visibility.lit();
    glCopyImageSubData(cached.lit.name(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, lit.name(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0,
                       lit.width(), lit.height(), lit.layers());
    ReachedPixels& reached = caches_.entry<ReachedPixels>(reachedName).get(lit.width(), lit.height());
    markReached(frame, cached, reached);
    const gl::Program& program = use(frame, lookup, Casters::All, {});
    frame.samples.ids().bind(SAMPLE_IDS_UNIT);
    reached.target.setColorCount(1);
    const gl::DepthEqual reachedAlone;
    drawStrata(frame, program, reached.target, lit);
    reached.target.detach(GL_COLOR_ATTACHMENT0);
    return {lookup.key, lookup.staticIds, &cached.lit, &reached.target};
}

}  // namespace timeshade
