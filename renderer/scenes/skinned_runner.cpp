#include "scenes/skinned_runner.h"

#include <memory>

#include "scenes/runner_body.h"

namespace timeshade {

MeshInstance skinnedRunner(double cell, double pace, const Track& track, std::uint32_t material) {
    const RunnerBody& body = runnerBody(cell);
    MeshInstance runner;
    runner.shape = body.shape;
    runner.material = material;
    runner.flesh = std::make_shared<const Skin>(body.shape, body.influences,
                                                [=](double seconds) { return runningPose(seconds / pace, track); });
    return runner;
}

}  // namespace timeshade
