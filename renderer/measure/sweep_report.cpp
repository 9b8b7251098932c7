#include "measure/sweep_report.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "measure/sweep_journal.h"

namespace timeshade {

namespace {

const std::vector<std::string> steps{"sample", "build", "lookup", "shade", "total"};

Timing stepOf(const SweepRow& row, const std::string& name) {
    const auto found = row.steps.find(name);
    return found == row.steps.end() ? Timing{} : found->second;
}

std::vector<std::string> scenesOf(const std::vector<SweepRow>& rows) {
    std::vector<std::string> scenes;
    for (const SweepRow& row : rows)
        if (std::find(scenes.begin(), scenes.end(), row.point.scene) == scenes.end()) scenes.push_back(row.point.scene);
    return scenes;
}

/// "tsm" of "tsm:bias=2".
std::string baseOf(const std::string& technique) { return technique.substr(0, technique.find(':')); }

const SweepRow* variedRow(const std::vector<SweepRow>& rows, const std::string& scene) {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const SweepRow& row) {
        return row.point.scene == scene && !row.point.varied.empty();
    });
    return found == rows.end() ? nullptr : &*found;
}

/// Names of the parts of steps ("build/collect") in any of the rows; of one scene, or of all where it is empty.
std::vector<std::string> partsOf(const std::vector<SweepRow>& rows, const std::string& scene) {
    std::set<std::string> parts;
    for (const SweepRow& row : rows)
        for (const auto& [name, timing] : row.steps)
            if (name.find('/') != std::string::npos && (scene.empty() || row.point.scene == scene)) parts.insert(name);
    return {parts.begin(), parts.end()};
}

/// "tsm", or "tsm, map 256" where a scene was measured with several maps.
std::string curveName(const std::vector<SweepRow>& rows, const SweepPoint& point) {
    std::set<int> maps;
    for (const SweepRow& row : rows)
        if (row.point.technique == point.technique) maps.insert(row.point.mapSize);
    return maps.size() > 1 ? fmt::format("{}, map {}", point.technique, point.mapSize) : point.technique;
}

std::string sampleCountLabel(const SweepPoint& point) {
    return baseOf(point.technique) == "accumulation" ? fmt::format("{}x", bruteForceRenders(point.sampleCount))
                                                     : fmt::format("{}", point.sampleCount);
}

std::string fileName(const std::string& scene) {
    std::string name = std::filesystem::path(scene).stem().string();
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_') c = '_';
    return name;
}

nlohmann::ordered_json asJson(const SweepManifest& m) {
    return {{"command", m.commandLine},
            {"timeshade", TIMESHADE_VERSION},
            {"commit", m.commit},
            {"processor", m.processor},
            {"gl",
             {{"back_end", m.backEnd},
              {"vendor", m.device.vendor},
              {"renderer", m.device.renderer},
              {"version", m.device.version},
              {"software", m.device.software}}},
            {"clock", m.device.software ? "wall time around glFinish (software renderer: says nothing about a GPU)"
                                        : "GL_TIMESTAMP on the device"},
            {"settings", m.settings},
            {"plans", m.plans}};
}

/// Where the error of a technique stops falling: the bias at its greatest effort, and whether it is above the noise.
std::string floorLine(const std::vector<SweepRow>& rows, const std::string& scene, const std::string& technique) {
    std::vector<double> sampleCounts, errors;
    const SweepRow* last = nullptr;
    for (const SweepRow& row : rows) {
        if (row.point.scene != scene || row.point.technique != technique) continue;
        if (last && row.point.mapSize != last->point.mapSize) break;
        sampleCounts.push_back(row.point.sampleCount);
        errors.push_back(row.biasAndNoise.noise);
        last = &row;
    }
    if (!last || sampleCounts.size() < 2) return "";
    const std::optional<double> slope = logLogSlope(sampleCounts, errors);
    return fmt::format(
        "- `{}`: noise falls with slope {} in samples (samples stratified in time and spread over the pixel: -2/3; "
        "time alone: -1; neither: -1/2); at the last point bias {:.5f}, noise {:.5f}: {}.\n",
        technique, slope ? fmt::format("{:.2f}", *slope) : "n/a", last->biasAndNoise.bias, last->biasAndNoise.noise,
        last->biasAndNoise.bias > last->biasAndNoise.noise ? "more samples no longer help, this is its floor"
                                                           : "more samples still help");
}

