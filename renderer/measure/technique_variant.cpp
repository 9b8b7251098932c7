#include "measure/technique_variant.h"

#include <sstream>

#include <fmt/format.h>

#include "core/error.h"
#include "techniques/registry.h"

namespace timeshade {

TechniqueVariant TechniqueVariant::of(const std::string& label) {
    std::istringstream parts(label);
    TechniqueVariant variant;
    std::getline(parts, variant.name, ':');
    for (std::string part; std::getline(parts, part, ':');) {
        const std::size_t equals = part.find('=');
        if (equals == std::string::npos || equals == 0)
            throw UsageError(fmt::format(
                "technique {}: '{}' given, expected KEY=VALUE after the colon, as in tsm:bias=2", label, part));
        variant.settings.emplace_back(part.substr(0, equals), part.substr(equals + 1));
    }
    return variant;
}

TechniqueVariant TechniqueVariant::onItsSamples(const std::string& label) {
    TechniqueVariant variant = of(label);
    std::erase_if(variant.settings, [&](const auto& setting) {
        if (setting.first != "samples") return false;
        if (setting.second == "strata")
            variant.samples = CameraSamples::Strata;
        else if (setting.second == "intervals")
            variant.samples = CameraSamples::Intervals;
        else
            throw UsageError(
                fmt::format("technique {}: samples={}, expected strata or intervals", label, setting.second));
        return true;
    });
    return variant;
}

FrameRequest TechniqueVariant::on(FrameRequest request) const {
    if (samples) request.samples = *samples;
    if (request.samples == CameraSamples::Intervals && request.motionSteps > 1)
        throw UsageError(fmt::format("technique {}: samples=intervals with {} motion steps, expected one", name,
                                     request.motionSteps));
    return request;
}

std::unique_ptr<Technique> TechniqueVariant::make(const std::vector<std::pair<std::string, std::string>>& settingsOfAll,
                                                  gl::ProgramCache& programs) const {
    std::unique_ptr<Technique> technique = makeTechnique(name, programs);
    const std::string prefix = name + ".";
    for (const auto& [key, value] : settingsOfAll)
        if (key.starts_with(prefix)) setFromText(*technique, key.substr(prefix.size()), value);
    for (const auto& [key, value] : settings) setFromText(*technique, key, value);
    return technique;
}

}  // namespace timeshade
