#include "compare/compared_shot.h"

#include <optional>

#include <nlohmann/json.hpp>

#include "compare/compared_techniques.h"
#include "compare/truth_picture.h"
#include "frame/warm_up.h"
#include "progress.h"
#include "report.h"

namespace timeshade {

namespace {

DisplayImage truthOf(FrameRenderer& renderer, FramePlanner& planner, const FrameRequest& request, View view) {
    std::optional<Progress> progress;
    const std::optional<LinearImage> truth = drawTruth(renderer, planner, request, view, [&](int done, int all) {
        if (!progress) progress.emplace(all);
        progress->update(done);
        return true;
    });
    return truthShown(*truth, view, request.look);
}

}  // namespace

std::string manifestOfSide(const std::string& name, int samples, int width, int height) {
    nlohmann::ordered_json json;
    json["picture"] = name;
    if (samples > 0) json["spp"] = samples;
    json["size"] = {width, height};
    return json.dump(2);
}

ComparedShot drawCompared(FrameRenderer& renderer, FramePlanner& planner, const FrameRequest& given,
                          const PictureOptions& options, const Scene& scene, const std::string& backEnd) {
    const std::vector<ComparedTechnique> techniques = techniquesFor(options, renderer.programs());
    const FrameRequest request = askedByAll(given, techniques);
    ComparedShot shot;
    std::vector<DisplayImage> pictures;
    nlohmann::ordered_json manifests;
    const auto add = [&](const std::string& text) {
        manifests["compare"].push_back(nlohmann::ordered_json::parse(text));
    };
    for (const ComparedTechnique& compared : techniques) {
        if (compared.file) {
            pictures.push_back(compared.file->shown(request.look));
            add(manifestOfSide(compared.file->path(), 0, request.width, request.height));
            continue;
        }
        if (!compared.technique) {
            pictures.push_back(truthOf(renderer, planner, request, options.view));
            add(manifestOfSide(truthName, truthSamples, request.width, request.height));
            continue;
        }
        const FrameRequest own = compared.on(request);
        drawWarmUp(renderer, planner, *compared.technique, own, options.view);
        renderer.draw(planner.plan(own), *compared.technique, options.view, options.techniqueView);
        const auto times = renderer.timer().finishFrame();
        shot.milliseconds += gl::totalOf(times);
        pictures.push_back(renderer.readPicture());
        add(manifest(renderer, *compared.technique, options.scene, scene, backEnd, times));
    }
    shot.picture = composedFor(options, options.seam, labelsOf(techniques), pictures, PictureText());
    shot.manifests = manifests.dump(2) + "\n";
    return shot;
}

}  // namespace timeshade
