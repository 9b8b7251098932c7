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
    renderer.timer().finishFrame();  // none of it is the picture's time
}

}  // namespace timeshade
