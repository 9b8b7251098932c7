#include "measure/equal_report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "measure/caption_columns.h"
#include "measure/map_size_json.h"
#include "measure/scene_file_name.h"

namespace timeshade {

namespace {

using Json = nlohmann::ordered_json;

std::string nameOf(EqualLevel level) { return level == EqualLevel::Time ? "time" : "error"; }

std::string amount(EqualLevel level, double value) {
    return level == EqualLevel::Time ? fmt::format("{:.1f} ms", value) : fmt::format("{:.5f}", value);
}

std::string samplesOf(const EqualRow& row, int sampleCount) {
    return fmt::format("{} {}", sampleCount, !row.bruteForce ? "spp" : sampleCount == 1 ? "render" : "renders");
}

/// "2.0 % more", "0.3 % less".
std::string difference(double ratio) {
    return fmt::format("{:.1f} % {}", 100.0 * std::abs(ratio - 1.0), ratio < 1.0 ? "less" : "more");
}

/// What the first has, as measured in turn with the row.
double firstValue(const EqualRow& row, EqualLevel level, const EqualRow& first) {
    return level == EqualLevel::Time ? row.firstMilliseconds : first.shadowError.rms;
}

double valueOf(const EqualRow& row, EqualLevel level) {
    return level == EqualLevel::Time ? row.steady.median : row.shadowError.rms;
}

/// "SCENE-equal.png", numbered where two scenes are called alike.
std::vector<std::string> pictureNames(const std::vector<EqualScene>& scenes) {
    std::vector<std::string> names;
    for (const EqualScene& scene : scenes) {
        const std::string stem = sceneFileName(scene.name) + "-equal";
        std::string name = stem + ".png";
        for (int number = 2; std::find(names.begin(), names.end(), name) != names.end(); ++number)
            name = fmt::format("{}-{}.png", stem, number);
        names.push_back(name);
    }
    return names;
}

std::string ppmCell(const EqualRow& row) { return row.wrongPpm ? fmt::format("{:.0f} ppm", *row.wrongPpm) : "-"; }

std::string table(const EqualScene& scene, EqualLevel level) {
    std::string text =
        "| technique | samples | map | steady ms (low to high) | of the first's, in turn | shadow error: RMS | of the "
        "first's | wrong shadow samples | technique MiB | GPU MiB | |\n"
        "| --- | --: | --: | --: | --: | --: | --: | --: | --: | --: | --- |\n";
    const EqualRow& first = scene.rows.front();
    for (const EqualRow& row : scene.rows) {
        const bool isFirst = !row.find;
        text += fmt::format(
            "| {} | {} | {} | {:.1f} ({:.1f} to {:.1f}) | {} | {:.5f} ± {:.5f} | {} | {} | {:.1f} | {:.1f} | {} |\n",
            row.technique, samplesOf(row, row.sampleCount), row.mapSize.text(), row.steady.median, row.steady.low,
            row.steady.high,
            isFirst ? "1"
                    : fmt::format("{:.3f} of {:.1f}", row.steady.median / row.firstMilliseconds, row.firstMilliseconds),
            row.shadowError.rms, row.shadowError.standardError,
            isFirst ? "1" : fmt::format("{:.3f}", row.shadowError.rms / first.shadowError.rms), ppmCell(row),
            static_cast<double>(row.techniqueBytes) / 1048576.0, static_cast<double>(row.bytes) / 1048576.0,
            isFirst ? "the first" : verdictOf(row, level, first));
    }
    return text;
}

std::string preface(const SweepManifest& manifest, EqualLevel level) {
    std::string text = level == EqualLevel::Time ? "# Equal time\n\n" : "# Equal error\n\n";
    if (manifest.device.software)
        text +=
            "**Software renderer**: milliseconds are finished wall times on a processor and say nothing about a GPU.\n"
            "\n";
    text += fmt::format(
        "    {}\n\n{} [equal.json](equal.json) holds every setting, [equal.csv](equal.csv) every "
        "number.\n\n",
        manifest.commandLine, inOneLine(manifest));
    text += level == EqualLevel::Time
                ? "The first technique sets the time. For each other: the samples per pixel (brute force: renders) at "
                  "which its steady frames come nearest to that"
                : "The first technique sets the error. For each other: the fewest samples per pixel (brute force: "
                  "renders) at which its shadow error is at most that";
    text += fmt::format(
        ". *Equal* is within {:g} %. Times are medians of steady frames, those of a sequence that has been running, "
        "with all shaders compiled; each technique is timed in turn with the first, whose median in the same rounds "
        "stands beside its own. Shadow error is per pixel: the mean lit value of its samples against the oracle's mean "
        "over the whole shutter and the pixel's area; RMS with the reference's own noise removed, ± its standard "
        "error. Wrong shadow samples are camera samples whose lit value differs from the oracle's, for techniques "
        "whose values are single tests.\n\n",
        100.0 * equalTolerance);
    return text;
}

std::string report(const SweepManifest& manifest, EqualLevel level, const std::vector<EqualScene>& scenes,
                   const std::vector<std::string>& pictures) {
    std::string text = preface(manifest, level);
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        text += fmt::format("## {}\n\n{}\n", scenes[i].name, table(scenes[i], level));
        text += fmt::format(
            "![side by side]({})\n\nReference: {} rays per pixel. The detail is where the technique with the largest "
            "shadow error is most wrong.\n\n",
            pictures[i], scenes[i].referenceRays);
    }
    return text;
}

/// JSON has no infinity.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json trialAsJson(const std::optional<EqualTrial>& trial) {
    return trial ? Json{{"samples", trial->sampleCount}, {"ratio", number(trial->ratio)}} : Json(nullptr);
}

