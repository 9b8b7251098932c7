#include "compare/truth_picture.h"

#include "compare/compared_side.h"
#include "measure/display_encoding.h"

namespace timeshade {

FramePlan truthPlan(FramePlanner& planner, FrameRequest request) {
    request.samples = CameraSamples::Strata;
    request.samplesPerPixel = maximumSamplesPerPixel;
    return planner.plan(request);
}

ReferenceOptions truthOptions(View view) {
    ReferenceOptions options;
    options.samplesPerPixel = truthSamples;
    options.view = view;
    return options;
}

DisplayImage truthShown(const LinearImage& truth, View view, const DisplayLook& look) {
    return displayed(truth, view == View::Final ? look : DisplayLook{0.0, ToneMap::Linear});
}

std::optional<LinearImage> drawTruth(FrameRenderer& renderer, FramePlanner& planner, const FrameRequest& request,
                                     View view, const std::function<bool(int done, int all)>& progress) {
    const ReferenceCache cache;
    ReferenceBuilder builder(truthPlan(planner, request), truthOptions(view), cache);
    do {
        if (!progress(builder.batchesDone(), builder.batches())) return std::nullopt;
    } while (!builder.step(renderer));
    return builder.image();
}

}  // namespace timeshade
