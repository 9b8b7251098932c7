#include "window/pixel_probe.h"

#include <algorithm>

#include <fmt/format.h>

#include "frame/warm_up.h"
#include "frame_setup.h"
#include "gl/errors.h"
#include "oracle/oracle.h"
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

double PixelProbe::Row::mean() const {
    double sum = 0.0;
    int asked = 0;
    for (const float value : lit) {
        if (value < 0.0f) continue;
        sum += static_cast<double>(value);
        ++asked;
    }
    return asked == 0 ? 0.0 : sum / asked;
}

void PixelProbe::pick(int x, int y) {
    on_ = true;
    x_ = x;
    y_ = y;
    of_ = -1;
}

void PixelProbe::clear() {
    on_ = complete_ = false;
    rows_.clear();
    square_.reset();
    renderer_.reset();
}

bool PixelProbe::update(Session& session) {
    const FrameDriver& driver = session.driver;
    const bool still = driver.settled() && driver.state() == FrameDriver::State::Complete && !driver.preview() &&
                       !session.moment.playback.playing();
    if (!on_ || !still) return false;
    const FrameRequest& drawn = session.renderer.plan().request;
    if (x_ >= drawn.width || y_ >= drawn.height) return false;  // the window has become smaller
    if (of_ == driver.begun() && complete_) return false;
    try {
        if (of_ != driver.begun())
            begin(session);
        else
            askNext(session);
    } catch (const std::exception& error) {
        caption_ = error.what();
        complete_ = true;
        gl::takeErrors();  // not to be taken for the next picture's
    }
    return true;
}

std::vector<float> PixelProbe::litOf(const FrameRenderer& renderer) const {
    const FrameRequest& drawn = renderer.plan().request;
    const std::vector<float> all = renderer.readVisibility();
    const auto layer = static_cast<std::size_t>(drawn.width) * static_cast<std::size_t>(drawn.height);
    const auto place = static_cast<std::size_t>(drawn.height - 1 - y_) * static_cast<std::size_t>(drawn.width) +
                       static_cast<std::size_t>(x_);
    std::vector<float> lit;
    for (std::size_t at = place; at < all.size(); at += layer) lit.push_back(all[at]);
    return lit;
}

void PixelProbe::begin(Session& session) {
    of_ = session.driver.begun();
    complete_ = false;
    next_ = 0;
    rows_.clear();
    upload(square_, squareAround(session.renderer.readPicture(), x_, y_, side));
    square_->setFilters(GL_NEAREST, GL_NEAREST);
    if (session.renderer.renders() == 1) rows_.push_back({session.technique.name(), litOf(session.renderer)});
    caption_ = "asking the other techniques";
}

void PixelProbe::askNext(Session& session) {
    const std::vector<TechniqueDescription>& all = techniqueDescriptions();
    if (!renderer_) renderer_.emplace();
    const FramePlan& plan = session.renderer.plan();
    while (next_ < all.size()) {
        const std::string& name = all[next_++].name;
        TechniqueOptions chosen = session.options;
        chosen.technique = name;
        const std::unique_ptr<Technique> technique = techniqueFor(chosen, renderer_->programs());
        // Brute force looks from one instant after the other and has no answer of its own for a camera sample.
        if (name == session.technique.name() || technique->renders() > 1 || technique->unsupported(plan)) continue;
        drawWarmUp(*renderer_, session.scene.planner(), *technique, plan.request, View::Visibility);
        renderer_->draw(plan, *technique, View::Visibility);
        renderer_->timer().finishFrame();
        rows_.push_back({name, litOf(*renderer_)});
        caption_ = "asking " + (next_ < all.size() ? all[next_].name : std::string("the ray tracer"));
        return;
    }
    traceTruth(session);
}

void PixelProbe::traceTruth(const Session& session) {
    complete_ = true;
    caption_.clear();
    if (session.renderer.renders() > 1 && rows_.empty()) return;
    const FramePlan& plan = renderer_->complete() ? renderer_->plan() : session.renderer.plan();
    const FrameRenderer& drawn = renderer_->complete() ? *renderer_ : session.renderer;
    const std::vector<std::uint32_t> ids = drawn.readSampleIds();
    const FrameRequest& request = plan.request;
    const auto layer = static_cast<std::size_t>(request.width) * static_cast<std::size_t>(request.height);
    const auto place = static_cast<std::size_t>(request.height - 1 - y_) * static_cast<std::size_t>(request.width) +
                       static_cast<std::size_t>(x_);
    const Oracle oracle(plan);
    Row truth{"truth", {}};
    for (int k = 0; k < request.samplesPerPixel; ++k) {
        const std::uint32_t id = ids[place + static_cast<std::size_t>(k) * layer];
        const SampleIndex index{static_cast<std::uint32_t>(x_), static_cast<std::uint32_t>(request.height - 1 - y_),
                                static_cast<std::uint32_t>(k)};
        const OracleAnswer answer = id == NO_TRIANGLE ? OracleAnswer{} : oracle.resolve(plan, index, id);
        truth.lit.push_back(answer.hit && answer.tested ? (answer.lit ? 1.0f : 0.0f) : -1.0f);
    }
    // Where the oracle tests nothing, no technique has a value.
    for (Row& row : rows_)
        for (std::size_t k = 0; k < std::min(row.lit.size(), truth.lit.size()); ++k)
            if (truth.lit[k] < 0.0f) row.lit[k] = -1.0f;
    rows_.insert(rows_.begin(), std::move(truth));
}

}  // namespace timeshade
