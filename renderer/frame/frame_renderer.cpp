#include "frame/frame_renderer.h"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

#include "core/check.h"
#include "core/error.h"
#include "core/hash.h"
#include "core/pause.h"
#include "core/work_part.h"
#include "frame/buffer_check.h"
#include "frame/upside_down.h"
#include "gl/errors.h"
#include "gl/read_back.h"
#include "shared/shutter_response.shared.h"
#include "technique/technique_views.h"

namespace timeshade {

namespace {

/// More than all techniques need in one scene, which a sweep goes through round after round: a program that is dropped
/// in between is compiled again in frames that are timed. More would only take memory, some 3 MB each on a software
/// renderer: all built-in scenes together need 144.
constexpr std::size_t programsKept = 128;

/// Where the passes begin in the work on a render, as a rule: for progress alone.
constexpr double buildFrom = 0.3, lookupFrom = 0.4, shadeFrom = 0.65;

/// By all renderers: a technique may be drawn by one after another, as when a window swaps two, and one count tells
/// what came first. A renderer has counted once before it draws.
std::uint64_t invalidations = 0;

template <typename T>
std::vector<T> readArray(const gl::Texture& texture, GLenum format, GLenum type) {
    std::vector<T> values = gl::readTexture<T>(texture, format, type);
    gl::requireNoErrors("reading back what was drawn");
    return values;
}

void requireSupported(const FramePlan& plan, const Technique& technique) {
    if (const std::optional<std::string> reason = technique.unsupported(plan))
        throw Error(fmt::format("technique {} can't draw this frame: {}", technique.description().name, *reason));
}

/// Of what is drawn sample by sample there is no form for positions without a time.
void requireIntervals(Technique& technique, const std::string& view) {
    const std::string& name = technique.description().name;
    if (technique.hasOwnLookup() || technique.renders() > 1)
        throw Error(
            fmt::format("technique {} needs camera samples that have a time each; expected --samples strata", name));
    if (!view.empty())
        throw Error(fmt::format("view {} of {} shows camera samples that have a time each; expected --samples strata",
                                view, name));
}

}  // namespace

FrameRenderer::FrameRenderer()
    : device_(gl::currentDevice()),
      timer_(device_.software ? gl::PassTimer::Clock::Finish : gl::PassTimer::Clock::Timestamps),
      maps_(programs_, caches_),
      samplePass_(programs_, caches_),
      intervals_(programs_, caches_),
      shadePass_(programs_, caches_),
      displayPass_(programs_),
      heatMapPass_(programs_),
      lookupPass_(programs_, caches_),
      partLookup_(programs_) {}

void FrameRenderer::resize(int width, int height, int strata) {
    GLint largest = 0, deepest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &deepest);
    if (width > largest || height > largest || strata > deepest)
        throw Error(
            fmt::format("a picture of {} x {} with {} samples a pixel is more than this device takes ({} x {}, {})",
                        width, height, strata, largest, largest, deepest));
    const auto fits = [&](const gl::Texture& t, int layers) {
        return t.width() == width && t.height() == height && t.layers() == layers;
    };
    if (!samples_ || !fits(samples_->ids(), strata)) {
        samples_.emplace(width, height, strata);
        visibility_.emplace(width, height, strata);
        invalidateAll();
    }
    if (!radiance_ || !fits(*radiance_, 1)) {
        radiance_ = gl::Texture::image2D("radiance", GL_RGBA32F, width, height);
        picture_ = gl::Texture::image2D("picture", GL_RGBA8, width, height);
    }
}

void FrameRenderer::begin(FramePlan plan, Technique& technique, View view, const std::string& techniqueView,
                          gl::LateCounts::Reading counts) {
    requireSupported(plan, technique);
    for (const FramePlan& piece : plan.pieces) requireSupported(piece, technique);
    if (plan.block.positions > 0) requireIntervals(technique, techniqueView);
    std::optional<TechniqueView> own;
    if (!techniqueView.empty()) own = viewOf(technique, techniqueView);
    programs_.keepNewest(programsKept);
    // Caches may hold what was drawn with too little room.
    if (counts_.state() != gl::LateCounts::State::Sufficed) invalidateAll();
    counts_.begin(counts);
    plan_ = std::move(plan);
    technique_ = &technique;
    techniqueView_ = std::move(own);
    view_ = view;
    instants_ = technique.renders();
    renders_ = rendersOf(*plan_, instants_);
    done_ = 0;
    weightDone_ = 0.0;
    settings_.set(technique);
    resize(plan_->request.width, plan_->request.height,
           instants_ > 1 ? 1 : pieceOf(*plan_, 0, 1).request.samplesPerPixel);
    forgetPast(technique);  // after what may have invalidated everything
    if (techniqueView_ &&
        (!values_ || values_->width() != radiance_->width() || values_->height() != radiance_->height()))
        values_ = gl::Texture::image2D("view values", GL_R32F, radiance_->width(), radiance_->height());
    const std::array<GLfloat, 4> black{};
    glClearTexImage(radiance_->name(), 0, GL_RGBA, GL_FLOAT, black.data());
}