std::string reportTable(const std::vector<SweepRow>& rows, const std::string& scene) {
    const SweepRow* varied = variedRow(rows, scene);
    const std::vector<std::string> parts = partsOf(rows, scene);
    std::string head = "| technique |", rule = "| --- |";
    const auto column = [&](const std::string& name) {
        head += " " + name + " |";
        rule += " --: |";
    };
    if (varied != nullptr) column(varied->point.varied);
    for (const char* name : {"spp", "map", "sample", "build", "lookup", "shade"}) column(name);
    for (const std::string& part : parts) column(part);
    for (const char* name :
         {"total ms (low to high)", "RMSE", "bias", "noise", "off by > 30/255", "disagree", "technique MiB", "GPU MiB"})
        column(name);
    std::string text = head + "\n" + rule + "\n";
    for (const SweepRow& row : rows) {
        if (row.point.scene != scene) continue;
        const Timing total = stepOf(row, "total");
        text += fmt::format("| {} |", row.point.technique);
        if (varied != nullptr) text += fmt::format(" {:g} |", row.point.variedValue);
        text += fmt::format(" {} | {} | {:.1f} | {:.1f} | {:.1f} | {:.1f} |", sampleCountLabel(row.point),
                            row.point.technique == "embree" ? "-" : fmt::format("{}", row.point.mapSize),
                            stepOf(row, "sample").median, stepOf(row, "build").median, stepOf(row, "lookup").median,
                            stepOf(row, "shade").median);
        for (const std::string& part : parts)
            text += row.steps.count(part) > 0 ? fmt::format(" {:.1f} |", stepOf(row, part).median) : " |";
        text += fmt::format(
            " {:.1f} ({:.1f} to {:.1f}) | {:.5f} | {:.5f} | {:.5f} | {:.2f} % | {:.0f} ppm | {:.1f} | {:.1f} |\n",
            total.median, total.low, total.high, row.error.rmse, row.biasAndNoise.bias, row.biasAndNoise.noise,
            100.0 * row.error.offBy30.value_or(0.0), row.verification.ppm(),
            static_cast<double>(row.techniqueBytes) / 1048576.0, static_cast<double>(row.bytes) / 1048576.0);
    }
    return text;
}

/// What the techniques counted, a line for each row that counted anything.
std::string statisticLines(const std::vector<SweepRow>& rows, const std::string& scene) {
    std::string text;
    for (const SweepRow& row : rows) {
        if (row.point.scene != scene || row.statistics.empty()) continue;
        text += fmt::format("- `{}`:", row.point.key());
        for (const TechniqueStatistic& figure : row.statistics)
            text += fmt::format("{} {} {:.10g}{}{}", &figure == &row.statistics.front() ? "" : ",", figure.name,
                                figure.value, figure.unit.empty() ? "" : " " + figure.unit,
                                figure.warning.empty() ? "" : " (" + figure.warning + ")");
        text += "\n";
    }
    return text.empty() ? "" : "Counted:\n\n" + text + "\n";
}

