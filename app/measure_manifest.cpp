#include "measure_manifest.h"

#include <timeshade/commit.h>  // generated
#include <unistd.h>
#include <fstream>
#include <memory>
#include <sstream>

#include <fmt/format.h>

#include "measure/technique_variant.h"
#include "report.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

std::string processorName() {
    std::ifstream stream("/proc/cpuinfo");
    std::string line;
    while (std::getline(stream, line))
        if (line.rfind("model name", 0) == 0)
            return fmt::format("{}, {} threads", line.substr(line.find(':') + 2), sysconf(_SC_NPROCESSORS_ONLN));
    return "unknown";
}

std::vector<std::string> settingLines(const std::vector<std::string>& techniques, const MeasureOptions& options) {
    std::vector<std::string> lines;
    gl::ProgramCache programs;
    for (const std::string& name : techniques) {
        if (name == "embree") continue;
        const std::unique_ptr<Technique> technique =
            TechniqueVariant::onItsSamples(name).make(options.settings, programs);
        for (const Setting& setting : settingsOf(*technique))
            if (setting.key != "renders")
                lines.push_back(fmt::format("{}.{} = {:g}", name, setting.key, setting.get()));
    }
    return lines;
}

}  // namespace

SweepManifest manifestOf(const MeasureOptions& options, const std::vector<std::string>& techniques,
                         const HeadlessGl& opengl, const FrameRenderer& renderer) {
    SweepManifest manifest;
    manifest.commandLine = options.commandLine;
    manifest.commit = TIMESHADE_COMMIT;
    manifest.processor = processorName();
    manifest.backEnd = opengl.backEnd();
    manifest.device = renderer.device();
    manifest.settings = settingLines(techniques, options);
    return manifest;
}

std::vector<std::string> planLines(const SweepScene& scene, const std::string& technique, const gl::DeviceInfo& device,
                                   gl::ProgramCache& programs) {
    FramePlanner planner(*scene.scene);
    const std::string name = technique == "embree" ? techniqueDescriptions().front().name : technique;
    const TechniqueVariant series = TechniqueVariant::onItsSamples(name);
    const std::unique_ptr<Technique> planned = series.make({}, programs);
    std::istringstream text(explain(planner.plan(planned->asked(series.on(scene.request))), *planned, device));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
}

}  // namespace timeshade
