#include "techniques/registry.h"

#include <fmt/format.h>

#include "core/error.h"
#include "techniques/accumulation/accumulation_shadow.h"
#include "techniques/exact/exact_shadow.h"
#include "techniques/history/history_shadow.h"
#include "techniques/ranges/ranges_shadow.h"
#include "techniques/static/static_shadow.h"
#include "techniques/temporal/temporal_shadow.h"
#include "techniques/tsm/tsm_shadow.h"

namespace timeshade {

namespace {

struct Entry {
    const TechniqueDescription& (*describe)();
    std::unique_ptr<Technique> (*make)(gl::ProgramCache&);
};

template <typename T>
Entry entry() {
    return {&T::describe,
            [](gl::ProgramCache& programs) -> std::unique_ptr<Technique> { return std::make_unique<T>(programs); }};
}

const std::vector<Entry>& registry() {
    static const std::vector<Entry> entries{
        entry<StaticShadow>(),  entry<TsmShadow>(),    entry<AccumulationShadow>(), entry<ExactShadow>(),
        entry<HistoryShadow>(), entry<RangesShadow>(), entry<TemporalShadow>(),
    };
    return entries;
}

}  // namespace

const std::vector<TechniqueDescription>& techniqueDescriptions() {
    static const std::vector<TechniqueDescription> descriptions = [] {
        std::vector<TechniqueDescription> all;
        for (const Entry& entry : registry()) all.push_back(entry.describe());
        return all;
    }();
    return descriptions;
}

std::unique_ptr<Technique> makeTechnique(const std::string& name, gl::ProgramCache& programs) {
    std::string known;
    for (const Entry& entry : registry()) {
        if (entry.describe().name == name) return entry.make(programs);
        known += (known.empty() ? "" : ", ") + entry.describe().name;
    }
    throw UsageError(fmt::format("technique '{}': no such technique; expected one of {}", name, known));
}

}  // namespace timeshade
