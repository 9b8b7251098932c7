#include "support/lit_centres.h"

#include "support/gl_environment.h"

namespace timeshade {

namespace {

double litFor(const FrameRenderer::PartValue& value) {
    const double exposure = static_cast<double>(value.part.end) - static_cast<double>(value.part.begin);
    return value.part.triangle == NO_TRIANGLE ? exposure : exposure * static_cast<double>(value.lit * value.tested);
}

}  // namespace

std::vector<double> litAtCentres(const Scene& scene, FrameRequest request, Technique& technique, std::uint32_t seeds) {
    FramePlanner planner(scene);
    FrameRenderer& renderer = sharedRenderer();
    std::vector<double> lit(static_cast<std::size_t>(request.width) * static_cast<std::size_t>(request.height));
    if (request.samples == CameraSamples::Intervals) {
        renderer.draw(planner.plan(request), technique, View::Visibility);
        for (const FrameRenderer::PartValue& value : renderer.readParts()) lit[value.part.place] += litFor(value);
        return lit;
    }
    for (request.seed = 1; request.seed <= seeds; ++request.seed) {
        renderer.draw(planner.plan(request), technique, View::Visibility);
        const std::vector<float> values = renderer.readVisibility();
        for (std::size_t i = 0; i < values.size(); ++i)
            lit[i % lit.size()] += static_cast<double>(values[i]) / request.samplesPerPixel / seeds;
    }
    return lit;
}

}  // namespace timeshade
