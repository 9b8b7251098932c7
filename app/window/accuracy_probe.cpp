#include "window/accuracy_probe.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "frame/warm_up.h"
#include "measure/metrics.h"
#include "techniques/registry.h"
#include "window/display_texture.h"
#include "window/frame_times.h"
#include "window/moment_key.h"

namespace timeshade {

namespace {

constexpr double budgetMilliseconds = 30.0;
constexpr std::size_t countedDraws = 3;

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

}  // namespace

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
    key.insert(key.end(), {double(scene), double(small.width), double(small.height), double(small.seed)});
    return key;
}

bool AccuracyProbe::aim(FramePlanner& planner, int scene, const FrameRequest& request) {
    planner_ = &planner;
    const FrameRequest small = smallCopyOf(request, longestSide);
    std::vector<double> key = smallCopyKey(small, scene);
    if (key == key_) return false;
    key_ = std::move(key);
    request_ = small;
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
        if (!reference_) {
            ReferenceOptions options;
            options.samplesPerPixel = referenceSamples;
            reference_ =
                std::make_unique<ReferenceBuilder>(planFor(maximumSamplesPerPixel, request_.mapSize), options, cache_);
        }
        if (reference_->complete()) return draw();
        reference_->step(*renderer_);
    } catch (const std::exception& error) {
        failure_ = error.what();
        technique_.reset();
        forgetGlErrors();
    }
    return std::nullopt;
}

FramePlan AccuracyProbe::planFor(int samplesPerPixel, int mapSize) {
    FrameRequest request = request_;
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
    }
    if (!renderer_->complete()) return std::nullopt;
    drawing_ = false;
    times_.push_back(milliseconds_);
    if (times_.size() == 1) image_ = renderer_->readRadiance();
    // Brute force takes long enough for one to do.
    if (times_.size() < (renderer_->renders() > 1 ? 1 : countedDraws)) return std::nullopt;
    std::sort(times_.begin(), times_.end());
    const ProbePoint point{*subject_, times_[times_.size() / 2], compareImages(image_, reference_->image()).rmse};
    subject_.reset();
    technique_.reset();  // its maps may be large, and the picture's technique has its own
    return point;
}

}  // namespace timeshade