std::string report(const SweepManifest& manifest, const std::vector<SweepRow>& rows) {
    std::string text = "# Accuracy against time\n\n";
    if (manifest.device.software)
        text +=
            "**Software renderer**: milliseconds are finished wall times on a processor and say nothing about a GPU. "
            "Ratios between "
            "rows, which were measured in turn, are what to read.\n\n";
    text += fmt::format(
        "    {}\n\n{} through {}; {}; commit {}. Errors are those of the displayed frame in linear light against a "
        "ray-traced "
        "reference; \"disagree\" counts camera samples whose lit differs from the oracle's. "
        "[manifest.json](manifest.json) holds every setting, "
        "[accuracy.csv](accuracy.csv) every figure.\n\n",
        manifest.commandLine, manifest.device.renderer, manifest.backEnd, manifest.processor, manifest.commit);
    for (const std::string& scene : scenesOf(rows)) {
        const std::string name = fileName(scene);
        const SweepRow* varied = variedRow(rows, scene);
        if (varied != nullptr)
            text += fmt::format(
                "## {0} against {1}\n\n![time against {1}]({2}-time.png)\n\n![memory against {1}]({2}-memory.png)\n\n"
                "![disagreement against {1}]({2}-disagreement.png)\n\n",
                scene, varied->point.varied, name);
        else
            text += fmt::format(
                "## {}\n\n![error against milliseconds]({}-error.png)\n\n![disagreement against "
                "milliseconds]({}-disagreement.png)\n\n",
                scene, name, name);
        text += reportTable(rows, scene) + "\n" + statisticLines(rows, scene);
        if (varied != nullptr) continue;
        std::set<std::string> seen;
        for (const SweepRow& row : rows)
            if (row.point.scene == scene && seen.insert(row.point.technique).second)
                text += floorLine(rows, scene, row.point.technique);
        text += "\n";
    }
    text +=
        "`accumulation` counts renders (8x is 8 renders of one sample per pixel each). `embree` traces the same camera "
        "samples: `sample` are "
        "its primary rays, `build` its acceleration structure, `lookup` its shadow rays, on all threads.\n";
    return text;
}

}  // namespace

Chart sweepChart(const std::vector<SweepRow>& rows, const std::string& scene, ChartOf what, bool softwareRenderer) {
    Chart chart;
    chart.title = what == ChartOf::Error ? fmt::format("{}: what accuracy costs", scene)
                                         : fmt::format("{}: wrong shadow answers against time", scene);
    chart.subtitle = what == ChartOf::Error ? "one curve per technique, samples per pixel (or renders, x) at the points"
                                            : "camera samples whose lit differs from the ray-traced truth";
    chart.xLabel =
        softwareRenderer ? "milliseconds a frame (software renderer, wall time)" : "milliseconds a frame (GPU)";
    chart.yLabel = what == ChartOf::Error ? "RMSE against the reference" : "disagreement (ppm)";
    for (const SweepRow& row : rows) {
        if (row.point.scene != scene) continue;
        const std::string name = curveName(rows, row.point);
        if (chart.series.empty() || chart.series.back().name != name) chart.series.push_back({name, {}});
        const double y = what == ChartOf::Error ? row.error.rmse : row.verification.ppm();
        chart.series.back().points.push_back({stepOf(row, "total").median, y, sampleCountLabel(row.point)});
    }
    if (what == ChartOf::Error) chart.slopes = {{-0.5, "slope -1/2"}, {-1.0, "slope -1"}};
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
                                                       : "wrong shadow answers";
    chart.title = fmt::format("{}: {} against {}", scene, noun, key);
    chart.subtitle = what == VariedChartOf::Time ? "building and lookup of the technique, medians" + samples
                     : what == VariedChartOf::Memory
                         ? "what the technique itself holds" + samples
                         : "camera samples whose lit differs from the ray-traced truth" + samples;
    chart.xLabel = key;
    chart.yLabel = what == VariedChartOf::Time
                       ? (softwareRenderer ? "milliseconds (software renderer, wall time)" : "milliseconds (GPU)")
                   : what == VariedChartOf::Memory ? "MiB"
                                                   : "disagreement (ppm)";
    for (const SweepRow& row : rows) {
        if (row.point.scene != scene) continue;
        if (what == VariedChartOf::Memory && row.point.technique == "embree") continue;  // it holds none on the device
        const std::string name = curveName(rows, row.point) +
                                 (sampleCounts.size() > 1 ? fmt::format(", {} spp", row.point.sampleCount) : "");
        auto series = std::find_if(chart.series.begin(), chart.series.end(),
                                   [&](const ChartSeries& s) { return s.name == name; });
        if (series == chart.series.end()) series = chart.series.insert(series, {name, {}});
        const double y = what == VariedChartOf::Time     ? stepOf(row, "build").median + stepOf(row, "lookup").median
                         : what == VariedChartOf::Memory ? static_cast<double>(row.techniqueBytes) / 1048576.0
                                                         : row.verification.ppm();
        series->points.push_back({row.point.variedValue, y, ""});
    }
    return chart;
}

