#include "techniques/history/history_state.h"

#include <cmath>

#include "techniques/history/dynamic_mask.h"

namespace timeshade {

namespace {

/// A window on a slow machine leaves frames out while it plays; farther on, somebody has sought.
constexpr double longestStep = 8.0;

bool sameSetup(const HistoryState::Past& past, const FramePlan& plan, const std::vector<double>& settings) {
    const FrameRequest &a = past.request, &b = plan.request;
    const double step = b.frame - a.frame;
    return a.width == b.width && a.height == b.height && a.samplesPerPixel == b.samplesPerPixel &&
           a.mapSize == b.mapSize && a.seed == b.seed && a.pixelCentres == b.pixelCentres && a.shutter == b.shutter &&
           a.cameraIndex == b.cameraIndex && past.topology == plan.mesh->topology && step >= 0.0 &&
           step <= longestStep && past.settings == settings;
}

bool sameEnd(const ViewEnd& a, const ViewEnd& b) {
    return a.eye == b.eye && a.corner == b.corner && a.right == b.right && a.up == b.up;
}

bool sameLight(const LightPose& a, const LightPose& b) {
    // A directional light shines from everywhere alike.
    return a.kind == b.kind && a.axes == b.axes && (a.kind == LightKind::Directional || a.position == b.position);
}

}  // namespace

FrameTransition HistoryState::follow(const FramePlan& plan, const std::vector<double>& settings) {
    FrameTransition transition;
    const bool goesOn = past_ && sameSetup(*past_, plan, settings);
    std::shared_ptr<const MeshTexels> texels = plan.texels;
    if (goesOn) {
        const bool sameMesh = past_->texels == plan.texels || past_->texels->positions == plan.texels->positions;
        const bool sameCamera =
            sameEnd(past_->camera.open, plan.camera.open) && sameEnd(past_->camera.close, plan.camera.close);
        const bool lightCached =
            sameLight(past_->lightOpen, plan.lightOpen) && sameLight(past_->lightClose, plan.lightClose);
        const bool sameFrame = past_->request.frame == plan.request.frame;
        if (sameMesh) texels = past_->texels;  // so that what has been uploaded of it stays good
        // A light that moves within the shutter has been elsewhere a frame ago.
        transition.hasPast = sameFrame || (lightCached && sameLight(plan.lightOpen, plan.lightClose));
        transition.held = sameFrame && sameMesh && sameCamera;
        transition.cameraMoved = !sameCamera;
        // Where something goes on moving in a way that looks the same each frame, its shadow has moved in between.
        if (!transition.held && (!sameMesh || plan.motion.movingTriangles > 0))
            transition.dynamicCasters = dynamicCastersBetween(*past_->texels, *plan.texels);
        transition.moved = !sameCamera || !transition.dynamicCasters.empty();
        transition.heldFrames = sameFrame ? past_->heldFrames + 1 : 0;
        transition.staticFrames = sameCamera ? past_->staticFrames + 1 : 0;
        transition.cameraStopped = sameCamera && past_->cameraMoved;
        transition.unmovedFrames = transition.hasPast && !transition.moved ? past_->unmovedFrames + 1 : 0;
    }
    const double whole = std::floor(plan.request.frame);
    const std::uint32_t frame = static_cast<std::uint32_t>(static_cast<std::int64_t>(whole) & 0xffff) +
                                static_cast<std::uint32_t>(transition.heldFrames);
    // Pixels that are asked in every 16th or 32nd frame must not always find the same half of a base 2 sequence: 17, 18
    // and 35 are no such steps.
    transition.index = frame + frame / 16 + frame / 32;
    before_ = goesOn ? std::move(past_) : std::nullopt;
    past_ = Past{plan.request,
                 plan.mesh->topology,
                 std::move(texels),
                 {},
                 plan.lightOpen,
                 plan.lightClose,
                 settings,
                 transition.heldFrames,
                 transition.staticFrames,
                 transition.unmovedFrames,
                 transition.cameraMoved};
    past_->camera.open = plan.camera.open;
    past_->camera.close = plan.camera.close;
    past_->camera.block.nearDistance = plan.camera.block.nearDistance;
    return transition;
}

}  // namespace timeshade
