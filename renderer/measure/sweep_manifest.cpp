#include "measure/sweep_manifest.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace timeshade {

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

std::string inOneLine(const SweepManifest& manifest) {
    return fmt::format("{} through {}; {}; commit {}.", manifest.device.renderer, manifest.backEnd, manifest.processor,
                       manifest.commit);
}

}  // namespace timeshade
