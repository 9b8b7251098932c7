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

std::unique_ptr<Technique> convergingTechnique(FrameRenderer& renderer, const std::string& variant,
                                               const std::vector<std::pair<std::string, std::string>>& settings) {
    return TechniqueVariant::of(variant).make(settings, renderer.programs());
}

ConvergenceReferences convergenceReferences(FrameRenderer& renderer, const FramePlan& plan, Technique& technique) {
    ConvergenceReferences references;
    ReferenceTechnique truth;
    renderer.draw(plan, truth, View::Final);
    references.rayTraced = renderer.readPicture();
    technique.forget();
    for (int drawn = 0; drawn < convergedFrames; ++drawn) renderer.draw(plan, technique, View::Final);
    references.own = renderer.readPicture();
    renderer.timer().finishFrame();
    return references;
}

void measureConvergence(FrameRenderer& renderer, const StillMoment& moment, Technique& technique,
                        const ConvergenceReferences& references, const std::vector<int>& frames,
                        ConvergenceCurve& curve) {
    technique.forget();
    if (curve.afterMotion)
        for (const FramePlan& before : moment.approach) renderer.draw(before, technique, View::Final);
    int drawn = 0;
    for (const int frame : frames) {
        for (; drawn < frame; ++drawn) renderer.draw(moment.plan, technique, View::Final);
        curve.pictures.push_back(renderer.readPicture());
        curve.offBy30.push_back(100.0 * shareOffBy(curve.pictures.back(), references.rayTraced, visibleLevels));
        curve.offFromOwn.push_back(100.0 * shareOffBy(curve.pictures.back(), references.own, visibleLevels));
    }
    renderer.timer().finishFrame();  // its time is of no interest
}

namespace {

const std::vector<double>& offFrom(const ConvergenceCurve& curve, ConvergenceTarget target) {
    return target == ConvergenceTarget::Own ? curve.offFromOwn : curve.offBy30;
}

}  // namespace

std::string convergenceTable(const std::vector<ConvergenceCurve>& curves, const std::vector<int>& frames,
                             ConvergenceTarget target) {
    std::string text = "| frames |";
    std::string rule = "| --- |";
    for (const int frame : frames) {
        text += fmt::format(" {} |", frame);
        rule += " ---: |";
    }
    text += "\n" + rule + "\n";
    for (const ConvergenceCurve& curve : curves) {
        text += fmt::format("| {} |", curve.name);
        for (const double percent : offFrom(curve, target)) text += fmt::format(" {:.3f} % |", percent);
        text += "\n";
    }
    return text;
}

std::string convergenceCsv(const std::vector<ConvergenceCurve>& curves, const std::vector<int>& frames) {
    std::string text = "curve,frames,percent_off_by_30,percent_off_by_30_from_own_converged\n";
    for (const ConvergenceCurve& curve : curves)
        for (std::size_t i = 0; i < frames.size(); ++i)
            text +=
                fmt::format("\"{}\",{},{:.6g},{:.6g}\n", curve.name, frames[i], curve.offBy30[i], curve.offFromOwn[i]);
    return text;
}

Chart convergenceChart(const std::string& scene, const std::vector<ConvergenceCurve>& curves,
                       const std::vector<int>& frames, ConvergenceTarget target) {
    Chart chart;
    chart.title = scene + ": pixels off by more than 30 of 255 while the camera stands";
    chart.subtitle =
        fmt::format("against {}; from an empty history where nothing else is said",
                    target == ConvergenceTarget::Own ? fmt::format("its own picture after {} frames", convergedFrames)
                                                     : std::string("the ray-traced hard shadow"));
    chart.xLabel = "frames";
    chart.yLabel = "% of the pixels";
    chart.slopes = {{-0.5, "1 / √n"}, {-1.0, "1 / n"}};
    for (const ConvergenceCurve& curve : curves) {
        ChartSeries series{curve.name, {}};
        for (std::size_t i = 0; i < frames.size(); ++i)
            series.points.push_back({static_cast<double>(frames[i]), offFrom(curve, target)[i], ""});
        chart.series.push_back(std::move(series));
    }
    return chart;
}

}  // namespace timeshade
