#include "window/accuracy_probe.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "core/pause.h"
#include "frame/warm_up.h"
#include "gl/errors.h"
#include "measure/metrics.h"
#include "measure/stopwatch.h"
#include "report.h"
#include "shared/shutter_response.shared.h"
#include "techniques/registry.h"
#include "window/frame_times.h"
#include "window/moment_key.h"

namespace timeshade {

namespace {

constexpr double budgetMilliseconds = 30.0;
constexpr std::size_t countedDraws = 3;

using Clock = std::chrono::steady_clock;

}  // namespace

std::string errorInWords(const ProbePoint& point) { return fmt::format("shadow error {:.3g}", point.shadowError); }

std::unique_ptr<Technique> techniqueOf(const ProbeSubject& subject, gl::ProgramCache& programs) {
    std::unique_ptr<Technique> technique = makeTechnique(subject.technique, programs);
    std::vector<Setting> settings = settingsOf(*technique);
    for (std::size_t i = 0; i < std::min(settings.size(), subject.settings.size()); ++i)
        settings[i].set(subject.settings[i]);
    return technique;
}

FrameRequest smallCopyOf(const FrameRequest& request, int longestSide) {
    FrameRequest small = request;
    const double factor = std::min(1.0, double(longestSide) / std::max(request.width, request.height));
    small.width = std::max(1, static_cast<int>(std::lround(factor * request.width)));
    small.height = std::max(1, static_cast<int>(std::lround(factor * request.height)));
    return small;
}

std::vector<double> smallCopyKey(const FrameRequest& small, int scene) {
    std::vector<double> key = momentKeyOf(small);
    key.insert(key.end(), {double(scene), double(small.width), double(small.height), double(small.seed),
                           double(small.pixelCentres)});
    return key;
}

bool AccuracyProbe::aim(FramePlanner& planner, int scene, const FrameRequest& request) {
    planner_ = &planner;
    const FrameRequest small = smallCopyOf(request, longestSide);
    std::vector<double> key = smallCopyKey(small, scene);
    if (key == key_) return false;
    key_ = std::move(key);
    request_ = small;
    visibility_.reset();
    reference_.reset();
    subject_.reset();
    failure_.clear();
    return true;
}

void AccuracyProbe::measure(const ProbeSubject& subject) {
    if (subject_ == subject) return;
    subject_ = subject;
    technique_.reset();
    plan_.reset();
    drawing_ = false;
    times_.clear();
    failure_.clear();
}

std::optional<ProbePoint> AccuracyProbe::step() {
    if (!subject_ || !failure_.empty()) return std::nullopt;
    try {
        if (!renderer_) renderer_.emplace();
        if (!visibility_)
            visibility_ = std::make_unique<ReferenceVisibilityBuilder>(
                planFor(maximumSamplesPerPixel, request_.mapSize), referenceRays, cache_);
        if (!visibility_->complete()) {
            visibility_->step();
            return std::nullopt;
        }
        if (!reference_) {
            ReferenceOptions options;
            options.samplesPerPixel = referenceSamples;
            reference_ =
                std::make_unique<ReferenceBuilder>(planFor(maximumSamplesPerPixel, request_.mapSize), options, cache_);
        }
        if (reference_->complete()) return draw();
        reference_->step(*renderer_);
    } catch (const WorkCancelled&) {
        // References keep what they have; a technique's draws begin anew.
        technique_.reset();
        drawing_ = false;
        times_.clear();
        throw;
    } catch (const std::exception& error) {
        failure_ = error.what();
        technique_.reset();
        gl::takeErrors();  // not to be taken for the next picture's
    }
    return std::nullopt;
}

FramePlan AccuracyProbe::planFor(int samplesPerPixel, const MapSize& mapSize) {
    FrameRequest request = technique_ ? technique_->asked(request_) : request_;
    request.samplesPerPixel = samplesPerPixel;
    request.mapSize = mapSize;
    return planner_->plan(request);
}

void AccuracyProbe::beginSubject() {
    technique_ = techniqueOf(*subject_, renderer_->programs());
    plan_ = planFor(subject_->samplesPerPixel, subject_->mapSize);
    // So that every draw that counts finds its programs compiled and its caches filled.
    drawVariants(*renderer_, *planner_, *technique_, plan_->request, View::Final);
    drawWarmUp(*renderer_, *planner_, *technique_, plan_->request, View::Final);
    oracle_ = {};
    means_.emplace(static_cast<std::size_t>(request_.width) * static_cast<std::size_t>(request_.height));
    tested_ = wrong_ = 0;
}

/// Adds the lit values of the render just drawn to the pixels' means.
void AccuracyProbe::compareRender() {
    const FramePlan drawn = renderOf(*plan_, renderer_->rendersDone() - 1, technique_->renders());
    const std::vector<OracleAnswer> truth = oracle_.of(drawn).answer(drawn, renderer_->readSampleIds());
    const std::vector<float> lit = renderer_->readVisibility();
    const auto pixels = static_cast<std::size_t>(request_.width) * static_cast<std::size_t>(request_.height);
    for (std::size_t i = 0; i < lit.size(); ++i) {
        if (!truth[i].hit || !truth[i].tested) continue;
        const float weight = shared::shutterWeight(drawn.block.response, drawn.block.responseWidth, truth[i].time);
        means_->add(i % pixels, static_cast<double>(lit[i]), static_cast<double>(weight));
        ++tested_;
        wrong_ += (lit[i] >= 0.5f) != truth[i].lit ? 1u : 0u;
    }
}

double AccuracyProbe::referenceProgress() const {
    // The visibility takes about as long as the image.
    const double rows = visibility_ ? static_cast<double>(visibility_->rowsDone()) / visibility_->rows() : 0.0;
    const double batches = reference_ ? static_cast<double>(reference_->batchesDone()) / reference_->batches() : 0.0;
    return 0.5 * (rows + batches);
}

std::optional<ProbePoint> AccuracyProbe::draw() {
    if (!technique_) beginSubject();
    if (!drawing_) {
        renderer_->begin(*plan_, *technique_, View::Final);
        drawing_ = true;
        milliseconds_ = 0.0;
    }
    const auto begin = Clock::now();
    while (!renderer_->complete() && millisecondsSince(begin) < budgetMilliseconds) {
        renderer_->step();
        milliseconds_ += gl::totalOf(renderer_->timer().finishFrame());
        if (times_.empty()) compareRender();
    }
    if (!renderer_->complete()) return std::nullopt;
    drawing_ = false;
    times_.push_back(milliseconds_);
    if (times_.size() == 1) image_ = renderer_->readRadiance();
    // Brute force takes long enough for one to do.
    if (times_.size() < (technique_->renders() > 1 ? 1 : countedDraws)) return std::nullopt;
    std::sort(times_.begin(), times_.end());
    ProbePoint point;
    point.subject = *subject_;
    point.milliseconds = times_[times_.size() / 2];
    point.shadowError = means_->against(*visibility_->result()).error.rms;
    if (technique_->footprint().isBinary() && tested_ > 0)
        point.wrongPpm = 1e6 * static_cast<double>(wrong_) / static_cast<double>(tested_);
    point.rmse = compareImages(image_, reference_->image()).rmse;
    oracle_ = {};
    subject_.reset();
    technique_.reset();  // its maps may be large, and the picture's technique has its own
    return point;
}

}  // namespace timeshade
