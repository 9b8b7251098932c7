#include "technique/technique_views.h"

#include <fmt/format.h>

#include "core/error.h"

namespace timeshade {

TechniqueView viewOf(const Technique& technique, const std::string& name) {
    std::string known;
    for (const TechniqueView& view : technique.views()) {
        if (view.name == name) return view;
        known += ", " + view.name;
    }
    const std::string own =
        known.empty() ? fmt::format(" ({} has none of its own)", technique.description().name) : known;
    throw UsageError(fmt::format(
        "--view {}: technique {} has no such view; expected one of final, visibility, error, disagreement{}", name,
        technique.description().name, own));
}

}  // namespace timeshade