bool FrameRenderer::step() {
    if (complete()) return true;
    try {
        const WorkPart part = workPart(done_, renders_);
        drawRender();
    } catch (const WorkCancelled&) {
        giveUp();
        throw;
    }
    if (checked_) checkBuffers();
    if (complete()) endFrame();
    return complete();
}

void FrameRenderer::drawRender() {
    render_ = renderOf(*plan_, done_, instants_);
    const FramePlan& render = *render_;
    mesh_.update(render);
    uniforms_.set(render);
    settings_.bind();
    mesh_.bind();
    {
        const auto timed = timer_.scope("sample");
        const WorkPart part(0.0, buildFrom);
        drawSamples(render);
    }
    maps_.begin(render, mesh_);
    const TechniqueFrame frame = techniqueFrame();
    {
        const auto timed = timer_.scope("build");
        const WorkPart part(buildFrom, lookupFrom);
        technique_->build(frame);
    }
    std::optional<StillPixels> still;
    {
        const auto timed = timer_.scope("lookup");
        const WorkPart part(lookupFrom, shadeFrom);
        still = drawLookup(frame);
    }
    const WorkPart part(shadeFrom, 1.0);
    if (techniqueView_) {
        const auto timed = timer_.scope("view");
        technique_->drawView(frame, techniqueView_->name, *values_);
    } else {
        const auto timed = timer_.scope("shade");
        drawShade(render, still);
    }
    gl::requireNoErrors(fmt::format("a frame of {}", technique_->description().name));
    ++done_;
    weightDone_ += static_cast<double>(render.block.weight);
}

/// Some caches say what they are about to hold, and passes may have changed the state that others count on.
void FrameRenderer::giveUp() {
    renders_ = done_ = 0;
    invalidateAll();
    technique_->forget();
    timer_.dropFrame();
    counts_.begin(gl::LateCounts::Reading::AtOnce);
    glDisable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glDisable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_GREATER);
}

TechniqueFrame FrameRenderer::techniqueFrame() {
    return {*render_, mesh_, *samples_, *visibility_, fullscreen_, timer_, maps_, caches_, counts_, settings_.define()};
}

std::vector<FrameRenderer::PartValue> FrameRenderer::readParts() const {
    CHECK(hasIntervalSamples());
    const IntervalSamples::Read read = intervals_.read();
    const std::vector<glm::vec4> values = readArray<glm::vec4>(partLookup_.values(), GL_RGBA, GL_FLOAT);
    std::vector<PartValue> result;
    result.reserve(read.parts.size());
    for (std::size_t i = 0; i < read.parts.size(); ++i)
        result.push_back({read.parts[i], values[read.places[i]].x, values[read.places[i]].y});
    return result;
}

StoredAlongLine FrameRenderer::storedAlong(const MapLine& line) {
    CHECK_GT(done_, 0);
    uniforms_.set(*render_);
    settings_.bind();
    mesh_.bind();
    StoredAlongLine stored = technique_->storedAlong(techniqueFrame(), line);
    gl::requireNoErrors(fmt::format("reading what {} stored", technique_->description().name));
    return stored;
}

void FrameRenderer::drawSamples(const FramePlan& plan) {
    if (plan.block.positions == 0) return samplePass_.draw(plan, mesh_, *samples_);
    intervals_.draw(plan, mesh_, *samples_, !technique_->solvesIntervals());
}

void FrameRenderer::drawShade(const FramePlan& plan, const std::optional<StillPixels>& still) {
    if (plan.block.positions == 0) {
        if (still && plan.versions.shading != 0 && renders_ == 1)
            return shadePass_.drawOntoStill(plan, fullscreen_, *samples_, *visibility_, view_, *still, *radiance_);
        return shadePass_.draw(plan, fullscreen_, *samples_, *visibility_, view_, renders_ > 1, *radiance_);
    }
    shadePass_.draw(
        plan, fullscreen_,
        {intervals_.parts(), intervals_.partsOfPositions(), partLookup_.values(), technique_->solvesIntervals()}, view_,
        *radiance_);
}

std::optional<StillPixels> FrameRenderer::drawLookup(const TechniqueFrame& frame) {
    if (technique_->hasOwnLookup()) {
        technique_->drawLookup(frame);
        return std::nullopt;
    }
    Lookup lookup;
    lookup.program = [&](Casters casters) { return technique_->lookupProgram(frame, casters); };
    lookup.footprint = technique_->footprint();
    if (frame.plan.block.positions > 0) {
        partLookup_.draw(frame, lookup, intervals_, technique_->solvesIntervals());
        return std::nullopt;
    }
    if (frame.plan.versions.lit != 0) lookup.key = Hash().add(settings_.key()).add(frame.plan.versions.lit).value() | 1;
    if (technique_->separatesStaticCasters()) lookup.staticIds = samplePass_.staticIds(frame.plan, *samples_);
    return lookupPass_.draw(frame, lookup);
}

