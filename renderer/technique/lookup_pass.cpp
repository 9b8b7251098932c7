#include "technique/lookup_pass.h"

#include "technique/technique.h"

namespace timeshade {

void LookupPass::forget() {
    drawn_ = seen_ = 0;
    dropCache();
}

void LookupPass::dropCache() {
    cached_ = 0;
    cacheTarget_.reset();  // its attachments would keep the textures' memory
    cachedLit_.reset();
    cachedCells_.reset();
    reached_.reset();
    reachedTarget_.reset();
    depth_.reset();
}

void LookupPass::draw(const TechniqueFrame& frame, const ProgramFor& programFor) {
    used_ = true;
    const std::uint64_t key = frame.staticVisibility;
    const bool again = key != 0 && key == seen_;
    const bool nothingMoves = frame.plan.casters.nothingMoves() && frame.plan.camera.dynamicTriangles.empty();
    seen_ = key;
    if (nothingMoves && again && key == drawn_) return;
    drawn_ = nothingMoves ? key : 0;
    if (!again || nothingMoves || !frame.staticIds) {
        dropCache();
        drawStrata(frame, programFor({}), target_, frame.samples.ids(), frame.visibility.lit(), nullptr);
        return;
    }
    if (cached_ != key) keep(frame, programFor);
    cached_ = key;
    drawReached(frame, programFor);
}

void LookupPass::drawStrata(const TechniqueFrame& frame, const gl::Program& program, const gl::Framebuffer& target,
                            const gl::Texture& ids, const gl::Texture& lit, const gl::Texture* cells) {
    ids.bind(SAMPLE_IDS_UNIT);
    program.use();
    target.setColorCount(cells ? 2 : 1);
    for (std::uint32_t stratum = 0; stratum < frame.plan.block.strata; ++stratum) {
        target.attach(GL_COLOR_ATTACHMENT0, lit, static_cast<int>(stratum));
        if (cells) target.attach(GL_COLOR_ATTACHMENT1, *cells);
        target.bindForDrawing(lit.width(), lit.height());
        glUniform1ui(0, stratum);
        frame.fullscreen.draw(program);
    }
}

void LookupPass::keep(const TechniqueFrame& frame, const ProgramFor& programFor) {
    const gl::Texture& lit = frame.visibility.lit();
    if (!cachedLit_ || cachedLit_->width() != lit.width() || cachedLit_->height() != lit.height() ||
        cachedLit_->layers() != lit.layers()) {
        cachedLit_ = gl::Texture::array2D("kept answers", GL_R32F, lit.width(), lit.height(), lit.layers());
        cachedCells_ = gl::Texture::image2D("kept cells", GL_RGBA16F, lit.width(), lit.height());
    }
    if (!cacheTarget_) cacheTarget_.emplace("kept answers target");
    // Of the cells the least of all strata is kept.
    const GLfloat none[4] = {NO_CELL, NO_CELL, NO_CELL, NO_CELL};
    glClearTexImage(cachedCells_->name(), 0, GL_RGBA, GL_FLOAT, none);
    const gl::Program& program = programFor({{"STATIC_CASTERS_ONLY", "1"}, {"CACHE_STATIC", "1"}});
    glEnablei(GL_BLEND, 1);
    glBlendEquationi(1, GL_MIN);
    drawStrata(frame, program, *cacheTarget_, *frame.staticIds, *cachedLit_, &*cachedCells_);
    glBlendEquationi(1, GL_FUNC_ADD);
    glDisablei(GL_BLEND, 1);
}

void LookupPass::drawReached(const TechniqueFrame& frame, const ProgramFor& programFor) {
    const gl::Texture& lit = frame.visibility.lit();
    glCopyImageSubData(cachedLit_->name(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, lit.name(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0,
                       lit.width(), lit.height(), lit.layers());
    constexpr int side = DynamicCasterMask::side;
    static_assert(side == REACHED_SIDE);
    if (!reached_) reached_ = gl::Texture::image2D("reached cells", GL_R8UI, side, side);
    const std::vector<std::uint8_t> nowhere(frame.plan.reached.cells.empty() ? std::size_t{side} * side : 0);
    glTextureSubImage2D(reached_->name(), 0, 0, 0, side, side, GL_RED_INTEGER, GL_UNSIGNED_BYTE,
                        nowhere.empty() ? frame.plan.reached.cells.data() : nowhere.data());
    // First the pixels that are asked for are marked in a depth buffer, so that the technique's own program is not even
    // begun for the others.
    gl::ShaderDefines defines;
    if (frame.dynamicPixels) defines.emplace_back("DYNAMIC_SEEN", "1");
    const gl::Program& marking =
        programs_.get({"reached pixels", "passes/fullscreen.vert", "passes/reached.frag", defines});
    const gl::Program& asking = programFor({});
    if (!depth_ || depth_->width() != lit.width() || depth_->height() != lit.height()) {
        depth_ = gl::Texture::array2D("reached pixels", GL_DEPTH_COMPONENT32F, lit.width(), lit.height(), 1);
        reachedTarget_.emplace("reached pixels target");
        reachedTarget_->attach(GL_DEPTH_ATTACHMENT, *depth_);
    }
    frame.samples.ids().bind(SAMPLE_IDS_UNIT);
    if (frame.dynamicPixels) frame.dynamicPixels->bind(DYNAMIC_PIXELS_UNIT);
    cachedCells_->bind(CACHED_CELLS_UNIT);
    reached_->bind(REACHED_UNIT);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_ALWAYS);
    reachedTarget_->setColorCount(0);
    reachedTarget_->bindForDrawing(lit.width(), lit.height());
    const float unmarked = 1.0f;
    glClearNamedFramebufferfv(reachedTarget_->name(), GL_DEPTH, 0, &unmarked);
    frame.fullscreen.draw(marking);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_EQUAL);
    reachedTarget_->setColorCount(1);
    asking.use();
    for (std::uint32_t stratum = 0; stratum < frame.plan.block.strata; ++stratum) {
        reachedTarget_->attach(GL_COLOR_ATTACHMENT0, lit, static_cast<int>(stratum));
        reachedTarget_->bindForDrawing(lit.width(), lit.height());
        glUniform1ui(0, stratum);
        frame.fullscreen.draw(asking);
    }
    reachedTarget_->detach(GL_COLOR_ATTACHMENT0);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_GREATER);
    glDisable(GL_DEPTH_TEST);
}

std::size_t LookupPass::bytes() const {
    std::size_t sum = 0;
    for (const auto* texture : {&cachedLit_, &cachedCells_, &reached_, &depth_})
        sum += *texture ? (*texture)->bytes() : 0;
    return sum;
}

}  // namespace timeshade
