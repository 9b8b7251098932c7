#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cases/procedural_scene.h"
#include "plan/frame_request.h"

namespace timeshade {

/// A case whose visibility, averaged over the shutter, is known in closed form. Set-up "C" unless its motion says
/// otherwise: a spot light at (0, 0, 10) that points down, a receiver at z = 0, and a quad of width 1 at z = 5 whose
/// centre has x = c(u). The segment from a receiver at x to the light crosses z = 5 half-way, at (light.x + x) / 2.
struct ClosedFormCase {
    enum class Kind {
        Picture,   ///< has a scene; visibility is averaged over the samples that see the receiver
        Numeric,   ///< evaluates a shared function in float; independent of techniques
        Sequence,  ///< about reuse of earlier frames; tested by techniques with a history only
    };
    int row = 0;         ///< number in the catalogue, from 1
    std::string name;    ///< as after "case:"
    std::string motion;  ///< what moves, and when the receiver is shadowed
    std::string breaks;  ///< which methods fail here, and their value
    Kind kind = Kind::Picture;
    double exact = 0.0;  ///< share of the shutter during which the receiver is lit
    int ends = 0;        ///< how many times a shadow begins or ends inside the shutter

    // Pictures only.
    std::shared_ptr<ProceduralScene> scene;
    std::uint32_t firstReceiver = 0;                   ///< the receiver's triangles are those from this id on
    glm::dvec3 receiverOpen{0.0}, receiverClose{0.0};  ///< point at the picture's centre, at both ends
    double patchWidth = 0.0, patchHeight = 0.0;        ///< size of the visible part of the receiver, world units
    int width = 4, height = 4;                         ///< of the measured picture, pixels
    double seenFrom = 0.0, seenTo = 1.0;               ///< part of the shutter in which the camera sees the receiver
    /// Casters are thinner than a map texel, or shadow the receiver for less than one step of numerical integration, so
    /// the effect of the map's resolution cannot be derived from `ends`.
    bool fleeting = false;

    /// Numeric only: the shared function's value, computed in float.
    double (*evaluate)() = nullptr;

    /// The frame that is measured.
    FrameRequest request(int samplesPerPixel, const MapSize& mapSize, std::uint32_t seed) const;
};

/// All rows, in ascending order.
const std::vector<ClosedFormCase>& closedFormCases();
/// Throws UsageError that lists the known names.
const ClosedFormCase& closedFormCase(std::string_view name);

/// Case 28 with the quad `gap` above the receiver and the light 10 above it: shadowed.
ClosedFormCase contactCase(double gap);

/// Case 1 with the quad's path shifted by `shift` in x: the same visibility as long as |shift| <= 0.7.
std::shared_ptr<ProceduralScene> sweptPointScene(double shift);

}  // namespace timeshade
