#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "support/procedural_scene.h"

namespace timeshade {

/// A scene whose lit share is known exactly. Set-up "C" unless a case says otherwise: a spot light at (0, 0, 10) that
/// looks down, a receiver at z = 0, and a quad of width 1 at z = 5 whose centre x follows c(u). The segment from a receiver at x to
/// the light meets z = 5 half-way, at (light.x + x) / 2.
struct ClosedFormCase {
    std::string name;
    double exact = 0.0;  ///< lit share of the shutter at the receiver

    /// How much of the shutter one map texel at the caster's depth takes to pass, times the number of times that a shadow
    /// begins or ends: how far the map's resolution alone may put the answer off. Per texel of a 1024 map.
    double texelShare = 0.0;
    int ends = 0;  ///< how often the shadow begins or ends inside the shutter

    /// Answers of techniques that must fail here, by technique: what theory says they give instead of `exact`.
    std::map<std::string, double> predictedFailures;
    /// Techniques whose answer is not determined (an edge exactly at the one instant that they look at).
    std::vector<std::string> undetermined;

    std::shared_ptr<ProceduralScene> scene;
};

/// Rows 1 to 5, 9, 26, 29, 32 and 34 of the catalogue of hard cases.
const std::vector<ClosedFormCase>& closedFormCases();
const ClosedFormCase& closedFormCase(const std::string& name);

/// Case 1 with the quad's start moved by `shift` in x: the same lit share as long as |shift| <= 0.7.
std::shared_ptr<ProceduralScene> sweptPointScene(double shift);

} // namespace timeshade
