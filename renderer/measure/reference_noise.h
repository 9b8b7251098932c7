#pragma once

#include "frame/frame_renderer.h"

namespace timeshade {

/// The noise of a reference image of `samplesPerPixel` samples: RMS over values of its distance from the mean of
/// infinitely many samples, in linear light. An image RMSE measured against the reference holds it. From one more batch
/// of the reference, with samples of its own: of two independent means of m and n samples the mean square distance is
/// that of one sample times 1 / m + 1 / n.
double referenceNoise(FrameRenderer& renderer, FramePlanner& planner, const FrameRequest& request,
                      const LinearImage& reference, int samplesPerPixel);

/// Whether noise of the reference is more than half of what was measured as mean square error.
inline bool noiseDominates(double rmse, double referenceNoise) {
    return 2.0 * referenceNoise * referenceNoise > rmse * rmse;
}

}  // namespace timeshade
