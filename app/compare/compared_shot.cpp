#include "compare/compared_shot.h"

#include <nlohmann/json.hpp>

#include "compare/compared_techniques.h"
#include "frame/warm_up.h"
#include "report.h"

namespace timeshade {

ComparedShot drawCompared(FrameRenderer& renderer, FramePlanner& planner, const FrameRequest& given,
                          const PictureOptions& options, const Scene& scene, const std::string& backEnd) {
    const std::vector<ComparedTechnique> techniques = techniquesFor(options, renderer.programs());
    const FrameRequest request = askedByAll(given, techniques);
    ComparedShot shot;
    std::vector<DisplayImage> pictures;
    nlohmann::ordered_json manifests;
    for (const ComparedTechnique& compared : techniques) {
        drawWarmUp(renderer, planner, *compared.technique, request, options.view);
        renderer.draw(planner.plan(request), *compared.technique, options.view, options.techniqueView);
        const auto times = renderer.timer().finishFrame();
        shot.milliseconds += gl::totalOf(times);
        pictures.push_back(renderer.readPicture());
        manifests["compare"].push_back(nlohmann::ordered_json::parse(
            manifest(renderer, *compared.technique, options.scene, scene, backEnd, times)));
    }
    shot.picture = composedFor(options, options.seam, labelsOf(techniques), pictures, PictureText());
    shot.manifests = manifests.dump(2) + "\n";
    return shot;
}

}  // namespace timeshade
