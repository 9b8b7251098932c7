// A shutter that is cut into linear pieces: what holds for the whole, and the samples of each.

#include <algorithm>
#include <bit>
#include <optional>

#include <fmt/format.h>

#include "core/check.h"
#include "plan/frame_plan.h"
#include "plan/own_samples.h"
#include "shared/shutter_response.shared.h"

namespace timeshade {

namespace {

/// The response in each piece, and how much the piece counts. One of a piece in which nothing moves is that of all.
void shareResponse(FramePlan& whole) {
    const auto steps = static_cast<std::uint32_t>(whole.pieces.size());
    shared::FrameBlock& block = whole.block;
    for (const FramePlan& piece : whole.pieces) {
        if (piece.block.response == SHUTTER_BOX) continue;
        block.response = piece.block.response;
        block.responseWidth = piece.block.responseWidth;
    }
    const auto exposedUntil = [&](std::uint32_t k) {
        return shared::shutterExposure(block.response, block.responseWidth,
                                       static_cast<float>(k) / static_cast<float>(steps));
    };
    const auto n = static_cast<std::uint32_t>(std::countr_zero(steps));
    for (std::uint32_t k = 0; k < steps; ++k) {
        shared::FrameBlock& piece = whole.pieces[k].block;
        piece.response = shared::responseOfPiece(block.response, n, k);
        piece.responseWidth = block.responseWidth;
        piece.weight = exposedUntil(k + 1) - exposedUntil(k);
    }
}

void shareMotion(FramePlan& whole) {
    MotionSummary& motion = whole.motion;
    for (const FramePlan& piece : whole.pieces) {
        const MotionSummary& own = piece.motion;
        motion.movingTriangles = std::max(motion.movingTriangles, own.movingTriangles);
        motion.lightMoves = motion.lightMoves || own.lightMoves;
        motion.lightTurnDegrees = std::max(motion.lightTurnDegrees, own.lightTurnDegrees);
        motion.cameraMoves = motion.cameraMoves || own.cameraMoves;
        motion.movingInstances = std::max(motion.movingInstances, own.movingInstances);
        motion.nonTranslatingInstances = std::max(motion.nonTranslatingInstances, own.nonTranslatingInstances);
        motion.largestTurnDegrees = std::max(motion.largestTurnDegrees, own.largestTurnDegrees);
    }
}

/// Of each kind the largest, with the piece in which it is.
void shareWarnings(FramePlan& whole) {
    const std::size_t steps = whole.pieces.size();
    whole.pathWarnings.clear();
    for (std::size_t k = 0; k < steps; ++k)
        for (PathWarning warning : whole.pieces[k].pathWarnings) {
            warning.text = fmt::format("piece {} of {} of the shutter: {}", k + 1, steps, warning.text);
            const auto same = std::find_if(whole.pathWarnings.begin(), whole.pathWarnings.end(),
                                           [&](const PathWarning& other) { return other.kind == warning.kind; });
            if (same == whole.pathWarnings.end())
                whole.pathWarnings.push_back(std::move(warning));
            else if (warning.size > same->size)
                *same = std::move(warning);
        }
    whole.warnings.clear();
    for (const PathWarning& warning : whole.pathWarnings) whole.warnings.push_back(warning.text);
}

/// The largest power of two up to the request's steps that divides its samples.
int stepsThatDivide(const FrameRequest& request) {
    int steps = request.motionSteps;
    while (request.samplesPerPixel % steps != 0) steps /= 2;
    return steps;
}

}  // namespace

int motionStepsOf(const FrameRequest& request) { return request.shutter.length == 0.0 ? 1 : stepsThatDivide(request); }

std::optional<std::string> loweredMotionSteps(const FrameRequest& request) {
    const int divisor = stepsThatDivide(request);
    if (divisor == request.motionSteps) return std::nullopt;
    return fmt::format("motion steps: {} instead of {}, since {} samples a pixel are shared by all pieces alike",
                       divisor, request.motionSteps, request.samplesPerPixel);
}

void shareSamples(FramePlan& plan) {
    const shared::FrameBlock& whole = plan.block;
    const auto steps = static_cast<std::uint32_t>(plan.pieces.size());
    for (std::uint32_t k = 0; k < steps; ++k) {
        FramePlan& piece = plan.pieces[k];
        shared::FrameBlock& block = piece.block;
        CHECK_EQ(whole.strata % steps, 0u);
        block.strata = whole.strata / steps;
        block.firstStratum = k * block.strata;
        block.wholeStrata = whole.strata;
        block.timeScale = 1.0f / static_cast<float>(block.strata);
        block.wholeTimeScale = whole.timeScale;
        block.seed = whole.seed;
        block.pixelCentres = whole.pixelCentres;
        piece.request.samplesPerPixel = static_cast<int>(block.strata);
        piece.request.pixelCentres = plan.request.pixelCentres;
        keepNoSamples(piece);  // other samples than those of any frame of one piece
    }
}

FramePlan planOfPieces(const FrameRequest& request, std::vector<FramePlan> pieces) {
    FramePlan whole = pieces.front();
    whole.pieces = std::move(pieces);
    const auto steps = static_cast<int>(whole.pieces.size());
    whole.request = request;
    whole.request.motionSteps = steps;
    keepNoSamples(whole);
    shareResponse(whole);
    shareSamples(whole);
    shareMotion(whole);
    shareWarnings(whole);
    whole.passes.insert(whole.passes.begin(),
                        {"motion steps",
                         fmt::format("{} linear pieces of the shutter, each drawn with {} of {} samples a pixel; what "
                                     "follows is that of the first",
                                     steps, request.samplesPerPixel / steps, request.samplesPerPixel),
                         0});
    return whole;
}

int rendersOf(const FramePlan& plan, int instants) {
    if (instants > 1) return instants;
    return std::max(1, static_cast<int>(plan.pieces.size()));
}

const FramePlan& pieceOf(const FramePlan& plan, int render, int instants) {
    if (plan.pieces.empty()) return plan;
    const int steps = static_cast<int>(plan.pieces.size());
    const int piece = instants > 1 ? (2 * render + 1) * steps / (2 * instants) : render;
    return plan.pieces.at(static_cast<std::size_t>(piece));
}

FramePlan renderOf(const FramePlan& plan, int render, int instants) {
    return instants > 1 ? planAtInstant(plan, render, instants) : pieceOf(plan, render, instants);
}

}  // namespace timeshade
