#include "frame/warm_up.h"

#include <fmt/format.h>

namespace timeshade {

int warmUpCount(const Technique& technique) { return technique.warmUpFrames() + technique.heldFrames(); }

std::string warmUpWords(const Technique& technique, const FrameRequest& request) {
    const int before = technique.warmUpFrames(), held = technique.heldFrames();
    std::string words;
    if (before > 0) words = fmt::format("frames {:g} to {:g}", request.frame - before, request.frame - 1.0);
    if (held > 0) words += fmt::format("{}frame {:g} {} times", words.empty() ? "" : ", then ", request.frame, held);
    return words;
}

void drawWarmUp(FrameRenderer& renderer, FramePlanner& planner, Technique& technique, const FrameRequest& request,
                View view) {
    if (warmUpCount(technique) == 0) return;
    technique.forget();
    FrameRequest earlier = request;
    for (int before = technique.warmUpFrames(); before > 0; --before) {
        earlier.frame = request.frame - before;
        renderer.draw(planner.plan(earlier), technique, view);
    }
    if (technique.heldFrames() > 0) {
        const FramePlan plan = planner.plan(request);
        for (int i = 0; i < technique.heldFrames(); ++i) renderer.draw(plan, technique, view);
    }
    renderer.timer().dropAll();  // none of it is the picture's time
}

void emptyCaches(FrameRenderer& renderer, Technique& technique) {
    renderer.invalidateAll();
    technique.forget();
}

void drawVariants(FrameRenderer& renderer, FramePlanner& planner, Technique& technique, const FrameRequest& request,
                  View view, const std::string& techniqueView) {
    // Of brute force three renders: its caches are empty in the first, fill in the second.
    const int renders = technique.renders() > 1 ? 3 : maximumMotionSteps;
    const auto draw = [&](double frame) {
        FrameRequest drawn = request;
        drawn.frame = frame;
        renderer.begin(planner.plan(drawn), technique, view, techniqueView);
        for (int i = 0; i < renders && !renderer.step(); ++i) {
        }
    };
    // Twice: a driver may compile a program once more for the state that the first time has left, as llvmpipe does.
    for (int i = 0; i < 2; ++i) {
        emptyCaches(renderer, technique);
        draw(request.frame);
        if (warmUpCount(technique) == 0) draw(request.frame - 1.0);
        drawWarmUp(renderer, planner, technique, request, view);
        draw(request.frame);
    }
    renderer.timer().dropAll();
}

}  // namespace timeshade
