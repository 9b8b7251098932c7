#include "measure/reference_noise.h"

#include <cmath>

#include "measure/metrics.h"
#include "measure/reference_technique.h"

namespace timeshade {

double referenceNoise(FrameRenderer& renderer, FramePlanner& planner, const FrameRequest& request,
                      const LinearImage& reference, int samplesPerPixel) {
    FrameRequest batch = request;
    batch.samplesPerPixel = maximumSamplesPerPixel;
    batch.samples = CameraSamples::Strata;
    batch.pixelCentres = false;  // as of the reference
    batch.seed = 0x7ef10000u;    // neither the reference's nor one that is likely to be asked for
    ReferenceTechnique technique;
    renderer.draw(planner.plan(batch), technique, View::Final);
    renderer.timer().finishFrame();
    const double distance = compareImages(renderer.readRadiance(), reference).rmse;
    const double batches = std::ceil(static_cast<double>(samplesPerPixel) / maximumSamplesPerPixel);
    return distance / std::sqrt(1.0 + batches);
}

}  // namespace timeshade
