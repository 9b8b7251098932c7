#include "technique/technique.h"

#include <fmt/format.h>

#include "core/error.h"

namespace timeshade {

void Technique::drawLookup(const TechniqueFrame&) {
    throw Error(fmt::format("technique {} has no lookup of its own", description().name));
}

void Technique::drawView(const TechniqueFrame&, const std::string& name, const gl::Texture&) {
    throw Error(fmt::format("technique {} has no view '{}'", description().name, name));
}

TechniqueStatement statementOf(const Technique& technique) {
    return {technique.footprint(), technique.samplingTraits(), technique.renders(), technique.prediction()};
}

}  // namespace timeshade
