#include "verify.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "frame/warm_up.h"
#include "frame_setup.h"
#include "gl_checks.h"
#include "headless.h"
#include "make_context.h"
#include "measure/verification.h"
#include "measure/verification_json.h"
#include "progress.h"
#include "report.h"
#include "sample_dump.h"
#include "scene_catalogue.h"

namespace timeshade {

namespace {

std::string asJson(const Verification& v, const FrameRenderer& renderer, Technique& technique,
                   const std::string& sceneName, const Scene& scene, const std::string& backEnd) {
    nlohmann::ordered_json json =
        nlohmann::ordered_json::parse(manifest(renderer, technique, sceneName, scene, backEnd, {}));
    json.erase("milliseconds");
    json.update(asJson(v));
    return json.dump(2) + "\n";
}

std::string asText(const Verification& v, const std::string& scene, const std::string& technique) {
    std::string text = fmt::format("{} with {}\n", scene, technique);
    text += fmt::format("  tested        {:>10} of {} camera samples, {} truly in shadow\n", v.tested, v.samples,
                        v.shadowed);
    text += fmt::format("  disagree      {:>10} ({:.1f} ppm): {} false shadow, {} false lit, {} of them marginal\n",
                        v.disagree(), v.ppm(), v.falseShadow, v.falseLit, v.marginal);
    text += fmt::format("  |lit - truth| {:>10.6f} in the mean\n", v.meanAbsoluteError);
    text += fmt::format("  primaries     {:>10} see another triangle ({:.1f} ppm), and {} within 1e-6 of an edge\n",
                        v.primaryDisagree, v.primaryPpm(), v.primaryMarginal);
    text +=
        fmt::format("  ruled         {:>10} in double precision, {} against Embree\n", v.resolvedExactly, v.corrected);
    return text;
}

}  // namespace

int runVerify(const Options& options) {
    if (!options.json.empty() && options.json != "-") requireWritable(options.json);
    const std::unique_ptr<Scene> scene = openScene(options.scene, options.clip, options.settings);
    const FrameRequest request = requestFor(options, *scene);
    const std::unique_ptr<GlContext> context = makeContext(options.context, options.debugGl);
    const DriverWatch watch(options.debugGl);
    FrameRenderer renderer;
    renderer.setChecked(options.debugGl);
    const std::unique_ptr<Technique> technique = techniqueFor(options, renderer.programs());
    FramePlanner planner(*scene);
    const FramePlan plan = planner.plan(request);
    if (options.explain) fmt::print("{}", explain(plan, *technique, renderer.device()));

    std::optional<SampleDump> dump;
    VerificationOptions how;
    if (!options.dump.empty()) {
        dump.emplace(options.dump, plan);
        how.visit = [&](const VerifiedSample& sample) { dump->add(sample); };
    }
    Verification verification;
    {
        const Progress progress(technique->renders());
        how.progress = [&](int done, int) { progress.update(done); };
        drawWarmUp(renderer, planner, *technique, request, View::Visibility);
        verification = verifyFrame(renderer, plan, *technique, how);
    }
    watch.requireSilence();
    if (options.explain) fmt::print("{}", countedInWords(*technique));
    if (dump) dump->finish();
    const std::string json = asJson(verification, renderer, *technique, options.scene, *scene, context->backEnd());
    if (options.json == "-")
        fmt::print("{}", json);
    else
        fmt::print("{}", asText(verification, options.scene, options.technique));
    if (!options.json.empty() && options.json != "-") writeFileAtomically(options.json, json);
    if (options.maxPpm && verification.ppm() > *options.maxPpm) {
        fmt::print(stderr, "timeshade: {} ppm disagree; at most {:g} were allowed\n", verification.ppm(),
                   *options.maxPpm);
        return 3;
    }
    return 0;
}

}  // namespace timeshade