void FrameRenderer::endFrame() {
    caches_.endFrame();
    counts_.end();
    const std::string own = technique_->description().name + ": ";
    // Here, as the technique may be gone when someone asks.
    techniqueBytes_ = technique_->bytes() + caches_.bytes(LightMaps::cacheNames) + caches_.bytes(own);
}

void FrameRenderer::invalidateAll() {
    caches_.invalidateAll();
    invalidatedAt_ = ++invalidations;
}

std::vector<std::string> FrameRenderer::reloadShaders() {
    invalidateAll();
    return programs_.reload();
}

/// A technique that remembers earlier frames must not use what is from before everything was invalidated.
void FrameRenderer::forgetPast(Technique& technique) {
    const bool hasDrawn = technique.drawnAt_ > 0;
    if (hasDrawn && technique.drawnAt_ < invalidatedAt_) technique.forget();
    technique.drawnAt_ = invalidations;
}

void FrameRenderer::draw(FramePlan plan, Technique& technique, View view, const std::string& techniqueView) {
    begin(std::move(plan), technique, view, techniqueView);
    while (!step()) {
    }
}

void FrameRenderer::checkBuffers() const {
    if (render_->block.positions > 0)
        requireFinite(partLookup_.values(), "visibility of parts", 0.0f, 1.0f);
    else
        requireFinite(visibility_->lit(), "visibility", 0.0f, 1.0f);
    requireFinite(*radiance_, "radiance", 0.0f, std::numeric_limits<float>::max());
    if (techniqueView_)
        requireFinite(*values_, "view " + techniqueView_->name, std::numeric_limits<float>::lowest(),
                      std::numeric_limits<float>::max());
    for (const gl::Texture* texture : maps_.textures())
        requireFinite(*texture, "light map", std::numeric_limits<float>::lowest(), std::numeric_limits<float>::max());
    for (const gl::Texture* texture : technique_->textures())
        requireFinite(*texture, technique_->description().name, std::numeric_limits<float>::lowest(),
                      std::numeric_limits<float>::max());
}

/// What makes a picture out of the renders so far.
float FrameRenderer::scaleToWhole() const {
    if (done_ == 0) return 0.0f;
    if (complete() || plan_->block.response == SHUTTER_BOX)
        return static_cast<float>(renders_) / static_cast<float>(done_);
    return static_cast<float>(1.0 / weightDone_);
}

const gl::Texture& FrameRenderer::displayTexture() {
    if (techniqueView_) {
        heatMapPass_.draw(fullscreen_, *values_,
                          {techniqueView_->low, techniqueView_->high, techniqueView_->logarithmic}, *picture_);
    } else {
        // Visibility is a share of light, shown as it is.
        const DisplayLook look = view_ == View::Final ? plan_->request.look : DisplayLook{0.0, ToneMap::Linear};
        displayPass_.draw(fullscreen_, *radiance_, scaleToWhole(), look, *picture_);
    }
    gl::injectErrorForTest("display");
    gl::requireNoErrors(fmt::format("the picture of {}", technique_->description().name));
    return *picture_;
}

DisplayImage FrameRenderer::readPicture() { return askPicture().take(); }

LatePicture FrameRenderer::askPicture() { return LatePicture(displayTexture()); }

LinearImage FrameRenderer::readRadiance() {
    LinearImage image{radiance_->width(), radiance_->height(), {}};
    if (techniqueView_) {
        std::vector<float> rgba;
        for (const float value : readArray<float>(*values_, GL_RED, GL_FLOAT)) rgba.insert(rgba.end(), 4, value);
        copyRowsUpsideDown<float, float>(rgba, image.width, image.height, image.rgb, 1.0f);
        return image;
    }
    const std::vector<float> rgba = readArray<float>(*radiance_, GL_RGBA, GL_FLOAT);
    copyRowsUpsideDown<float, float>(rgba, image.width, image.height, image.rgb, scaleToWhole());
    return image;
}

std::vector<float> FrameRenderer::readVisibility() const {
    return readArray<float>(visibility_->lit(), GL_RED, GL_FLOAT);
}

std::vector<std::uint32_t> FrameRenderer::readSampleIds() const {
    return readArray<std::uint32_t>(samples_->ids(), GL_RED_INTEGER, GL_UNSIGNED_INT);
}

GpuMemory FrameRenderer::memory() const {
    GpuMemory memory;
    memory.mesh = mesh_.bytes();
    memory.samples = samplePass_.bytes() + caches_.bytes("samples: ") + (samples_ ? samples_->bytes() : 0);
    memory.visibility = (visibility_ ? visibility_->bytes() : 0) + caches_.bytes("lookup: ");
    if (hasIntervalSamples()) {
        memory.samples += intervals_.bytes() + caches_.bytes("interval samples: ");
        memory.visibility += partLookup_.bytes();
    }
    memory.technique = techniqueBytes_;
    memory.picture = caches_.bytes("shade: ") + (radiance_ ? radiance_->bytes() : 0) +
                     (picture_ ? picture_->bytes() : 0) + (values_ ? values_->bytes() : 0);
    return memory;
}

}  // namespace timeshade
