#include "window/frame_driver.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "frame/warm_up.h"
#include "gl/errors.h"
#include "window/moment_key.h"

namespace timeshade {

namespace {

/// How long nothing must change before the full picture is drawn. Only for pictures that are slow.
constexpr double settleSeconds = 0.35;
constexpr double budgetMilliseconds = 30.0;

double milliseconds() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// What decides how long a picture takes, apart from the view.
std::vector<double> methodKeyOf(const FrameDriver::Wanted& wanted) {
    const FrameRequest& r = wanted.request;
    std::vector<double> key{double(wanted.scene),      double(r.width),         double(r.height),
                            double(r.samplesPerPixel), double(r.mapSize.width), double(r.mapSize.height)};
    for (const Setting& setting : settingsOf(*wanted.technique)) key.push_back(setting.get());
    return key;
}

std::vector<double> frameKeyOf(const FrameDriver::Wanted& wanted) {
    std::vector<double> key = momentKeyOf(wanted.request);
    key.insert(key.end(), {double(wanted.view), double(wanted.request.seed), double(wanted.request.pixelCentres),
                           double(wanted.shaders), wanted.request.look.exposure, double(wanted.request.look.toneMap)});
    return key;
}

}  // namespace

FrameDriver::FrameDriver(FrameRenderer& renderer) : renderer_(renderer), quality_(renderer.device().software) {}

bool FrameDriver::noticeChange(const Wanted& wanted, double now) {
    std::vector<double> method = methodKeyOf(wanted), frame = frameKeyOf(wanted);
    const bool otherTechnique = techniqueName_ != wanted.technique->description().name;
    const bool otherMethod = otherTechnique || method != methodKey_;
    if (!otherMethod && frame == frameKey_ && techniqueView_ == wanted.techniqueView) return false;
    if (otherMethod) forgetTimes();
    // Sliders change the cost a little at a time, and the ladder follows; these change it at once.
    if (otherTechnique || methodKey_.empty() || method.front() != methodKey_.front()) quality_.forget();
    techniqueName_ = wanted.technique->description().name;
    techniqueView_ = wanted.techniqueView;
    methodKey_ = std::move(method);
    frameKey_ = std::move(frame);
    lastChange_ = now;
    return true;
}

bool FrameDriver::update(const Wanted& wanted, double now) {
    const bool changed = noticeChange(wanted, now);
    const bool moving = !wanted.hurry && (wanted.moving || now - lastChange_ < settleSeconds);
    refine_ = refine_ || changed;
    const int level = moving ? quality_.level() : 0;
    const bool better = refine_ && !moving && state_ != State::Failed;
    if (changed) toMeasure_ = 0;
    if (changed || better) {
        toSettle_ = wanted.once ? 0 : wanted.technique->settlingFrames();
        begin(wanted, level);
    } else if (toMeasure_ > 0 && state_ == State::Complete && level_ == 0) {
        --toMeasure_;
        begin(wanted, 0);
    } else if (toSettle_ > 0 && state_ == State::Complete && level_ == 0 && !moving) {
        --toSettle_;
        begin(wanted, 0);
    } else if (state_ != State::Drawing) {
        return false;
    }
    if (state_ == State::Drawing) draw();
    return true;
}

void FrameDriver::begin(const Wanted& wanted, int level) {
    const double start = milliseconds();
    if (level != level_) forgetTimes();
    level_ = level;
    refine_ = level > 0;
    ++begun_;
    try {
        picture_ = nullptr;
        hasPlan_ = false;
        renderer_.timer().finishFrame();  // of a picture that was given up half-way
        if (level == 0 && std::exchange(warmUp_, false))
            drawWarmUp(renderer_, *wanted.planner, *wanted.technique, wanted.request, wanted.view);
        FramePlan plan = wanted.planner->plan(quality_.reduced(wanted.request, level));
        renderer_.begin(std::move(plan), *wanted.technique, wanted.view, wanted.techniqueView);
        hasPlan_ = true;
        renderer_.step();
    } catch (const std::exception& error) {
        fail(error.what());
        return;
    }
    state_ = State::Drawing;
    readTimes();
    double cost = milliseconds() - start;
    if (times_.frames() > 0) cost = std::max(cost, times_.medianTotal() / renderer_.renders());
    quality_.measured(level, cost);
}

void FrameDriver::draw() {
    const double start = milliseconds();
    try {
        while (!renderer_.complete() && milliseconds() - start < budgetMilliseconds) {
            renderer_.step();
            readTimes();
        }
        const gl::Texture& picture = renderer_.displayTexture();
        picture.setFilters(GL_LINEAR, GL_LINEAR);
        picture_ = &picture;
    } catch (const std::exception& error) {
        fail(error.what());
        return;
    }
    state_ = renderer_.complete() ? State::Complete : State::Drawing;
}

void FrameDriver::readTimes() {
    // The renders of brute force add up. A picture that is drawn once and then stays would leave its times waiting in
    // the queue for ever.
    if (renderer_.complete()) times_.add(renderer_.timer().finishFrame());
}

void FrameDriver::forgetTimes() {
    renderer_.timer().finishFrame();  // times still on their way belong to what was drawn before
    times_.reset();
}

void FrameDriver::fail(const char* what) {
    // What OpenGL remembers of it must not be taken for the next picture's failure.
    gl::takeErrors();
    failure_ = what;
    state_ = State::Failed;
    toMeasure_ = toSettle_ = 0;
    refine_ = false;
    picture_ = nullptr;
}

void FrameDriver::cancel() {
    if (state_ != State::Drawing) return;
    state_ = State::Cancelled;
    toMeasure_ = 0;
    refine_ = false;
}

void FrameDriver::resume() {
    if (state_ == State::Cancelled) state_ = State::Drawing;
}

void FrameDriver::warmUp() { warmUp_ = refine_ = true; }

void FrameDriver::measure(int pictures) {
    forgetTimes();
    toMeasure_ = pictures;
}

std::optional<double> FrameDriver::sleep(double now) const {
    if (state_ == State::Drawing || toMeasure_ > 0 || (toSettle_ > 0 && state_ == State::Complete && level_ == 0))
        return 0.0;
    if (refine_) return std::max(0.0, settleSeconds - (now - lastChange_));
    return std::nullopt;
}

}  // namespace timeshade
