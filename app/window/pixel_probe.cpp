#include "window/pixel_probe.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/pause.h"
#include "frame/warm_up.h"
#include "frame_setup.h"
#include "gl/errors.h"
#include "measure/footprint_error.h"
#include "shared/shutter_response.shared.h"
#include "techniques/registry.h"
#include "window/display_texture.h"
#include "window/session.h"

namespace timeshade {

namespace {

/// The square around a pixel; what lies outside the picture is dark.
DisplayImage squareAround(const DisplayImage& picture, int x0, int y0, int side) {
    DisplayImage square{side, side, std::vector<std::uint8_t>(static_cast<std::size_t>(side * side * 3), 20)};
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            const int x = x0 - side / 2 + i, y = y0 - side / 2 + j;
            if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) continue;
            std::copy_n(picture.rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * picture.width + x), 3,
                        square.rgb.begin() + 3 * (j * side + i));
        }
    }
    return square;
}

}  // namespace

double PixelProbe::Row::mean(float ProbeValue::*what) const {
    double sum = 0.0, weights = 0.0;
    for (const ProbeValue& value : values) {
        if (value.lit < 0.0f || value.*what < 0.0f) continue;
        sum += static_cast<double>(value.weight) * static_cast<double>(value.*what);
        weights += static_cast<double>(value.weight);
    }
    return weights > 0.0 ? sum / weights : 0.0;
}

void PixelProbe::pick(int x, int y) {
    on_ = true;
    x_ = x;
    y_ = y;
    of_ = -1;
}

void PixelProbe::clear() {
    on_ = complete_ = false;
    of_ = -1;
    rows_.clear();
    segments_.clear();
    caption_.clear();
    if (!working_) release();
}

/// What is large.
void PixelProbe::release() {
    samples_.clear();
    oracle_.reset();
    others_.clear();
    square_.reset();
    renderer_.reset();
}

bool PixelProbe::update(Session& session) {
    if (!on_ && renderer_) release();
    const FrameDriver& driver = session.driver;
    const bool still = driver.settled() && driver.state() == FrameDriver::State::Complete && !driver.preview() &&
                       !session.moment.playback.playing();
    if (!on_ || !still) return false;
    const FrameRequest& drawn = session.renderer.plan().request;
    if (x_ >= drawn.width || y_ >= drawn.height) return false;  // the window has become smaller
    if (of_ == driver.begun() && complete_) return false;
    working_ = true;
    try {
        step(session);
    } catch (const WorkCancelled&) {
        working_ = false;
        of_ = -1;
        throw;
    } catch (const std::exception& error) {
        caption_ = error.what();
        complete_ = true;
        gl::takeErrors();  // not to be taken for the next picture's
    }
    working_ = false;
    return true;
}

void PixelProbe::step(Session& session) {
    if (of_ != session.driver.begun())
        begin(session);
    else
        evaluateNext(session);
}

/// Of all camera samples, [stratum][row from the bottom][column], those of the pixel.
template <typename T>
std::vector<T> PixelProbe::ofPixel(const FrameRequest& request, const std::vector<T>& all) const {
    const auto layer = static_cast<std::size_t>(request.width) * static_cast<std::size_t>(request.height);
    const auto place = static_cast<std::size_t>(request.height - 1 - y_) * static_cast<std::size_t>(request.width) +
                       static_cast<std::size_t>(x_);
    std::vector<T> own;
    for (std::size_t at = place; at < all.size(); at += layer) own.push_back(all[at]);
    return own;
}

void PixelProbe::begin(Session& session) {
    of_ = session.driver.begun();
    complete_ = false;
    rows_.clear();
    segments_.clear();
    samples_.clear();
    oracle_.reset();
    upload(square_, squareAround(session.renderer.readPicture(), x_, y_, side));
    square_->setFilters(GL_NEAREST, GL_NEAREST);
    if (!renderer_) renderer_.emplace();
    others_.clear();
    next_ = 0;
    if (!session.renderer.plan().pieces.empty()) {
        caption_ = "The values of samples are shown of a shutter with one motion step";
        complete_ = true;
        return;
    }
    for (const TechniqueDescription& description : techniqueDescriptions()) {
        std::unique_ptr<Technique> other =
            techniqueFor(description.name, session.options.settings, renderer_->programs());
        // Brute force draws one instant after the other and has no value for a camera sample.
        if (description.name == session.technique.name() || other->renders() > 1 ||
            other->unsupported(session.renderer.plan()))
            continue;
        others_.push_back(std::move(other));
    }
    caption_ = "Computing the ground truth...";
}

