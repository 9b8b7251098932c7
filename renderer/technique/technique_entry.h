#pragma once

#include <memory>

#include "gl/program_cache.h"
#include "technique/technique.h"

namespace timeshade {

/// How the registry knows a technique. Each technique's folder defines one function that returns its entry, named after
/// the folder: `TechniqueEntry tsmTechnique()`.
struct TechniqueEntry {
    const TechniqueDescription& (*describe)() = nullptr;
    /// With its settings at their defaults. Touches no OpenGL.
    std::unique_ptr<Technique> (*make)(gl::ProgramCache& programs) = nullptr;
};

/// Of a class with a static describe() and a constructor that takes the programs.
template <typename T>
TechniqueEntry entryOf() {
    return {&T::describe,
            [](gl::ProgramCache& programs) -> std::unique_ptr<Technique> { return std::make_unique<T>(programs); }};
}

}  // namespace timeshade
