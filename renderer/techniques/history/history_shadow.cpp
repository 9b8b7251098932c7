#include "techniques/history/history_shadow.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "technique/technique_entry.h"
#include "techniques/history/exposed_instant.h"
#include "techniques/history/map_raster.h"

namespace timeshade {

namespace {

/// Frames' worth of weight that the past brings while the camera moves: long enough against flicker, short enough to
/// follow.
constexpr float movingCameraMemory = 8.0f;
constexpr float standingCameraMemory = 4096.0f;
/// So many frames after the last movement every pixel has had tests enough to rest; then those that are due in four
/// frames are asked in one, since the map costs as much as they.
constexpr int framesToConverge = 12, framesAtOnce = 4;
/// How fast what is shown is drawn to 0 and 1 once the camera stands: with the square of the frames.
constexpr float sharpenPerFrame = 1.0f;

/// Columns right, up, corner.
glm::mat4 raysOf(const ViewEnd& end) {
    return glm::mat4(glm::dmat4(glm::dvec4(end.right, 0.0), glm::dvec4(end.up, 0.0), glm::dvec4(end.corner, 0.0),
                                glm::dvec4(0.0, 0.0, 0.0, 1.0)));
}

/// Every sample of a pixel has the same truth, 0 or 1, whatever instant the map is of.
bool hardShadows(const FramePlan& plan) {
    return plan.block.strata == 1 && plan.motion.movingTriangles == 0 && !plan.motion.lightMoves &&
           !plan.motion.cameraMoves;
}

}  // namespace

std::vector<double> HistoryShadow::settingValues() {
    std::vector<double> values;
    for (const Setting& setting : settingsOf(*this)) values.push_back(setting.get());
    return values;
}

void HistoryShadow::allocate(const FramePlan& plan) {
    const int width = plan.request.width, height = plan.request.height;
    for (auto& buffer : buffers_)
        if (!buffer || buffer->width() != width || buffer->height() != height || holdsHalves_ != asPublished_) {
            buffer = gl::Texture::image2D("history", asPublished_ ? GL_RGBA16F : GL_RGBA32F, width, height);
            glClearTexImage(buffer->name(), 0, GL_RGBA, GL_FLOAT, nullptr);
        }
    holdsHalves_ = asPublished_;
    if (!map_ || map_->keepsTriangles() != triesTriangles()) map_.emplace(programs_, triesTriangles());
    if (!mask_) mask_.emplace(programs_);
    if (!block_) block_.emplace("history block", sizeof(shared::HistoryBlock));
    if (!target_) target_.emplace("history target");
    if (!tested_) tested_.emplace("pixels tested");
}

/// The triangles as they were, for finding a receiver's place a frame ago.
void HistoryShadow::uploadPrevious() {
    const std::shared_ptr<const MeshTexels>& texels = state_.before()->texels;
    if (uploadedPrevious_ != texels) {
        const std::span<const glm::vec4> positions(texels->positions);
        if (!previous_ || previous_->bytes() != positions.size_bytes()) {
            previous_.emplace("previous triangle positions", positions.size_bytes());
            previousView_ = gl::Texture::ofBuffer("previous triangle positions", GL_RGBA32F, *previous_);
        }
        previous_->upload(positions);
        uploadedPrevious_ = texels;
    }
}

/// Defines of techniques/history/map_test.glsl.
gl::ShaderDefines HistoryShadow::mapTestDefines(const TechniqueFrame& frame) const {
    gl::ShaderDefines defines = frame.defines();
    if (triesTriangles()) defines.emplace_back("TRIES_TRIANGLES", "1");
    return defines;
}

shared::HistoryBlock HistoryShadow::blockOf(const FramePlan& plan) const {
    shared::HistoryBlock block{};
    const glm::dmat3 mapFromPlane = mapRaster(plan, fit(), jitter(), transition_.index).mapFromPlane;
    block.mapFromPlane = glm::mat4(glm::mat3(mapFromPlane));
    block.planeFromMap = glm::mat4(glm::mat3(glm::inverse(mapFromPlane)));
    if (const HistoryState::Past* before = state_.before()) {
        block.previousRaysOpen = raysOf(before->camera.open);
        block.previousRaysClose = raysOf(before->camera.close);
        block.previousEyeOpen = glm::vec4(glm::dvec4(before->camera.open.eye, 0.0));
        block.previousEyeClose = glm::vec4(glm::dvec4(before->camera.close.eye, 0.0));
        block.previousNear = before->camera.block.nearDistance;
    }
    // Where time goes on the middle of the shutter is nearest to all of it; a moment that is held is seen as a whole.
    const double u = asPublished_ || transition_.heldFrames == 0
                         ? 0.5
                         : exposedInstant(plan.block, radicalInverse(7, std::uint32_t(transition_.heldFrames)));
    block.instant =
        plan.block.timeBase + static_cast<float>(u) * static_cast<float>(plan.block.strata) * plan.block.timeScale;
    const auto still = static_cast<float>(transition_.staticFrames);
    block.exponent = std::min(std::max(m_, mStill_), m_ + 0.1f * mStep_ * still);
    block.weightScale = shared::confidenceWeightScale(block.exponent);
    // What a moving camera has gathered is blurred: once it stands, that counts no more than one frame.
    block.memory = transition_.cameraMoved     ? movingCameraMemory
                   : transition_.cameraStopped ? 1.0f
                                               : standingCameraMemory;
    block.sharpness =
        hardShadows(plan) && pcfRadius_ == 0 ? std::min(sharpen_, 1.0f + sharpenPerFrame * still * still) : 1.0f;
    block.threshold = 1e-3f * threshold_;
    block.hasPast = (asPublished_ ? state_.before() != nullptr : transition_.hasPast) ? 1u : 0u;
    block.triesTriangles = triesTriangles() ? 1u : 0u;
    // Then every instant of the shutter has the same answer.
    block.keepsProof = keepsProof(plan) ? 1u : 0u;
    block.mayConverge = mayConverge(plan) ? 1u : 0u;
    block.framesDue = static_cast<std::uint32_t>(framesDue_);
    block.round = static_cast<std::uint32_t>(transition_.staticFrames);
    block.awaitsProof = block.keepsProof != 0u && transition_.staticFrames > 0 ? 1u : 0u;
    block.dynamicMaskSize = transition_.dynamicCasters.empty() || asPublished_
                                ? 0.0f
                                : static_cast<float>(DynamicMask::sideFor(plan.request.mapSize.longerSide()));
    return block;
}

/// Whether a pixel may be known well enough not to be asked in each of the following frames. While a moment with motion
/// in it is held every instant may have another answer.
bool HistoryShadow::mayConverge(const FramePlan& plan) const {
    return triesTriangles() && transition_.staticFrames > 0 &&
           !(transition_.heldFrames > 0 && (plan.motion.movingTriangles > 0 || plan.motion.lightMoves));
}

bool HistoryShadow::keepsProof(const FramePlan& plan) const {
    return triesTriangles() && plan.block.strata == 1 && plan.motion.movingTriangles == 0 && !plan.motion.lightMoves;
}

int HistoryShadow::framesDue(const FramePlan& plan) const {
    if (!mayConverge(plan) || !converged_ || !converged_->known()) return 1;
    if (transition_.unmovedFrames >= framesToSettle) return 0;
    if (keepsProof(plan) || transition_.unmovedFrames < framesToConverge) return 1;
    return transition_.unmovedFrames % framesAtOnce == 0 ? framesAtOnce : 0;
}

void HistoryShadow::forget() {
    state_.forget();
    if (converged_) converged_->forget();
    target_.reset();  // a draw that was given up leaves textures attached
}

void HistoryShadow::build(const TechniqueFrame& frame) {
    allocate(frame.plan);
    transition_ = state_.follow(frame.plan, settingValues());
    framesDue_ = framesDue(frame.plan);
    if (framesDue_ == 0) return;
    const shared::HistoryBlock block = blockOf(frame.plan);
    block_->upload(std::span<const shared::HistoryBlock>(&block, 1));
    glBindBufferBase(GL_UNIFORM_BUFFER, TECHNIQUE_BLOCK_BINDING, block_->name());
    if (transition_.moved && !asPublished_) uploadPrevious();
    if (block.dynamicMaskSize > 0.0f) {
        const auto timed = frame.timer.scope("build/mask");
        mask_->draw(frame, *previousView_, transition_.dynamicCasters);
    }
    map_->draw(frame.plan, frame.mesh, block.instant, glm::mat3(block.mapFromPlane));
}

/// As the paper has it: every pixel in every frame.
void HistoryShadow::drawPublished(const TechniqueFrame& frame) {
    converged_.reset();
    current_ = 1 - current_;
    const gl::Program& program = programs_.get({"history lookup as published", "passes/fullscreen.vert",
                                                "techniques/history/published.frag", frame.defines()});
    program.use(gl::Inputs()
                    .texture("shadowMap", map_->depth())
                    .texture("past", *buffers_[1 - current_])
                    .texture("visibility", frame.visibility.lit()));
    drawTested(frame, program, 1);
}

/// Draws the lookup's pixels into the history, and counts them.
void HistoryShadow::drawTested(const TechniqueFrame& frame, const gl::Program& program, int colors) {
    frame.samples.ids().bind(SAMPLE_IDS_UNIT);
    target_->setColorCount(colors);
    target_->attach(GL_COLOR_ATTACHMENT0, *buffers_[current_]);
    target_->bindForDrawing(buffers_[current_]->width(), buffers_[current_]->height());
    frame.fullscreen.draw(program, &*tested_);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT |
                    GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void HistoryShadow::drawLookup(const TechniqueFrame& frame) {
    if (asPublished_) return drawPublished(frame);
    if (framesDue_ == 0) return converged_->show(frame);
    const bool converges = mayConverge(frame.plan);
    if (!converges) {
        converged_.reset();
    } else {
        if (!converged_) converged_.emplace(programs_);
        converged_->allocate(frame);
        if (!transition_.hasPast) converged_->forget();
    }
    const bool invalidates = converges && converged_->known();
    if (invalidates) {
        invalidateConverged(frame);
    } else {
        current_ = 1 - current_;
    }
    gl::ShaderDefines defines = mapTestDefines(frame);
    if (transition_.moved) defines.emplace_back("MOVED", "1");
    const gl::Program& program =
        programs_.get({"history lookup", "passes/fullscreen.vert", "techniques/history/lookup.frag", defines});
    program.use(lookupInputs().texture("visibility", converges ? converged_->lit() : frame.visibility.lit()));
    if (converges) target_->attach(GL_COLOR_ATTACHMENT1, converged_->periods());
    if (invalidates) target_->attach(GL_DEPTH_ATTACHMENT, converged_->marks());
    drawTested(frame, program, converges ? 2 : 1);
    if (converges) target_->detach(GL_COLOR_ATTACHMENT1);
    if (invalidates) {
        target_->detach(GL_DEPTH_ATTACHMENT);
        glDepthMask(GL_TRUE);
        glDepthFunc(GL_GREATER);
        glDisable(GL_DEPTH_TEST);
    }
    if (converges) converged_->show(frame);
}

/// Marks the pixels that are tested in this frame; the others keep what they have.
void HistoryShadow::invalidateConverged(const TechniqueFrame& frame) {
    if (masksDynamicCasters())
        converged_->invalidate(frame, *buffers_[current_],
                               ConvergedPixels::DynamicCasters{mask_->depth(), mask_->flags()});
    else
        converged_->invalidate(frame, *buffers_[current_], std::nullopt);
    // A pixel that is tested may want to read what another one is about to overwrite.
    glCopyImageSubData(buffers_[current_]->name(), GL_TEXTURE_2D, 0, 0, 0, 0, buffers_[1 - current_]->name(),
                       GL_TEXTURE_2D, 0, 0, 0, 0, buffers_[current_]->width(), buffers_[current_]->height(), 1);
}

gl::Inputs HistoryShadow::lookupInputs() const {
    gl::Inputs inputs;
    inputs.texture("shadowMap", map_->depth()).texture("past", *buffers_[1 - current_]);
    if (map_->keepsTriangles()) inputs.texture("mapTriangles", map_->triangles());
    if (!transition_.moved) return inputs;
    const bool masked = masksDynamicCasters();
    inputs.texture("previousPositions", *previousView_)
        .texture("dynamicMask", masked ? mask_->depth() : map_->depth());  // not read where nothing is masked
    if (masked) inputs.texture("dynamicFlags", mask_->flags());
    return inputs;
}

void HistoryShadow::drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values) {
    const std::vector<TechniqueView> shown = views();
    const auto found =
        std::find_if(shown.begin(), shown.end(), [&](const TechniqueView& view) { return view.name == name; });
    if (found == shown.end() || !map_) return Technique::drawView(frame, name, values);
    const gl::Program& program = programs_.get(
        {"history view", "passes/fullscreen.vert", "techniques/history/view.frag", mapTestDefines(frame)});
    glBindBufferBase(GL_UNIFORM_BUFFER, TECHNIQUE_BLOCK_BINDING, block_->name());
    frame.samples.ids().bind(SAMPLE_IDS_UNIT);
    gl::Inputs inputs;
    inputs.texture("shadowMap", map_->depth()).texture("written", *buffers_[current_]);
    if (map_->keepsTriangles()) inputs.texture("mapTriangles", map_->triangles());
    program.use(inputs.set("view", static_cast<std::uint32_t>(found - shown.begin())));
    target_->setColorCount(1);
    target_->attach(GL_COLOR_ATTACHMENT0, values);
    target_->bindForDrawing(values.width(), values.height());
    frame.fullscreen.draw(program);
}

StoredAlongLine HistoryShadow::storedAlong(const TechniqueFrame&, const MapLine&) {
    return {{}, "nothing along a line: each pixel keeps the mean of its tests, and each frame's map is turned anew"};
}

std::vector<TechniqueStatistic> HistoryShadow::statistics() const {
    return {{"frames with a still camera", static_cast<double>(transition_.staticFrames), "frames", ""},
            {"dynamic triangles", static_cast<double>(transition_.dynamicCasters.size()), "triangles", ""},
            {"pixels tested", tested_ && framesDue_ > 0 ? static_cast<double>(tested_->read()) : 0.0, "pixels", ""}};
}

std::vector<const gl::Texture*> HistoryShadow::textures() const {
    std::vector<const gl::Texture*> all;
    if (map_) all.push_back(&map_->depth());
    if (buffers_[current_]) all.push_back(&*buffers_[current_]);
    return all;
}

std::size_t HistoryShadow::bytes() const {
    std::size_t sum = (map_ ? map_->bytes() : 0) + (mask_ ? mask_->bytes() : 0) +
                      (converged_ ? converged_->bytes() : 0) + (block_ ? block_->bytes() : 0) +
                      (previous_ ? previous_->bytes() : 0);
    for (const auto& buffer : buffers_) sum += buffer ? buffer->bytes() : 0;
    return sum;
}

TechniqueEntry historyTechnique() { return entryOf<HistoryShadow>(); }

}  // namespace timeshade
