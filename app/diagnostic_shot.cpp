#include "diagnostic_shot.h"

#include "core/error.h"
#include "measure/diagnostic_views.h"
#include "measure/reference.h"
#include "progress.h"

namespace timeshade {

DisplayImage drawDiagnostic(FrameRenderer& renderer, const FramePlan& plan, Technique& technique,
                            Diagnostic diagnostic) {
    const int width = plan.request.width, height = plan.request.height;
    if (diagnostic == Diagnostic::Error) {
        ReferenceCache cache;
        ReferenceOptions how;
        const Progress progress(how.samplesPerPixel / maximumSamplesPerPixel);
        how.progress = [&](int done, int) { progress.update(done); };
        const LinearImage reference = referenceImage(renderer, plan, how, cache);
        renderer.draw(plan, technique, View::Final);
        return errorView(renderer.readRadiance(), reference);
    }
    if (plan.block.positions > 0)
        throw UsageError(
            "--view disagreement: interval samples have no instant to be wrong at; expected --samples strata");
    DisagreementView view(width, height);
    VerificationOptions how;
    how.checkPrimaries = false;
    how.visit = [&](const VerifiedSample& sample) { view.add(sample); };
    verifyFrame(renderer, plan, technique, how);
    renderer.draw(plan, technique, View::Final);
    return view.draw(renderer.readPicture());
}

}  // namespace timeshade
