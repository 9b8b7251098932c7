#include "measure/frame_clock.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "core/error.h"
#include "frame/warm_up.h"
#include "gl/uploads.h"
#include "gl/waits.h"
#include "measure/stopwatch.h"

namespace timeshade {

namespace {

/// Programs of other techniques may have taken the places of this one's: these are compiled in a first attempt.
constexpr int attempts = 3;

using Clock = std::chrono::steady_clock;

}  // namespace

std::map<std::string, double> stepsOf(const std::vector<gl::PassTimer::Reading>& readings) {
    std::map<std::string, double> steps;
    for (const gl::PassTimer::Reading& reading : readings) steps[reading.name] = reading.milliseconds;
    steps["total"] = gl::totalOf(readings);
    return steps;
}

void FrameClock::warmUp(Technique& technique, const FrameRequest& request, int steadyFrames) {
    drawVariants(renderer_, planner_, technique, request, view_, techniqueView_);
    // The renders of brute force are alike, and many: the few above have met all states.
    if (technique.renders() == 1) timeOnce(technique, request, steadyFrames);
}

std::vector<ClockedFrame> FrameClock::time(Technique& technique, const FrameRequest& request, int steadyFrames) {
    for (int attempt = 0; attempt < attempts; ++attempt) {
        compiled_ = false;
        std::vector<ClockedFrame> frames = timeOnce(technique, request, steadyFrames);
        if (!compiled_) return frames;
        warmUp(technique, request, steadyFrames);
    }
    throw Error(fmt::format("technique {}: programs were compiled in timed frames, {} times in a row; expected none",
                            technique.description().name, attempts));
}

std::vector<ClockedFrame> FrameClock::timeOnce(Technique& technique, const FrameRequest& request, int steadyFrames) {
    std::vector<ClockedFrame> frames;
    emptyCaches(renderer_, technique);
    frames.push_back(draw(technique, request, request.frame, FrameState::Cold));
    if (warmUpCount(technique) == 0) {
        if (technique.renders() == 1)
            frames.push_back(draw(technique, request, request.frame - steadyFrames, FrameState::Filling));
        for (int before = steadyFrames - 1; before >= 0; --before)
            frames.push_back(draw(technique, request, request.frame - before, FrameState::Steady));
        return frames;
    }
    technique.forget();
    std::vector<ClockedFrame> sequence;
    for (int before = technique.warmUpFrames(); before > 0; --before)
        sequence.push_back(draw(technique, request, request.frame - before, FrameState::Steady));
    for (int drawn = 0; drawn <= technique.heldFrames(); ++drawn)
        sequence.push_back(draw(technique, request, request.frame, FrameState::Steady));
    const auto counted = std::min<std::ptrdiff_t>(steadyFrames, static_cast<std::ptrdiff_t>(sequence.size()));
    frames.insert(frames.end(), sequence.end() - counted, sequence.end());
    return frames;
}

ClockedFrame FrameClock::draw(Technique& technique, FrameRequest request, double frame, FrameState state) {
    request.frame = frame;
    for (;;) {
        ClockedFrame clocked = drawOnce(technique, request, state);
        if (renderer_.settledRoom() == gl::LateCounts::State::Sufficed) return clocked;
    }
}

ClockedFrame FrameClock::drawOnce(Technique& technique, const FrameRequest& request, FrameState state) {
    const std::uint64_t compiled = renderer_.programs().compiled(), waits = gl::waitsSoFar(),
                        uploaded = gl::bytesUploadedSoFar();
    ClockedFrame clocked;
    clocked.state = state;
    const Clock::time_point begin = Clock::now();
    FramePlan plan = planner_.plan(request);
    clocked.planMilliseconds = millisecondsSince(begin);
    renderer_.begin(std::move(plan), technique, view_, techniqueView_, counts_);
    while (!renderer_.step()) {
    }
    clocked.waits = gl::waitsSoFar() - waits;
    clocked.uploaded = gl::bytesUploadedSoFar() - uploaded;
    clocked.readings = renderer_.timer().finishFrame();
    clocked.wholeMilliseconds = millisecondsSince(begin);
    compiled_ = compiled_ || renderer_.programs().compiled() != compiled;
    return clocked;
}

}  // namespace timeshade
