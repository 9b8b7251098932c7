#include "techniques/history/history_shadow.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "technique/technique_entry.h"
#include "techniques/history/exposed_instant.h"
#include "techniques/history/fitted_map_prediction.h"
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

constexpr const char* confidenceView = "confidence";
constexpr const char* lengthView = "history-length";
constexpr const char* rejectedView = "rejected";

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

const TechniqueDescription& HistoryShadow::describe() {
    static const TechniqueDescription description{
        .name = "history",
        .title = "History buffer with confidence",
        .shortTitle = "History",
        .summary =
            "A coarse map whose raster changes every frame; each pixel keeps what earlier frames' tests were sure of: "
            "converges to pixel-sharp shadows where nothing moves.",
        .source = "Scherzer, Jeschke, Wimmer 2007",
        .wrong =
            "Motion: where a shadow may have changed, the past is dropped and the pixel begins again, so that fast "
            "casters have rough shadows.",
        .look = "chess: let it play, then stop; edges sharpen while nothing moves.",
        .picture = "chess while the queen slides: left history with a map of 256, right ground truth.",
        .references = {"D. Scherzer, S. Jeschke, M. Wimmer 2007: Pixel-correct shadow maps with temporal reprojection "
                       "and shadow test confidence. Eurographics Symposium on Rendering."},
    };
    return description;
}

void HistoryShadow::visitSettings(SettingsVisitor& visitor) {
    visitor.number(
        "m", m_, 3.0, 0.0, 32.0, "exponent",
        "Exponent of the confidence while the camera moves (equation 6). More trusts sure tests alone: sharper, and "
        "slower to settle.");
    visitor.number("m_still", mStill_, 15.0, 0.0, 64.0, "exponent", "The exponent that a still camera comes to.");
    visitor.number("m_step", mStep_, 1.0, 0.0, 640.0, "exponent in ten frames",
                   "How fast the exponent rises once the camera stands.");
    visitor.choice("jitter", jitter_, 1, {"none", "shift", "shift-and-rotate"},
                   "How the map's raster changes from frame to frame: shifted within a texel, or rotated, too. The "
                   "paper needs the latter; its repaired form converges faster with shifts alone, which are spread "
                   "evenly for every pixel.");
    visitor.choice("fit", fit_, 1, {"whole-light", "camera-view", "lispsm"},
                   "What the map covers: all that the light reaches; what the camera sees of it; or that, with more "
                   "texels for what is near (light space perspective shadow maps).");
    visitor.number("bias", bias_, 0.0625, 0.0, 16.0, "texels",
                   "How much nearer to the light a caster must be before it counts. The test is made on the receiver's "
                   "own plane at "
                   "the texel's centre, so that little is enough; as published 0.5 is usual.");
    visitor.number(
        "slope_bias", slopeBias_, 1.0, 0.0, 8.0, "half texels of slope",
        "As published only: further bias in proportion to how steeply the surface falls away from the light.");
    visitor.whole("pcf_radius", pcfRadius_, 0, 0, 3, "texels",
                  "Percentage-closer filtering of each frame's test over (2n + 1) x (2n + 1) texels: soft edges; 0 "
                  "switches it off.");
    visitor.number("threshold", threshold_, 2.0, 0.0, 1000.0, "thousandths of the distance",
                   "How far a pixel's past may lie off the receiver's plane (as published: how far its depth may "
                   "differ) before it is "
                   "taken for another surface's.");
    visitor.number("sharpen", sharpen_, 256.0, 1.0, 4096.0, "times",
                   "With one sample a pixel and nothing moving, what is shown is drawn away from one half by up to "
                   "this factor once the "
                   "camera stands; hard shadows know only 0 and 1. 1 switches it off.");
    visitor.toggle("try_triangles", tryTriangles_, true,
                   "The triangles that the map saw around a receiver are tried against its own ray to the light, so "
                   "that edges are sharp whatever the "
                   "texels. Costs 4 bytes a texel of the map. Not with PCF.");
    visitor.toggle("as_published", asPublished_, false,
                   "Exponential smoothing in 16-bit numbers, bilinear lookup judged as a whole, depths compared, "
                   "nothing known of motion.");
    visitor.whole("warm_up", warmUp_, 16, 0, 64, "frames",
                  "How many frames before a headless picture are drawn to fill the history.");
    visitor.whole(
        "hold", hold_, 0, 0, 240, "frames",
        "How many times a headless picture's own frame is drawn beforehand, as when a window stands still on it.");
}

/// Every sample of a pixel is handed the pixel's share.
Footprint HistoryShadow::footprint() const {
    Footprint footprint;
    footprint.time = Footprint::Time::Shutter;
    footprint.space = Footprint::Space::PixelSurface;
    footprint.filterTexels = pcfRadius_ > 0 ? 2.0 * pcfRadius_ + 1.0 : 0.0;
    return footprint;
}

SamplingTraits HistoryShadow::samplingTraits() const {
    // Which triangles a texel has seen depends on how a surface is cut.
    return {.times = SamplingTraits::Times::OneInstant,
            .texelCentres = true,
            .biasTexels = static_cast<double>(bias_),
            .triangulationError = triesTriangles() ? 0.005 : 0.0};
}

std::shared_ptr<const Prediction> HistoryShadow::prediction() const {
    return fit_ != 0 ? std::make_shared<FittedMapPrediction>() : Technique::prediction();
}

