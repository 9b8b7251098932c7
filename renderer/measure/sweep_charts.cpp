#include "measure/sweep_charts.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "measure/sweep_rows.h"

namespace timeshade {

Chart sweepChart(const std::vector<SweepRow>& rows, const std::string& scene, ChartOf what, bool softwareRenderer) {
    Chart chart;
    switch (what) {
    case ChartOf::ShadowError:
        chart.title = fmt::format("{}: what accuracy of shadows costs", scene);
        chart.yLabel = "shadow error (RMS)";
        chart.subtitle = "one curve per technique, samples per pixel (or renders, x) at the points";
        break;
    case ChartOf::ImageError:
        chart.title = fmt::format("{}: what accuracy of the image costs", scene);
        chart.yLabel = "image RMSE against the reference";
        chart.subtitle = "noise of camera samples included, which shadows have no part in";
        break;
    case ChartOf::Disagreement:
        chart.title = fmt::format("{}: wrong shadow samples against time", scene);
        chart.yLabel = "wrong shadow samples (ppm)";
        chart.subtitle = "camera samples whose lit value differs from the oracle's";
        break;
    }
    chart.xLabel =
        softwareRenderer ? "milliseconds per frame (software renderer, wall time)" : "milliseconds per frame (GPU)";
    for (const SweepRow& row : rowsOfCharts(rows)) {
        if (row.point.scene != scene) continue;
        const double y = what == ChartOf::ShadowError  ? shadowErrorOf(row)
                         : what == ChartOf::ImageError ? row.error.rmse
                                                       : wrongPpmOf(row);
        if (std::isnan(y)) continue;
        const std::string name = curveName(rows, row.point);
        if (chart.series.empty() || chart.series.back().name != name) chart.series.push_back({name, {}});
        chart.series.back().points.push_back({stepOf(row, "total").median, y, sampleCountLabel(row)});
    }
    if (what != ChartOf::Disagreement) chart.slopes = {{-0.5, "slope -1/2"}, {-1.0, "slope -1"}};
    chart.drawParetoFront = true;
    return chart;
}

Chart variedChart(const std::vector<SweepRow>& rows, const std::string& scene, VariedChartOf what,
                  bool softwareRenderer) {
    Chart chart;
    const SweepRow* varied = variedRow(rows, scene);
    if (varied == nullptr) return chart;
    const std::string key = varied->point.varied;
    std::set<int> sampleCounts;
    for (const SweepRow& row : rows)
        if (row.point.scene == scene) sampleCounts.insert(row.point.sampleCount);
    const std::string samples =
        sampleCounts.size() == 1 ? fmt::format(", {} samples per pixel", *sampleCounts.begin()) : "";
    const char* noun = what == VariedChartOf::Time     ? "time"
                       : what == VariedChartOf::Memory ? "memory"
                                                       : "wrong shadow samples";
    chart.title = fmt::format("{}: {} against {}", scene, noun, key);
    chart.subtitle = what == VariedChartOf::Time ? "shadow structure and shadow test, medians" + samples
                     : what == VariedChartOf::Memory
                         ? "GPU memory of the technique itself" + samples
                         : "camera samples whose lit value differs from the oracle's" + samples;
    chart.xLabel = key;
    chart.yLabel = what == VariedChartOf::Time
                       ? (softwareRenderer ? "milliseconds (software renderer, wall time)" : "milliseconds (GPU)")
                   : what == VariedChartOf::Memory ? "MiB"
                                                   : "wrong shadow samples (ppm)";
    for (const SweepRow& row : rowsOfCharts(rows)) {
        if (row.point.scene != scene) continue;
        if (what == VariedChartOf::Memory && row.point.technique == "embree") continue;  // it holds none on the device
        const std::string name = curveName(rows, row.point) +
                                 (sampleCounts.size() > 1 ? fmt::format(", {} spp", row.point.sampleCount) : "");
        auto series = std::find_if(chart.series.begin(), chart.series.end(),
                                   [&](const ChartSeries& s) { return s.name == name; });
        if (series == chart.series.end()) series = chart.series.insert(series, {name, {}});
        const double y = what == VariedChartOf::Time     ? stepOf(row, "build").median + stepOf(row, "lookup").median
                         : what == VariedChartOf::Memory ? static_cast<double>(row.techniqueBytes) / 1048576.0
                                                         : wrongPpmOf(row);
        series->points.push_back({row.point.variedValue, y, ""});
    }
    return chart;
}

}  // namespace timeshade
