#include "techniques/registry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"
#include "core/nearest_word.h"
#include "technique/technique_entry.h"

namespace timeshade {

#define TECHNIQUE(name) TechniqueEntry name##Technique();
#include "techniques/registry.def"
#undef TECHNIQUE

namespace {

const std::vector<TechniqueEntry>& registry() {
    static const std::vector<TechniqueEntry> entries{
#define TECHNIQUE(name) name##Technique(),
#include "techniques/registry.def"
#undef TECHNIQUE
    };
    return entries;
}

const TechniqueEntry& entryNamed(const std::string& name) {
    std::vector<std::string> known;
    for (const TechniqueEntry& entry : registry()) {
        if (entry.describe().name == name) return entry;
        known.push_back(entry.describe().name);
    }
    throw UsageError(fmt::format("technique '{}': no such technique{}; expected one of {}", name,
                                 didYouMean(name, known), fmt::join(known, ", ")));
}

}  // namespace

const std::vector<TechniqueDescription>& techniqueDescriptions() {
    static const std::vector<TechniqueDescription> descriptions = [] {
        std::vector<TechniqueDescription> all;
        for (const TechniqueEntry& entry : registry()) all.push_back(entry.describe());
        return all;
    }();
    return descriptions;
}

const TechniqueDescription& techniqueDescription(const std::string& name) { return entryNamed(name).describe(); }

std::unique_ptr<Technique> makeTechnique(const std::string& name, gl::ProgramCache& programs) {
    return entryNamed(name).make(programs);
}

}  // namespace timeshade
