#include "measure/convergence.h"

#include <utility>

#include <fmt/format.h>

#include "measure/metrics.h"
#include "measure/reference_technique.h"
#include "techniques/registry.h"

namespace timeshade {

std::vector<ConvergenceCurve> historyCurves() {
    using Settings = std::vector<std::pair<std::string, std::string>>;
    const Settings published{{"as_published", "on"}, {"jitter", "2"}, {"fit", "0"}, {"bias", "0.5"}};
    const auto with = [](Settings settings, const Settings& more) {
        settings.insert(settings.end(), more.begin(), more.end());
        return settings;
    };
    const Settings three{{"m", "3"}, {"m_still", "3"}}, fifteen{{"m", "15"}, {"m_still", "15"}};
    // The paper's own answers, kept as sums.
    const Settings summed{{"try_triangles", "off"}}, turned{{"try_triangles", "off"}, {"jitter", "2"}};
    return {{"as published, m = 3", with(published, three)},
            {"as published, m = 15", with(published, fifteen)},
            {"as published, m from 3 to 15", published},
            {"as published, not turned", with(published, {{"jitter", "1"}})},
            {"as published, after motion", published, true},
            {"sums, m = 3", with(turned, three)},
            {"sums, m = 15", with(turned, fifteen)},
            {"sums, m from 3 to 15", turned},
            {"sums, not turned", summed},
            {"repaired", {}},
            {"repaired, after motion", {}, true}};
}

DisplayImage referencePicture(FrameRenderer& renderer, const FramePlan& plan) {
    ReferenceTechnique truth;
    renderer.draw(plan, truth, View::Final);
    return renderer.readPicture();
}

void measureConvergence(FrameRenderer& renderer, const std::vector<FramePlan>& approach, const FramePlan& plan,
                        const DisplayImage& reference, const std::string& name,
                        const std::vector<std::pair<std::string, std::string>>& settings,
                        const std::vector<int>& frames, ConvergenceCurve& curve) {
    const std::unique_ptr<Technique> technique = makeTechnique(name, renderer.programs());
    for (const auto* list : {&settings, &std::as_const(curve.settings)})
        for (const auto& [key, value] : *list) setFromText(*technique, key, value);
    if (curve.afterMotion)
        for (const FramePlan& before : approach) renderer.draw(before, *technique, View::Final);
    int drawn = 0;
    for (const int frame : frames) {
        for (; drawn < frame; ++drawn) renderer.draw(plan, *technique, View::Final);
        curve.pictures.push_back(renderer.readPicture());
        curve.offBy30.push_back(100.0 * shareOffBy(curve.pictures.back(), reference, visibleLevels));
    }
    renderer.timer().finishFrame();  // nobody asks how long this took
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