std::string sweepCsv(const std::vector<SweepRow>& rows) {
    std::string text = "scene,technique,spp,map";
    for (const std::string& step : steps) text += fmt::format(",{}_ms,{}_ms_low,{}_ms_high", step, step, step);
    text +=
        ",rmse,relative_mse,psnr,mean_absolute,p999,off_by_30,bias,noise,mean_error,samples,tested,shadowed,disagree,"
        "false_shadow,false_lit,marginal,ppm,"
        "primary_tested,primary_disagree,primary_marginal,bytes,technique_bytes,varied,value";
    const std::vector<std::string> parts = partsOf(rows, "");
    for (const std::string& part : parts) text += fmt::format(",{}_ms,{}_ms_low,{}_ms_high", part, part, part);
    text += "\n";
    for (const SweepRow& row : rows) {
        text +=
            fmt::format("{},{},{},{}", row.point.scene, row.point.technique, row.point.sampleCount, row.point.mapSize);
        for (const std::string& step : steps) {
            const Timing timing = stepOf(row, step);
            text += fmt::format(",{},{},{}", timing.median, timing.low, timing.high);
        }
        const ErrorMetrics& e = row.error;
        text += fmt::format(",{},{},{},{},{},{},{},{},{}", e.rmse, e.relativeMse, e.psnr, e.meanAbsolute, e.p999,
                            e.offBy30.value_or(0.0), row.biasAndNoise.bias, row.biasAndNoise.noise,
                            row.biasAndNoise.meanError);
        const Verification& v = row.verification;
        text += fmt::format(",{},{},{},{},{},{},{},{},{},{},{},{},{}", v.samples, v.tested, v.shadowed, v.disagree(),
                            v.falseShadow, v.falseLit, v.marginal, v.ppm(), v.primaryTested, v.primaryDisagree,
                            v.primaryMarginal, row.bytes, row.techniqueBytes);
        text += row.point.varied.empty() ? ",," : fmt::format(",{},{}", row.point.varied, row.point.variedValue);
        for (const std::string& part : parts) {
            const Timing timing = stepOf(row, part);
            text +=
                row.steps.count(part) > 0 ? fmt::format(",{},{},{}", timing.median, timing.low, timing.high) : ",,,";
        }
        text += "\n";
    }
    return text;
}

void writeSweepReport(const std::filesystem::path& folder, const SweepManifest& manifest,
                      const std::vector<SweepRow>& rows) {
    const std::vector<std::string> scenes = scenesOf(rows);
    const bool software = manifest.device.software;
    for (const std::string& scene : scenes) {
        if (variedRow(rows, scene) != nullptr) {
            const auto draw = [&](VariedChartOf what) {
                return drawChart(variedChart(rows, scene, what, software), 1200, 800);
            };
            const DisplayImage time = draw(VariedChartOf::Time);
            writePng(folder / (fileName(scene) + "-time.png"), time);
            writePng(folder / (fileName(scene) + "-memory.png"), draw(VariedChartOf::Memory));
            writePng(folder / (fileName(scene) + "-disagreement.png"), draw(VariedChartOf::Disagreement));
            if (scene == scenes.front()) writePng(folder / "accuracy.png", time);
            continue;
        }
        const DisplayImage error = drawChart(sweepChart(rows, scene, ChartOf::Error, software), 1200, 800);
        writePng(folder / (fileName(scene) + "-error.png"), error);
        writePng(folder / (fileName(scene) + "-disagreement.png"),
                 drawChart(sweepChart(rows, scene, ChartOf::Disagreement, software), 1200, 800));
        if (scene == scenes.front()) writePng(folder / "accuracy.png", error);
    }
    nlohmann::ordered_json json;
    json["manifest"] = asJson(manifest);
    for (const SweepRow& row : rows) json["rows"].push_back(nlohmann::ordered_json::parse(rowAsJson(row)));
    writeFileAtomically(folder / "manifest.json", asJson(manifest).dump(2) + "\n");
    writeFileAtomically(folder / "accuracy.json", json.dump(2) + "\n");
    writeFileAtomically(folder / "accuracy.csv", sweepCsv(rows));
    writeFileAtomically(folder / "report.md", report(manifest, rows));
}

}  // namespace timeshade