/// For a position without a time, from the oracle of interval samples.
void PixelProbe::solveSegments(const FramePlan& plan) {
    const glm::vec2 centre(static_cast<float>(x_) + 0.5f, static_cast<float>(plan.request.height - 1 - y_) + 0.5f);
    segments_ = SegmentOracle(plan).litByAll(plan, std::span(&centre, 1)).front();
}

void PixelProbe::evaluateNext(Session& session) {
    const FramePlan& plan = session.renderer.plan();
    if (segments_.empty() && !plan.cutouts) return solveSegments(plan);  // alpha has no edges to solve for
    if (rows_.empty() && session.renderer.renders() == 1) {
        addRow(session.renderer.plan(), session.renderer, session.technique.current());
        return announceNext();
    }
    if (next_ < others_.size()) {
        drawOther(session, *others_[next_]);
        others_[next_++].reset();  // its maps may be large
        return announceNext();
    }
    complete_ = true;
    caption_.clear();
    oracle_.reset();
}

void PixelProbe::drawOther(Session& session, Technique& technique) {
    const FramePlan& plan = session.renderer.plan();
    drawWarmUp(*renderer_, session.scene.planner(), technique, plan.request, View::Visibility);
    renderer_->draw(plan, technique, View::Visibility);
    renderer_->timer().dropAll();
    addRow(plan, *renderer_, technique);
}

void PixelProbe::announceNext() {
    if (next_ < others_.size()) caption_ = fmt::format("Evaluating {}...", others_[next_]->description().shortTitle);
}

void PixelProbe::addRow(const FramePlan& plan, const FrameRenderer& renderer, const Technique& technique) {
    if (samples_.empty()) traceSamples(plan, renderer);
    const std::vector<float> lit = ofPixel(plan.request, renderer.readVisibility());
    Row row{technique.description().name, technique.description().shortTitle, {}};
    for (std::size_t k = 0; k < samples_.size(); ++k) {
        row.values.emplace_back();
        row.values.back().weight =
            shared::shutterWeight(plan.block.response, plan.block.responseWidth, samples_[k].answer.time);
        // Where the oracle tests nothing, no technique has a value.
        if (samples_[k].answer.hit && samples_[k].answer.tested) row.values.back().lit = lit[k];
    }
    addTruth(plan, technique.footprint(), row.values);
    rows_.push_back(std::move(row));
}

/// They are the same for all techniques.
void PixelProbe::traceSamples(const FramePlan& plan, const FrameRenderer& renderer) {
    oracle_ = std::make_unique<Oracle>(plan);
    std::uint32_t stratum = 0;
    for (const std::uint32_t triangle : ofPixel(plan.request, renderer.readSampleIds())) {
        Sample sample{
            {static_cast<std::uint32_t>(x_), static_cast<std::uint32_t>(plan.request.height - 1 - y_), stratum++},
            triangle,
            {}};
        pausePoint();
        if (triangle != NO_TRIANGLE) sample.answer = oracle_->resolve(plan, sample.index, triangle);
        samples_.push_back(sample);
    }
}

/// The footprint's interval and the true mean over it.
void PixelProbe::addTruth(const FramePlan& plan, const Footprint& footprint, std::vector<ProbeValue>& values) const {
    std::vector<SampleFootprint> footprints;
    for (const Sample& sample : samples_)
        footprints.push_back(footprintOf(footprint, sample.index, sample.triangle, sample.answer.time,
                                         sample.index.stratum, plan.block.strata));
    std::vector<VisibilityMean> means;
    if (!footprint.isInstantAtPoint()) means = oracle_->footprintMeans(plan, footprints, rays, plan.block.seed);
    for (std::size_t k = 0; k < values.size(); ++k) {
        values[k].from = footprints[k].from;
        values[k].to = footprints[k].to;
        if (values[k].lit < 0.0f) continue;
        if (means.empty())
            values[k].truth = samples_[k].answer.lit ? 1.0f : 0.0f;
        else if (means[k].exists())
            values[k].truth = static_cast<float>(means[k].value());
    }
}

}  // namespace timeshade
