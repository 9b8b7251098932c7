#include "measure/sweep_report.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "measure/reference_noise.h"
#include "measure/scene_file_name.h"
#include "measure/sweep_charts.h"
#include "measure/sweep_journal.h"
#include "measure/sweep_rows.h"

namespace timeshade {

namespace {

/// Where the error of a technique stops falling: the bias at its most samples, and whether it is above the noise. The
/// rows are one for each point.
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

/// Shadow error, footprint error and wrong samples; "-" for what was not measured, or says nothing of the technique.
std::string shadowCells(const SweepRow& row) {
    const Verification& v = row.verification;
    std::string text = "- | - | -";
    if (v.shadowError) {
        const ErrorSummary& e = v.shadowError->error;
        text = fmt::format("{:.5f} ± {:.5f} | {:.5f} | {:.3f}", e.rms, e.standardError, e.mean, e.p999);
    }
    const ErrorSummary& own = v.footprintError.error;
    text += own.count > 0 ? fmt::format(" | {:.5f}", own.rms) : " | -";
    return text + (v.isBinary() ? fmt::format(" | {:.0f} ppm", v.ppm()) : " | -");
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
    for (const char* name : {"spp", "map", "state", "camera samples", "shadow structure", "shadow test", "shading"})
        column(name);
    for (const std::string& part : parts) column(part);
    for (const char* name :
         {"total ms (low to high)", "shadow error: RMS", "mean", "p99.9", "footprint error: RMS",
          "wrong shadow samples", "image RMSE", "bias", "noise", "off by > 30/255", "technique MiB", "GPU MiB"})
        column(name);
    std::string text = head + "\n" + rule + "\n";
    for (const SweepRow& row : rows) {
        if (row.point.scene != scene) continue;
        const Timing total = stepOf(row, "total");
        text += fmt::format("| {} |", row.point.technique);
        if (varied != nullptr) text += fmt::format(" {:g} |", row.point.variedValue);
        text += fmt::format(" {} | {} | {} | {:.1f} | {:.1f} | {:.1f} | {:.1f} |", sampleCountLabel(row),
                            row.point.technique == "embree" ? "-" : row.point.mapSize.text(), nameOf(row.state),
                            stepOf(row, "sample").median, stepOf(row, "build").median, stepOf(row, "lookup").median,
                            stepOf(row, "shade").median);
        for (const std::string& part : parts)
            text += row.steps.count(part) > 0 ? fmt::format(" {:.1f} |", stepOf(row, part).median) : " |";
        text += fmt::format(
            " {:.1f} ({:.1f} to {:.1f}) | {} | {:.5f}{} | {:.5f} | {:.5f} | {:.2f} % | {:.1f} | {:.1f} |\n",
            total.median, total.low, total.high, shadowCells(row), row.error.rmse,
            noiseDominates(row.error.rmse, row.referenceNoise) ? " \\*" : "", row.biasAndNoise.bias,
            row.biasAndNoise.noise, 100.0 * row.error.offBy30.value_or(0.0),
            static_cast<double>(row.techniqueBytes) / 1048576.0, static_cast<double>(row.bytes) / 1048576.0);
    }
    return text;
}

/// The techniques' statistics, a line for each point that has any.
std::string statisticLines(const std::vector<SweepRow>& rows, const std::string& scene) {
    std::string text;
    for (const SweepRow& row : rowsOfCharts(rows)) {
        if (row.point.scene != scene || row.statistics.empty()) continue;
        text += fmt::format("- `{}`:", row.point.key());
        for (const TechniqueStatistic& figure : row.statistics)
            text += fmt::format("{} {} {:.10g}{}{}", &figure == &row.statistics.front() ? "" : ",", figure.name,
                                figure.value, figure.unit.empty() ? "" : " " + figure.unit,
                                figure.warning.empty() ? "" : " (" + figure.warning + ")");
        text += "\n";
    }
    return text.empty() ? "" : "Statistics:\n\n" + text + "\n";
}

/// What the words of the tables mean.
std::string preface(const SweepManifest& manifest) {
    std::string text = "# Accuracy against time\n\n";
    if (manifest.device.software)
        text +=
            "**Software renderer**: milliseconds are finished wall times on a processor and say nothing about a GPU. "
            "Ratios between rows, which were measured in turn, are what to read.\n\n";
    text += fmt::format("    {}\n\n{} ", manifest.commandLine, inOneLine(manifest));
    text +=
        "[manifest.json](manifest.json) holds every setting, [accuracy.csv](accuracy.csv) every number.\n\n"
        "Times are medians with their lowest and highest. Programs are compiled before any frame is timed. A *cold* "
        "frame has nothing cached; the next one is *filling* the caches; a *steady* one belongs to a sequence that has "
        "been running. Charts show steady frames, and cold ones of what caches nothing. Errors do not depend on the "
        "state.\n\n"
        "Shadow error is per pixel: the mean lit value of its samples against the oracle's mean over the whole shutter "
        "and the pixel's area; RMS with the reference's own noise removed, ± its standard error. Footprint error is "
        "that "
        "of a technique's values against the oracle's mean over what each value stands for. Wrong shadow samples are "
        "camera samples whose lit value differs from the oracle's, for techniques whose values are single tests. Image "
        "RMSE is of the frame in linear light against a ray-traced reference; \\* marks where the noise of that "
        "reference is more than half of its square.\n\n";
    return text;
}

std::string sceneSection(const std::vector<SweepRow>& rows, const std::string& scene) {
    const std::string name = sceneFileName(scene);
    const SweepRow* varied = variedRow(rows, scene);
    if (varied != nullptr)
        return fmt::format(
                   "## {0} against {1}\n\n![time against {1}]({2}-time.png)\n\n![memory against {1}]({2}-memory.png)"
                   "\n\n![wrong shadow samples against {1}]({2}-disagreement.png)\n\n",
                   scene, varied->point.varied, name) +
               reportTable(rows, scene) + "\n" + statisticLines(rows, scene);
    std::string text = fmt::format(
        "## {0}\n\n![shadow error against milliseconds]({1}-error.png)\n\n![image error against milliseconds]("
        "{1}-image-error.png)\n\n![wrong shadow samples against "
        "milliseconds]({1}-disagreement.png)\n\n",
        scene, name);
    text += reportTable(rows, scene) + "\n" + statisticLines(rows, scene);
    std::set<std::string> seen;
    for (const SweepRow& row : rows)
        if (row.point.scene == scene && seen.insert(row.point.technique).second)
            text += floorLine(rowsOfCharts(rows), scene, row.point.technique);
    return text + "\n";
}

/// How to read rows of brute force and of the baseline, where there are any.
std::string footnotes(const std::vector<SweepRow>& rows) {
    std::set<std::string> bruteForce;
    bool baseline = false;
    for (const SweepRow& row : rows) {
        if (row.renders > 1) bruteForce.insert("`" + row.point.technique + "`");
        baseline = baseline || row.point.technique == "embree";
    }
    std::string text;
    if (!bruteForce.empty())
        text += fmt::format(
            "{}: the number is that of renders (8x is 8 renders of one sample per pixel each), times are those of all "
            "renders together.\n",
            fmt::join(bruteForce, ", "));
    if (baseline)
        text +=
            "`embree` traces the same camera samples on all threads: its camera samples are its primary rays, its "
            "shadow structure is its hierarchy, its shadow test its shadow rays. It keeps nothing, so every frame of "
            "it is cold.\n";
    return text;
}

/// Of the csv: empty cells for what was not measured.
std::string errorCells(const SweepRow& row) {
    const Verification& v = row.verification;
    std::string text = ",,,,";
    if (v.shadowError) {
        const ErrorSummary& e = v.shadowError->error;
        text = fmt::format(",{},{},{},{}", e.rms, e.standardError, e.mean, e.p999);
    }
    const ErrorSummary& own = v.footprintError.error;
    text += own.count > 0 ? fmt::format(",{},{}", own.rms, own.mean) : ",,";
    return text + fmt::format(",{},{}", v.shadowError ? v.shadowError->rays : 0, row.referenceNoise);
}

std::string report(const SweepManifest& manifest, const std::vector<SweepRow>& rows) {
    std::string text = preface(manifest);
    for (const std::string& scene : scenesOf(rows)) text += sceneSection(rows, scene);
    return text + footnotes(rows);
}

}  // namespace

std::string sweepCsv(const std::vector<SweepRow>& rows) {
    std::string text = "scene,technique,spp,map,state,renders";
    for (const std::string& step : frameSteps) text += fmt::format(",{}_ms,{}_ms_low,{}_ms_high", step, step, step);
    text +=
        ",rmse,relative_mse,psnr,mean_absolute,p999,off_by_30,bias,noise,mean_error,samples,tested,shadowed,disagree,"
        "false_shadow,false_lit,marginal,ppm,"
        "primary_tested,primary_disagree,primary_marginal,bytes,technique_bytes,varied,value,shadow_error_rms,"
        "shadow_error_standard_error,shadow_error_mean,shadow_error_p999,footprint_error_rms,footprint_error_mean,"
        "reference_rays,reference_noise";
    const std::vector<std::string> parts = partsOf(rows, "");
    for (const std::string& part : parts) text += fmt::format(",{}_ms,{}_ms_low,{}_ms_high", part, part, part);
    text += "\n";
    for (const SweepRow& row : rows) {
        text += fmt::format("{},{},{},{},{},{}", row.point.scene, row.point.technique, row.point.sampleCount,
                            row.point.mapSize.text(), nameOf(row.state), row.renders);
        for (const std::string& step : frameSteps) {
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
        text += errorCells(row);
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
            writePng(folder / (sceneFileName(scene) + "-time.png"), time);
            writePng(folder / (sceneFileName(scene) + "-memory.png"), draw(VariedChartOf::Memory));
            writePng(folder / (sceneFileName(scene) + "-disagreement.png"), draw(VariedChartOf::Disagreement));
            if (scene == scenes.front()) writePng(folder / "accuracy.png", time);
            continue;
        }
        const auto draw = [&](ChartOf what) { return drawChart(sweepChart(rows, scene, what, software), 1200, 800); };
        const DisplayImage error = draw(haveShadowErrors(rows) ? ChartOf::ShadowError : ChartOf::ImageError);
        writePng(folder / (sceneFileName(scene) + "-error.png"), error);
        writePng(folder / (sceneFileName(scene) + "-image-error.png"), draw(ChartOf::ImageError));
        writePng(folder / (sceneFileName(scene) + "-disagreement.png"), draw(ChartOf::Disagreement));
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
