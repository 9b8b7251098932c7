#include "verify.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "frame/warm_up.h"
#include "frame_setup.h"
#include "headless.h"
#include "headless_gl.h"
#include "measure/verification.h"
#include "measure/verification_json.h"
#include "progress.h"
#include "report.h"
#include "sample_dump.h"
#include "scene_catalogue.h"
#include "standard_error.h"

namespace timeshade {

namespace {

std::shared_ptr<const ReferenceVisibility> converged(const FramePlan& plan, int rays) {
    const Progress progress(plan.request.height * rendersOf(plan, 1));
    const ReferenceCache cache;
    return referenceVisibility(plan, rays, cache, [&](int rows, int) { progress.update(rows); });
}

std::string asJson(const Verification& v, const FrameRenderer& renderer, Technique& technique,
                   const std::string& sceneName, const Scene& scene, const std::string& backEnd) {
    nlohmann::ordered_json json =
        nlohmann::ordered_json::parse(manifest(renderer, technique, sceneName, scene, backEnd, {}));
    json.erase("milliseconds");
    json.update(asJson(v));
    return json.dump(2) + "\n";
}

std::string inWords(const Footprint& footprint) {
    static constexpr const char* times[] = {"an instant", "a stratum of the shutter", "the whole shutter"};
    std::string text = times[static_cast<int>(footprint.time)];
    text += footprint.space == Footprint::Space::Point ? " at a point" : " and what the pixel sees of the surface";
    if (footprint.filterTexels > 0.0) text += fmt::format(", blurred over {:g} texels", footprint.filterTexels);
    return text;
}

std::string inWords(const ErrorSummary& e) {
    return fmt::format("{:>10.6f} RMS (± {:.6f}), {:.6f} in the mean, {:.4f} at 99.9 %", e.rms, e.standardError, e.mean,
                       e.p999);
}

std::string errorsInWords(const Verification& v) {
    std::string text;
    if (const std::optional<ShadowError>& s = v.shadowError)
        text += fmt::format("  shadow error     {}; {} pixels, {} reference rays each\n", inWords(s->error),
                            s->error.count, s->rays);
    const FootprintError& f = v.footprintError;
    if (f.error.count > 0)
        text += fmt::format("  footprint error  {}; {} samples{}\n", inWords(f.error), f.error.count,
                            f.rays > 0 ? fmt::format(", {} rays each", f.rays) : "");
    return text + fmt::format("  footprint        {}\n", inWords(v.footprint));
}

std::string asText(const Verification& v, const std::string& scene, const std::string& technique) {
    std::string text = fmt::format("{} with {}\n{}", scene, technique, errorsInWords(v));
    if (v.intervals)
        return text + fmt::format("  tested           {:>10} of {} parts of what positions see\n", v.tested, v.samples);
    text += fmt::format("  tested           {:>10} of {} camera samples, {} truly in shadow\n", v.tested, v.samples,
                        v.shadowed);
    if (v.isBinary())
        text += fmt::format("  disagree         {:>10} ({:.1f} ppm): {} false shadow, {} false lit, {} marginal\n",
                            v.disagree(), v.ppm(), v.falseShadow, v.falseLit, v.marginal);
    text += fmt::format("  |lit - truth|    {:>10.6f} in the mean, at each sample's own instant and point\n",
                        v.meanAbsoluteError);
    text += fmt::format("  primaries        {:>10} see another triangle ({:.1f} ppm), and {} within 1e-6 of an edge\n",
                        v.primaryDisagree, v.primaryPpm(), v.primaryMarginal);
    text +=
        fmt::format("  resolved exactly {:>10} samples; in {} Embree was corrected\n", v.resolvedExactly, v.corrected);
    return text;
}

void requireBinary(const Technique& technique) {
    const Footprint footprint = technique.footprint();
    if (!footprint.isBinary())
        throw UsageError(
            fmt::format("--max-ppm: {} averages over {}, so its samples are shares of light and not right "
                        "or wrong; expected a technique and settings that look at an instant at a point",
                        technique.description().name, inWords(footprint)));
}

}  // namespace

int runVerify(const VerifyOptions& options) {
    if (!options.dump.empty()) {
        requireStrata(options, "--dump");
        requireOneMotionStep(options, "--dump");
    }
    if (options.maxPpm) requireStrata(options, "--max-ppm");
    if (!options.json.empty() && options.json != "-") requireWritable(options.json);
    const std::unique_ptr<Scene> scene = openScene(options.scene, choiceOf(options), options.settings);
    const FrameRequest given = requestFor(options, *scene);
    const HeadlessGl opengl(options);
    FrameRenderer renderer;
    renderer.setChecked(options.debugGl);
    const std::unique_ptr<Technique> technique = techniqueFor(options, renderer.programs());
    if (options.maxPpm) requireBinary(*technique);
    const FrameRequest request = technique->asked(given);
    FramePlanner planner(*scene);
    const FramePlan plan = planner.plan(request);
    if (options.explain) fmt::print("{}", explain(plan, *technique, renderer.device()));

    std::optional<SampleDump> dump;
    VerificationOptions how;
    if (!options.dump.empty()) {
        dump.emplace(options.dump, plan);
        how.visit = [&](const VerifiedSample& sample) { dump->add(sample); };
    }
    if (options.referenceRays > 0) how.reference = converged(plan, options.referenceRays);
    Verification verification;
    {
        const Progress progress(rendersOf(plan, technique->renders()));
        how.progress = [&](int done, int) { progress.update(done); };
        drawWarmUp(renderer, planner, *technique, request, View::Visibility);
        verification = verifyFrame(renderer, plan, *technique, how);
    }
    opengl.requireSilence();
    if (options.explain) fmt::print("{}{}", countedOfPositions(renderer), countedInWords(*technique));
    if (dump) dump->finish();
    const std::string json = asJson(verification, renderer, *technique, options.scene, *scene, opengl.backEnd());
    if (options.json == "-")
        fmt::print("{}", json);
    else
        fmt::print("{}", asText(verification, options.scene, options.technique));
    if (!options.json.empty() && options.json != "-") writeFileAtomically(options.json, json);
    if (options.maxPpm && verification.ppm() > *options.maxPpm) {
        tell(fmt::format("{} ppm disagree; at most {:g} were allowed", verification.ppm(), *options.maxPpm));
        return 3;
    }
    return 0;
}

}  // namespace timeshade
