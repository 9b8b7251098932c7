#include "effects.h"

#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/folder_lock.h"
#include "frame_setup.h"
#include "headless_gl.h"
#include "image/image_file.h"
#include "measure/effects.h"
#include "output_path.h"
#include "progress.h"
#include "report.h"
#include "scene_catalogue.h"

namespace timeshade {

namespace {

nlohmann::ordered_json toJson(const EffectRow& row) {
    return {{"effect", row.effect},
            {"technique", row.technique},
            {"moving_casters", row.dynamicCasters},
            {"moving_seen", row.movingSeen},
            {"milliseconds", row.milliseconds},
            {"figures", row.statistics},
            {"bytes", row.bytes},
            {"of_unplanned", row.forcedShare},
            {"passes", row.passes}};
}

}  // namespace

int runEffects(const MeasureOptions& options) {
    const std::filesystem::path folder = madeFolder(options.output);
    const FolderLock lock(folder);
    const std::vector<std::string> names = options.measuredScenes.empty() ? showcase() : options.measuredScenes;
    const HeadlessGl opengl(options);
    EffectOptions effects;
    effects.technique = options.measuredTechniques.empty() ? options.technique : options.measuredTechniques.front();
    if (options.measuredTechniques.size() > 1)
        effects.compared.assign(options.measuredTechniques.begin() + 1, options.measuredTechniques.end());
    effects.frames = options.rounds + 2;
    std::string report;
    nlohmann::ordered_json json;
    for (const std::string& name : names) {
        requireStrata(options, "--effects");
        requireOneMotionStep(options, "--effects");
        const std::unique_ptr<Scene> scene = openScene(name, choiceOf(options), options.settings);
        const FrameRequest request = requestFor(options, *scene);
        std::optional<Progress> progress;
        effects.progress = [&](int done, int total) {
            if (!progress) progress.emplace(total);
            progress->update(done);
        };
        const std::vector<EffectRow> rows = measureEffects(*scene, request, effects);
        report += fmt::format("## {}, frame {:g}, shutter {:g}{}\n\n{}\n", name, request.frame, request.shutter.length,
                              responseInTitle(request.shutter), effectsTable(rows));
        for (const EffectRow& row : rows) json[name].push_back(toJson(row));
    }
    opengl.requireSilence();
    const std::string head = fmt::format(
        "# What each effect costs\n\n{}. {} x {}, {} samples per pixel, shadow map {}. Medians over {} steady frames "
        "in "
        "a row, in ms; programs are compiled before.\n\n",
        deviceLine(gl::currentDevice()), options.width, options.height, options.samplesPerPixel, options.mapSize.text(),
        options.rounds);
    writeFileAtomically(folder / "effects.md", head + report);
    writeFileAtomically(folder / "effects.json", json.dump(2) + "\n");
    fmt::print("{}{}\n", report, fullPath(folder / "effects.md"));
    return 0;
}

}  // namespace timeshade