Json rowAsJson(const EqualRow& row, EqualLevel level, const EqualRow& first) {
    Json json;
    json["technique"] = row.technique;
    json[row.bruteForce ? "renders" : "spp"] = row.sampleCount;
    json["map"] = asJson(row.mapSize);
    json["milliseconds"] = {{"median", row.steady.median}, {"low", row.steady.low}, {"high", row.steady.high}};
    json["first_milliseconds"] = row.firstMilliseconds;
    json["shadow_error"] = {{"rms", row.shadowError.rms},
                            {"standard_error", row.shadowError.standardError},
                            {"mean", row.shadowError.mean},
                            {"p999", row.shadowError.p999}};
    json["ppm"] = row.wrongPpm ? Json(*row.wrongPpm) : Json(nullptr);
    json["bytes"] = {{"total", row.bytes}, {"technique", row.techniqueBytes}};
    if (!row.find) return json;
    json["found"] = row.find->found;
    json["equal"] = row.find->isEqual();
    json["ratio"] = number(row.find->chosen.ratio);
    json["fewer"] = trialAsJson(row.find->fewer);
    json["more"] = trialAsJson(row.find->more);
    json["verdict"] = verdictOf(row, level, first);
    return json;
}

Json asJson(const SweepManifest& manifest, EqualLevel level, const std::vector<EqualScene>& scenes,
            const std::vector<std::string>& pictures) {
    Json json;
    json["manifest"] = asJson(manifest);
    json["equal"] = nameOf(level);
    json["tolerance"] = equalTolerance;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        Json scene{{"scene", scenes[i].name}, {"picture", pictures[i]}, {"reference_rays", scenes[i].referenceRays}};
        for (const EqualRow& row : scenes[i].rows)
            scene["techniques"].push_back(rowAsJson(row, level, scenes[i].rows.front()));
        json["scenes"].push_back(std::move(scene));
    }
    return json;
}

/// A cell as RFC 4180 has it.
std::string quoted(const std::string& text) {
    std::string cell = "\"";
    for (const char c : text) cell += c == '"' ? "\"\"" : std::string(1, c);
    return cell + "\"";
}

/// What could not be reached names the neighbours that there are, with their values.
std::string couldNot(const EqualRow& row, EqualLevel level, double first) {
    const EqualFind& find = *row.find;
    const auto said = [&](const EqualTrial& trial) {
        return samplesOf(row, trial.sampleCount) + " " + amount(level, trial.ratio * first);
    };
    const std::string against = " against " + amount(level, first);
    if (level == EqualLevel::Error)
        return fmt::format("could not: {} come nearest with {}{}", samplesOf(row, row.sampleCount),
                           amount(level, row.shadowError.rms), against);
    if (find.fewer && find.more) return "could not: " + said(*find.fewer) + ", " + said(*find.more) + against;
    if (find.fewer) return "could not: " + said(find.chosen) + ", the most," + against;
    return "could not: " + said(find.chosen) + ", the fewest," + against;
}

}  // namespace