std::vector<PassDecision> HistoryShadow::passes(const FramePlan& plan) const {
    static constexpr const char* rasters[] = {"the same raster every frame", "a raster shifted within a texel",
                                              "a raster shifted and turned"};
    std::vector<PassDecision> passes{
        {"history",
         fmt::format("{} frames before the picture's and {} repetitions of it are drawn first; 2 x 16 bytes a pixel, "
                     "and 8 + 4 a sample while the camera stands",
                     warmUp_, hold_),
         0},
        {"build",
         fmt::format("one ordinary shadow map with {}, at u = 0.5 where time goes on{}", rasters[jitter_],
                     triesTriangles() ? "; 8 bytes a texel, with its triangles" : ""),
         plan.motion.triangles}};
    if (!asPublished_ && plan.motion.movingTriangles > 0)
        passes.push_back(
            {"mask", "what moves, seen from the light: pixels behind it lose their past", plan.motion.movingTriangles});
    if (!asPublished_ && plan.motion.lightMoves)
        passes.push_back({"mask", "the light moves: every frame begins anew", 0});
    passes.push_back({"lookup",
                      triesTriangles() ? "all samples of a pixel against that map, merged with the pixel's past; while "
                                         "the camera stands, of pixels that still learn"
                                       : "all samples of a pixel against that map, merged with the pixel's past",
                      0});
    return passes;
}

std::vector<double> HistoryShadow::settingValues() {
    std::vector<double> values;
    for (const Setting& setting : settingsOf(*this)) values.push_back(setting.get());
    return values;
}

void HistoryShadow::allocate(const FramePlan& plan) {
    const int width = plan.request.width, height = plan.request.height;
    for (auto& buffer : buffers_)
        if (!buffer || buffer->width() != width || buffer->height() != height) {
            buffer = gl::Texture::image2D("history", GL_RGBA32F, width, height);
            glClearTexImage(buffer->name(), 0, GL_RGBA, GL_FLOAT, nullptr);
        }
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
    const glm::dmat3 mapFromPlane =
        mapRaster(plan, static_cast<MapFit>(fit_), static_cast<MapJitter>(jitter_), transition_.index);
    block.mapFromPlane = glm::mat4(glm::mat3(mapFromPlane));
    block.planeFromMap = glm::mat4(glm::mat3(glm::inverse(mapFromPlane)));
    if (const HistoryState::Past* before = state_.before()) {
        block.previousRaysOpen = raysOf(before->camera.open);
        block.previousRaysClose = raysOf(before->camera.close);
        block.previousEyeOpen = glm::vec4(glm::dvec4(before->camera.open.eye, 0.0));
        block.previousEyeClose = glm::vec4(glm::dvec4(before->camera.close.eye, 0.0));
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
                                : static_cast<float>(DynamicMask::sideFor(plan.request.mapSize));
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
}

void HistoryShadow::build(const TechniqueFrame& frame) {
    allocate(frame.plan);
    transition_ = state_.follow(frame.plan, settingValues());
    framesDue_ = framesDue(frame.plan);
    if (framesDue_ == 0) return;
    const shared::HistoryBlock block = blockOf(frame.plan);
    block_->upload(std::span<const shared::HistoryBlock>(&block, 1));
    glBindBufferBase(GL_UNIFORM_BUFFER, TECHNIQUE_BLOCK_BINDING, block_->name());
    if (transition_.moved) uploadPrevious();
    if (block.dynamicMaskSize > 0.0f) {
        const auto timed = frame.timer.scope("build/mask");
        mask_->draw(frame, *previousView_, transition_.dynamicCasters);
    }
    map_->draw(frame.plan, frame.mesh, block.instant, glm::mat3(block.mapFromPlane));
}

void HistoryShadow::drawLookup(const TechniqueFrame& frame) {
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
    frame.samples.ids().bind(SAMPLE_IDS_UNIT);
    target_->setColorCount(converges ? 2 : 1);
    target_->attach(GL_COLOR_ATTACHMENT0, *buffers_[current_]);
    if (converges) target_->attach(GL_COLOR_ATTACHMENT1, converged_->periods());
    if (invalidates) target_->attach(GL_DEPTH_ATTACHMENT, converged_->marks());
    target_->bindForDrawing(buffers_[current_]->width(), buffers_[current_]->height());
    tested_->begin();
    frame.fullscreen.draw(program);
    tested_->end();
    if (converges) target_->detach(GL_COLOR_ATTACHMENT1);
    if (invalidates) {
        target_->detach(GL_DEPTH_ATTACHMENT);
        glDepthMask(GL_TRUE);
        glDepthFunc(GL_GREATER);
        glDisable(GL_DEPTH_TEST);
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT |
                    GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
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

std::vector<TechniqueView> HistoryShadow::views() const {
    return {{confidenceView, "Confidence of this frame's tests", "", 0.0, 1.0, false},
            {lengthView, "Frames in the history", "frames", 1.0, 256.0, true},
            {rejectedView, "Past rejected", "", 0.0, 1.0, false}};
}

void HistoryShadow::drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values) {
    const auto names = {confidenceView, lengthView, rejectedView};
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end() || !map_) return Technique::drawView(frame, name, values);
    const gl::Program& program = programs_.get(
        {"history view", "passes/fullscreen.vert", "techniques/history/view.frag", mapTestDefines(frame)});
    glBindBufferBase(GL_UNIFORM_BUFFER, TECHNIQUE_BLOCK_BINDING, block_->name());
    frame.samples.ids().bind(SAMPLE_IDS_UNIT);
    gl::Inputs inputs;
    inputs.texture("shadowMap", map_->depth()).texture("written", *buffers_[current_]);
    if (map_->keepsTriangles()) inputs.texture("mapTriangles", map_->triangles());
    program.use(inputs.set("view", static_cast<std::uint32_t>(found - names.begin())));
    target_->setColorCount(1);
    target_->attach(GL_COLOR_ATTACHMENT0, values);
    target_->bindForDrawing(values.width(), values.height());
    frame.fullscreen.draw(program);
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
