#include "techniques/lookup_pass.h"

#include "techniques/technique.h"

namespace timeshade {

void LookupPass::forget() {
    drawn_ = seen_ = 0;
    dropKept();
}

void LookupPass::dropKept() {
    kept_ = 0;
    keepTarget_.reset();  // its attachments would keep the textures' memory
    keptLit_.reset();
    keptCells_.reset();
    reached_.reset();
    reachedTarget_.reset();
    depth_.reset();
}

void LookupPass::draw(const TechniqueFrame& frame, const ProgramFor& programFor) {
    used_ = true;
    const std::uint64_t key = frame.stillAnswers;
    const bool again = key != 0 && key == seen_;
    const bool nothingMoves = frame.plan.casters.nothingMoves() && frame.plan.camera.moving.empty();
    seen_ = key;
    if (nothingMoves && again && key == drawn_) {
        lastExtent_ = Extent::Nothing;
        return;
    }
    drawn_ = nothingMoves ? key : 0;
    if (!again || nothingMoves || !frame.stillIds) {
        dropKept();
        drawStrata(frame, programFor({}), target_, frame.samples.ids(), frame.visibility.lit(), nullptr);
        lastExtent_ = Extent::All;
        return;
    }
    if (kept_ != key) keep(frame, programFor);
    kept_ = key;
    drawReached(frame, programFor);
    lastExtent_ = Extent::Reached;
}

void LookupPass::drawStrata(const TechniqueFrame& frame, const gl::Program& program, const gl::Framebuffer& target, const gl::Texture& ids,
                            const gl::Texture& lit, const gl::Texture* cells) {
    ids.bind(SAMPLE_IDS_UNIT);
    program.use();
    target.setColorCount(cells ? 2 : 1);
    for (std::uint32_t stratum = 0; stratum < frame.plan.block.strata; ++stratum) {
        target.attach(GL_COLOR_ATTACHMENT0, lit, static_cast<int>(stratum));
        if (cells) target.attach(GL_COLOR_ATTACHMENT1, *cells, static_cast<int>(stratum));
        target.bindForDrawing(lit.width(), lit.height());
        glUniform1ui(0, stratum);
        frame.fullscreen.draw(program);
    }
}

void LookupPass::keep(const TechniqueFrame& frame, const ProgramFor& programFor) {
    const gl::Texture& lit = frame.visibility.lit();
    if (!keptLit_ || keptLit_->width() != lit.width() || keptLit_->height() != lit.height() || keptLit_->layers() != lit.layers()) {
        keptLit_ = gl::Texture::array2D("kept answers", GL_R32F, lit.width(), lit.height(), lit.layers());
        keptCells_ = gl::Texture::array2D("kept cells", GL_R16UI, lit.width(), lit.height(), lit.layers());
    }
    if (!keepTarget_) keepTarget_.emplace("kept answers target");
    drawStrata(frame, programFor({{"STILL_CASTERS_ALONE", "1"}, {"KEEP_STILL", "1"}}), *keepTarget_, *frame.stillIds, *keptLit_, &*keptCells_);
}

void LookupPass::drawReached(const TechniqueFrame& frame, const ProgramFor& programFor) {
    const gl::Texture& lit = frame.visibility.lit();
    glCopyImageSubData(keptLit_->name(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, lit.name(), GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, lit.width(), lit.height(),
                       lit.layers());
    constexpr int side = MovingMask::side;
    static_assert(side == REACHED_SIDE);
    if (!reached_) reached_ = gl::Texture::image2D("reached cells", GL_R8UI, side, side);
    const std::vector<std::uint8_t> nowhere(frame.plan.reached.cells.empty() ? std::size_t{side} * side : 0);
    glTextureSubImage2D(reached_->name(), 0, 0, 0, side, side, GL_RED_INTEGER, GL_UNSIGNED_BYTE,
                        nowhere.empty() ? frame.plan.reached.cells.data() : nowhere.data());
    // Two passes a stratum: the first marks the samples that are asked for in a depth buffer, so that the second, the technique's own, is not
    // even begun for the others.
    const gl::Program& marking = programs_.get({"reached samples", "passes/fullscreen.vert", "passes/reached.frag", {}});
    const gl::Program& asking = programFor({});
    if (!depth_ || depth_->width() != lit.width() || depth_->height() != lit.height()) {
        depth_ = gl::Texture::array2D("reached samples", GL_DEPTH_COMPONENT32F, lit.width(), lit.height(), 1);
        reachedTarget_.emplace("reached samples target");
        reachedTarget_->attach(GL_DEPTH_ATTACHMENT, *depth_);
    }
    frame.samples.ids().bind(SAMPLE_IDS_UNIT);
    frame.stillIds->bind(KEPT_IDS_UNIT);
    keptCells_->bind(KEPT_CELLS_UNIT);
    reached_->bind(REACHED_UNIT);
    glEnable(GL_DEPTH_TEST);
    for (std::uint32_t stratum = 0; stratum < frame.plan.block.strata; ++stratum) {
        reachedTarget_->setColorCount(0);
        reachedTarget_->bindForDrawing(lit.width(), lit.height());
        const float unmarked = 1.0f;
        glDepthMask(GL_TRUE);
        glClearNamedFramebufferfv(reachedTarget_->name(), GL_DEPTH, 0, &unmarked);
        glDepthFunc(GL_ALWAYS);
        marking.use();
        glUniform1ui(0, stratum);
        frame.fullscreen.draw(marking);
        reachedTarget_->attach(GL_COLOR_ATTACHMENT0, lit, static_cast<int>(stratum));
        reachedTarget_->setColorCount(1);
        reachedTarget_->bindForDrawing(lit.width(), lit.height());
        glDepthMask(GL_FALSE);
        glDepthFunc(GL_EQUAL);
        asking.use();
        glUniform1ui(0, stratum);
        frame.fullscreen.draw(asking);
    }
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_GREATER);
    glDisable(GL_DEPTH_TEST);
}

std::size_t LookupPass::bytes() const {
    std::size_t sum = 0;
    for (const auto* texture : {&keptLit_, &keptCells_, &reached_, &depth_}) sum += *texture ? (*texture)->bytes() : 0;
    return sum;
}

} // namespace timeshade
