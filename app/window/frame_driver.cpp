#include "window/frame_driver.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "compare/compared_techniques.h"
#include "core/pause.h"
#include "core/work_part.h"
#include "frame/warm_up.h"
#include "gl/errors.h"
#include "window/moment_key.h"

namespace timeshade {

namespace {

/// How long nothing must change before the full picture is drawn. Only for pictures that are slow.
constexpr double settleSeconds = 0.35;
constexpr double budgetMilliseconds = 30.0;
/// Of what the device has been told to draw. More would only make the window slower to respond.
constexpr std::size_t stepsAhead = 2;

/// Of work: pauses are left out.
double milliseconds() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::milli>(now).count() - millisecondsPaused();
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

bool sameMethod(const FrameDriver::Wanted& wanted, const std::string& technique, const std::vector<double>& key) {
    return technique == wanted.technique->description().name && methodKeyOf(wanted) == key;
}

bool isLess(const FrameRequest& drawn, const FrameRequest& asked) {
    return drawn.width != asked.width || drawn.height != asked.height ||
           drawn.samplesPerPixel != asked.samplesPerPixel || !(drawn.mapSize == asked.mapSize);
}

/// True while it lives.
struct Flag {
    bool& flag;
    explicit Flag(bool& f) : flag(f) { flag = true; }
    ~Flag() { flag = false; }
    Flag(const Flag&) = delete;
    Flag& operator=(const Flag&) = delete;
};

}  // namespace

FrameDriver::FrameDriver(FrameRenderer& renderer) : renderer_(renderer), quality_(renderer.device().software) {}

bool FrameDriver::noticeChange(const Wanted& wanted, double now) {
    if (!std::exchange(restart_, false) && follows(wanted)) return false;
    std::vector<double> method = methodKeyOf(wanted);
    const bool otherTechnique = techniqueName_ != wanted.technique->description().name;
    if (otherTechnique || method != methodKey_) forgetTimes();
    // Sliders change the cost a little at a time, and the ladder follows; these change it at once.
    if (otherTechnique || methodKey_.empty() || method.front() != methodKey_.front()) quality_.forget();
    techniqueName_ = wanted.technique->description().name;
    techniqueView_ = wanted.techniqueView;
    methodKey_ = std::move(method);
    frameKey_ = frameKeyOf(wanted);
    lastChange_ = now;
    return true;
}

bool FrameDriver::follows(const Wanted& wanted) const {
    return sameMethod(wanted, techniqueName_, methodKey_) && frameKeyOf(wanted) == frameKey_ &&
           techniqueView_ == wanted.techniqueView;
}

bool FrameDriver::outdated(const Wanted& wanted) const {
    if (stop_ && renderer_.renders() <= 1) return true;
    if (moving_)
        return !sameMethod(wanted, techniqueName_, methodKey_) || techniqueView_ != wanted.techniqueView ||
               (wanted.hurry && level_ > 0);
    return !follows(wanted);
}

bool FrameDriver::update(const Wanted& wanted, double now) {
    if (measureNext_ > 0) {
        forgetTimes();
        toMeasure_ = std::exchange(measureNext_, 0);
    }
    const bool changed = noticeChange(wanted, now);
    const Flag working(drawing_);
    if (renderer_.timer().awaits()) takeTimes();
    try {
        const int before = shown_.number;
        const State stateBefore = state_;
        proceed(wanted, changed, now);
        return shown_.number != before || state_ != stateBefore || state_ == State::Drawing;
    } catch (const WorkCancelled&) {
        giveUp();
        throw;
    }
}

void FrameDriver::proceed(const Wanted& wanted, bool changed, double now) {
    const bool moving = !wanted.hurry && (wanted.moving || now - lastChange_ < settleSeconds);
    refine_ = refine_ || changed;
    if (isHeldBack(wanted, changed)) return;
    const int level = moving ? quality_.level() : 0;
    const bool better = refine_ && !moving && state_ != State::Failed;
    if (changed) toMeasure_ = 0;
    if (changed || better) {
        toSettle_ = wanted.once ? 0 : wanted.technique->settlingFrames();
        moving_ = moving;
        begin(wanted, level);
    } else if (toMeasure_ > 0 && state_ == State::Complete && level_ == 0) {
        --toMeasure_;
        begin(wanted, 0);
    } else if (toSettle_ > 0 && state_ == State::Complete && level_ == 0 && !moving) {
        --toSettle_;
        begin(wanted, 0);
    }
    if (state_ == State::Drawing) draw(wanted);
}

/// Nothing new is begun while it is not known whether the last picture is right, or while the device has enough to do.
/// Where that is wrong it counts as changed.
bool FrameDriver::isHeldBack(const Wanted& wanted, bool& changed) {
    const bool behind = isBehind();
    if (unproven_ && state_ == State::Drawing) {
        const gl::LateCounts::State room = renderer_.room();
        if (room == gl::LateCounts::State::Sufficed) {
            showProven();
        } else if (room == gl::LateCounts::State::Pending) {
            restart_ = restart_ || changed;
            return true;
        } else {
            unproven_.reset();
            changed = refine_ = true;
        }
    }
    if (!changed || !behind || !wanted.moving) return false;
    restart_ = true;
    return true;
}

void FrameDriver::showProven() {
    try {
        show(*std::exchange(unproven_, std::nullopt));
        state_ = State::Complete;
    } catch (const std::exception& error) {
        fail(error.what());
    }
}

bool FrameDriver::isBehind() {
    while (!steps_.empty() && steps_.front().passed()) steps_.pop_front();
    return steps_.size() >= stepsAhead;
}

void FrameDriver::step() {
    renderer_.step();
    steps_.emplace_back();
    readTimes();
}

void FrameDriver::begin(const Wanted& wanted, int level) {
    const double start = milliseconds();
    const FrameRequest drawn = quality_.reduced(wanted.request, level);
    // What can't be reduced any more is no preview.
    const int newLevel = isLess(drawn, wanted.request) ? level : 0;
    if (newLevel != level_) forgetTimes();
    level_ = newLevel;
    refine_ = level_ > 0;
    stop_ = false;
    ++begun_;
    state_ = State::Drawing;
    unproven_.reset();
    try {
        hasPlan_ = false;
        renderer_.timer().dropFrame();  // of a picture that was given up half-way
        if (level == 0 && std::exchange(warmUp_, false))
            drawWarmUp(renderer_, *wanted.planner, *wanted.technique, wanted.request, wanted.view);
        FramePlan plan = wanted.planner->plan(drawn);
        renderer_.begin(std::move(plan), *wanted.technique, wanted.view, wanted.techniqueView,
                        gl::LateCounts::Reading::Later);
        hasPlan_ = true;
        pausePoint();  // large buffers may have been made
        step();
    } catch (const std::exception& error) {
        fail(error.what());
        return;
    }
    double cost = milliseconds() - start;
    if (times_.frames() > 0) cost = std::max(cost, times_.medianTotal() / renderer_.renders());
    quality_.measured(level, cost);
}

void FrameDriver::draw(const Wanted& wanted) {
    const double start = milliseconds();
    try {
        while (!renderer_.complete() && !stop_ && milliseconds() - start < budgetMilliseconds && !isBehind()) step();
        // Its clock waits for all steps anyway; and what is shown is then what the renderer holds.
        if (renderer_.device().software) glFinish();
        if (renderer_.room() == gl::LateCounts::State::Sufficed)
            show(described(wanted));
        else if (renderer_.complete())
            unproven_ = described(wanted);
    } catch (const std::exception& error) {
        fail(error.what());
        return;
    }
    const bool stopped = std::exchange(stop_, false);
    state_ = renderer_.complete() && !unproven_ ? State::Complete : stopped ? State::Cancelled : State::Drawing;
}

/// Of the renderer's picture as it is now.
ShownPicture FrameDriver::described(const Wanted& wanted) const {
    const FrameRequest& drawn = renderer_.plan().request;
    const StaticVersions& now = renderer_.plan().versions;
    const bool again = shown_.number > 0 && shown_.number < begun_ && drawn.width == shown_.drawn.width &&
                       drawn.height == shown_.drawn.height && drawn.samplesPerPixel == shown_.drawn.samplesPerPixel;
    const bool cached = shown_.number == begun_ ? shown_.cached
                                                : again && !uncached_ &&
                                                      ((now.samples != 0 && now.samples == versions_.samples) ||
                                                       (now.lit != 0 && now.lit == versions_.lit));
    ShownPicture picture{begun_,
                         drawn,
                         level_ > 0,
                         wanted.technique->description().name,
                         sampleCountLabel(*wanted.technique, drawn.samplesPerPixel),
                         wanted.technique->renders(),
                         renderer_.rendersDone(),
                         renderer_.renders(),
                         wanted.instant,
                         cached,
                         times_.frames() > 0 ? times_.medianTotal() : 0.0,
                         times_.newestTotal(),
                         {},
                         momentKeyOf(wanted.request)};
    for (const Setting& setting : settingsOf(*wanted.technique)) picture.settings.push_back(setting.get());
    return picture;
}

/// A copy: the renderer's own changes while the next picture is drawn.
void FrameDriver::show(ShownPicture shown) {
    const gl::Texture& picture = renderer_.displayTexture();
    const int width = picture.width(), height = picture.height();
    if (!copy_ || copy_->width() != width || copy_->height() != height) {
        copy_ = gl::Texture::image2D("picture shown", GL_RGBA8, width, height);
        copy_->setFilters(GL_LINEAR, GL_LINEAR);
    }
    glCopyImageSubData(picture.name(), GL_TEXTURE_2D, 0, 0, 0, 0, copy_->name(), GL_TEXTURE_2D, 0, 0, 0, 0, width,
                       height, 1);
    uncached_ = false;
    versions_ = renderer_.plan().versions;
    shown_ = std::move(shown);
}

/// A pause has ended the picture: it is begun anew, unless it is not to be drawn at all.
void FrameDriver::giveUp() {
    const bool stopped = std::exchange(stop_, false);
    hasPlan_ = false;
    unproven_.reset();
    restart_ = !stopped;
    refine_ = !stopped;
    state_ = stopped ? State::Cancelled : State::Drawing;
    toMeasure_ = toSettle_ = 0;
}

std::optional<double> FrameDriver::progress() const {
    if (!drawing_ || level_ > 0 || moving_ || renderer_.renders() != 1) return std::nullopt;
    return workDone();
}

void FrameDriver::readTimes() {
    // The renders of brute force add up.
    if (!renderer_.complete()) return;
    if (const auto readings = renderer_.timer().endFrame()) times_.add(*readings);
}

/// Figures arrive later than pictures are shown.
void FrameDriver::takeTimes() {
    const auto readings = renderer_.timer().arrived();
    if (!readings) return;
    times_.add(*readings);
    shown_.milliseconds = times_.medianTotal();
    shown_.newest = times_.newestTotal();
}

void FrameDriver::forgetTimes() {
    renderer_.timer().dropAll();  // times still on their way belong to what was drawn before
    times_.reset();
}

void FrameDriver::fail(const char* what) {
    // What OpenGL remembers of it must not be taken for the next picture's failure.
    gl::takeErrors();
    failure_ = what;
    state_ = State::Failed;
    toMeasure_ = toSettle_ = 0;
    refine_ = false;
    shown_ = {};
    unproven_.reset();
}

void FrameDriver::cancel() {
    const bool waits = state_ == State::Complete && refine_;  // for the full picture
    if (state_ != State::Drawing && !waits) return;
    toMeasure_ = 0;
    if (drawing_) {
        stop_ = true;  // it ends at the pause
        return;
    }
    state_ = State::Cancelled;
    refine_ = restart_ = false;
}

void FrameDriver::resume() {
    if (state_ != State::Cancelled) return;
    if (hasPlan_ && renderer_.rendersDone() > 0) {
        state_ = State::Drawing;
    } else {
        state_ = State::Complete;  // of the preview
        refine_ = true;
    }
}

void FrameDriver::warmUp() { warmUp_ = refine_ = true; }

void FrameDriver::measure(int pictures) { measureNext_ = pictures; }

std::optional<double> FrameDriver::sleep(double now) const {
    if (state_ == State::Drawing || restart_ || renderer_.timer().awaits() || measuring() ||
        (toSettle_ > 0 && state_ == State::Complete && level_ == 0))
        return 0.0;
    if (refine_) return std::max(0.0, settleSeconds - (now - lastChange_));
    return std::nullopt;
}

}  // namespace timeshade
