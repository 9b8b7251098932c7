#include "measure/sweep_points.h"

#include "measure/reference_technique.h"
#include "measure/technique_variant.h"

namespace timeshade {

bool isBaseline(const SweepPoint& point) { return point.technique == "embree"; }

FrameRequest requestOf(const SweepScene& scene, const SweepPoint& point) {
    FrameRequest request = scene.request;
    // The baseline traces rays, each of which has a time.
    if (isBaseline(point))
        request.samples = CameraSamples::Strata;
    else
        request = TechniqueVariant::onItsSamples(point.technique).on(std::move(request));
    request.samplesPerPixel = point.sampleCount;
    request.mapSize = point.mapSize;
    return request;
}

std::unique_ptr<Technique> makeSubject(const SweepPoint& point, const SweepOptions& options,
                                       gl::ProgramCache& programs) {
    if (isBaseline(point)) return std::make_unique<ReferenceTechnique>();
    std::unique_ptr<Technique> technique =
        TechniqueVariant::onItsSamples(point.technique).make(options.settings, programs);
    if (technique->renders() > 1)
        setFromText(*technique, "renders", std::to_string(bruteForceRenders(point.sampleCount)));
    return technique;
}

std::vector<SweepPoint> pointsOf(const SweepOptions& options, const SweepScene& scene) {
    std::vector<SweepPoint> points;
    for (const std::string& technique : options.techniques)
        for (const MapSize& mapSize : options.mapSizes) {
            for (const int sampleCount : options.sampleCounts) {
                points.push_back({scene.name, technique, sampleCount, mapSize, scene.varied, scene.variedValue});
                if (isBaseline(points.back()) && mapSize != options.mapSizes.front()) points.pop_back();  // has no map
            }
        }
    return points;
}

}  // namespace timeshade