std::string verdictOf(const EqualRow& row, EqualLevel level, const EqualRow& first) {
    if (!row.find) return "";
    const EqualFind& find = *row.find;
    const double of = firstValue(row, level, first);
    if (!find.found) return couldNot(row, level, of);
    if (find.isEqual())
        return fmt::format("equal: {} against {} ({})", amount(level, valueOf(row, level)), amount(level, of),
                           difference(find.chosen.ratio));
    // An error that is less than the first's, and not within the tolerance.
    const std::string before = find.fewer ? fmt::format("; {} {}", samplesOf(row, find.fewer->sampleCount),
                                                        amount(level, find.fewer->ratio * of))
                                          : ", the fewest samples";
    return fmt::format("less: {} against {} ({}){}", amount(level, valueOf(row, level)), amount(level, of),
                       difference(find.chosen.ratio), before);
}

DisplayImage equalPicture(const EqualScene& scene, bool software) {
    std::vector<CaptionedPicture> columns;
    for (const EqualRow& row : scene.rows)
        columns.push_back({row.picture,
                           row.technique,
                           {fmt::format("{}, map {}", samplesOf(row, row.sampleCount), row.mapSize.text()),
                            fmt::format("{:.1f} ms{}", row.steady.median, software ? " (software renderer)" : ""),
                            fmt::format("shadow error {:.4f}", row.shadowError.rms)}});
    columns.push_back({scene.reference, "Reference", {"ray traced"}});
    const auto worst = std::max_element(scene.rows.begin(), scene.rows.end(), [](const EqualRow& a, const EqualRow& b) {
        return a.shadowError.rms < b.shadowError.rms;
    });
    const int side = std::max(1, scene.reference.width / 4);
    return captionColumns(columns, worstSquare(worst->picture, scene.reference, side));
}

std::string equalCsv(const std::vector<EqualScene>& scenes, EqualLevel level) {
    std::string text =
        "scene,technique,spp,renders,map,steady_ms,steady_ms_low,steady_ms_high,first_ms,shadow_error_rms,"
        "shadow_error_standard_error,reference_rays,ppm,bytes,technique_bytes,equal,ratio,found,verdict\n";
    for (const EqualScene& scene : scenes)
        for (const EqualRow& row : scene.rows) {
            const std::string samples = std::to_string(row.sampleCount);
            text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},", quoted(scene.name),
                                quoted(row.technique), row.bruteForce ? "" : samples, row.bruteForce ? samples : "",
                                row.mapSize.text(), row.steady.median, row.steady.low, row.steady.high,
                                row.firstMilliseconds, row.shadowError.rms, row.shadowError.standardError,
                                scene.referenceRays, row.wrongPpm ? fmt::format("{}", *row.wrongPpm) : "", row.bytes,
                                row.techniqueBytes, nameOf(level));
            text += row.find ? fmt::format("{},{},{}\n", row.find->chosen.ratio, row.find->found ? "yes" : "no",
                                           quoted(verdictOf(row, level, scene.rows.front())))
                             : ",,\n";
        }
    return text;
}

void writeEqualReport(const std::filesystem::path& folder, const SweepManifest& manifest, EqualLevel level,
                      const std::vector<EqualScene>& scenes) {
    const std::vector<std::string> pictures = pictureNames(scenes);
    for (std::size_t i = 0; i < scenes.size(); ++i)
        writePng(folder / pictures[i], equalPicture(scenes[i], manifest.device.software));
    writeFileAtomically(folder / "equal.json", asJson(manifest, level, scenes, pictures).dump(2) + "\n");
    writeFileAtomically(folder / "equal.csv", equalCsv(scenes, level));
    writeFileAtomically(folder / "report.md", report(manifest, level, scenes, pictures));
}

}  // namespace timeshade
