#include "measure/convergence.h"

#include <memory>

#include <fmt/format.h>

#include "core/error.h"
#include "measure/metrics.h"
#include "measure/reference_technique.h"
#include "measure/technique_variant.h"
#include "techniques/registry.h"

namespace timeshade {

std::vector<std::string> convergingTechniques() {
    gl::ProgramCache programs;
    std::vector<std::string> names;
    for (const TechniqueDescription& description : techniqueDescriptions())
        if (makeTechnique(description.name, programs)->settlingFrames() > 0) names.push_back(description.name);
    return names;
}

std::vector<ConvergenceCurve> convergenceCurves(const std::vector<std::string>& variants) {
    gl::ProgramCache programs;
    std::vector<ConvergenceCurve> curves;
    for (const std::string& variant : variants) {
        if (TechniqueVariant::of(variant).make({}, programs)->settlingFrames() == 0)
            throw UsageError(fmt::format(
                "--convergence: {} draws a still picture once; expected techniques that go on improving it, as {}",
                variant, fmt::join(convergingTechniques(), ", ")));
        curves.push_back({variant, variant});
        curves.push_back({variant + ", after motion", variant, true});
    }
    return curves;
}

DisplayImage referencePicture(FrameRenderer& renderer, const FramePlan& plan) {
    ReferenceTechnique reference;
    renderer.draw(plan, reference, View::Final);
    return renderer.readPicture();
}

void measureConvergence(FrameRenderer& renderer, const std::vector<FramePlan>& approach, const FramePlan& plan,
                        const DisplayImage& reference, const std::vector<std::pair<std::string, std::string>>& settings,
                        const std::vector<int>& frames, ConvergenceCurve& curve) {
    const std::unique_ptr<Technique> technique =
        TechniqueVariant::of(curve.variant).make(settings, renderer.programs());
    if (curve.afterMotion)
        for (const FramePlan& before : approach) renderer.draw(before, *technique, View::Final);
    int drawn = 0;
    for (const int frame : frames) {
        for (; drawn < frame; ++drawn) renderer.draw(plan, *technique, View::Final);
        curve.pictures.push_back(renderer.readPicture());
        curve.offBy30.push_back(100.0 * shareOffBy(curve.pictures.back(), reference, visibleLevels));
    }
    renderer.timer().finishFrame();  // its time is of no interest
}

std::string convergenceTable(const std::vector<ConvergenceCurve>& curves, const std::vector<int>& frames) {
    std::string text = "| frames |";
    std::string rule = "| --- |";
    for (const int frame : frames) {
        text += fmt::format(" {} |", frame);
        rule += " ---: |";
    }
    text += "\n" + rule + "\n";
    for (const ConvergenceCurve& curve : curves) {
        text += fmt::format("| {} |", curve.name);
        for (const double percent : curve.offBy30) text += fmt::format(" {:.3f} % |", percent);
        text += "\n";
    }
    return text;
}

std::string convergenceCsv(const std::vector<ConvergenceCurve>& curves, const std::vector<int>& frames) {
    std::string text = "curve,frames,percent_off_by_30\n";
    for (const ConvergenceCurve& curve : curves)
        for (std::size_t i = 0; i < frames.size(); ++i)
            text += fmt::format("\"{}\",{},{:.6g}\n", curve.name, frames[i], curve.offBy30[i]);
    return text;
}

Chart convergenceChart(const std::string& scene, const std::vector<ConvergenceCurve>& curves,
                       const std::vector<int>& frames) {
    Chart chart;
    chart.title = scene + ": pixels off by more than 30 of 255 while the camera stands";
    chart.subtitle = "against the ray-traced hard shadow; from an empty history where nothing else is said";
    chart.xLabel = "frames";
    chart.yLabel = "% of the pixels";
    chart.slopes = {{-0.5, "1 / √n"}, {-1.0, "1 / n"}};
    for (const ConvergenceCurve& curve : curves) {
        ChartSeries series{curve.name, {}};
        for (std::size_t i = 0; i < frames.size(); ++i)
            series.points.push_back({static_cast<double>(frames[i]), curve.offBy30[i], ""});
        chart.series.push_back(std::move(series));
    }
    return chart;
}

}  // namespace timeshade
