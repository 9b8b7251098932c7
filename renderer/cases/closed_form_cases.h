#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cases/procedural_scene.h"
#include "plan/frame_request.h"

namespace timeshade {

/// A hard case whose lit share is known exactly: a row of the catalogue of hard cases. Set-up "C" unless its motion
/// says otherwise: a spot light at (0, 0, 10) that looks down, a receiver at z = 0, and a quad of width 1 at z = 5
/// whose centre x follows c(u). The segment from a receiver at x to the light meets z = 5 half-way, at (light.x + x)
/// / 2.
struct ClosedFormCase {
    enum class Kind {
        Picture,   ///< has a scene; the share is that of the samples that see the receiver
        Numeric,   ///< a shared function evaluated at floats: no technique takes part
        Sequence,  ///< about what earlier frames leave behind: seen by techniques with a history only, and by their
                   ///< tests
    };
    int row = 0;         ///< number in the catalogue
    std::string name;    ///< as after "case:"
    std::string motion;  ///< what moves, and when the receiver is dark
    std::string breaks;  ///< what fails here, and how
    Kind kind = Kind::Picture;
    double exact = 0.0;  ///< lit share of the shutter at the receiver
    int ends = 0;        ///< how often the shadow begins or ends inside the shutter

    // Pictures only.
    std::shared_ptr<ProceduralScene> scene;
    std::uint32_t firstReceiver = 0;                   ///< triangles from this number on are the receiver
    glm::dvec3 receiverOpen{0.0}, receiverClose{0.0};  ///< the point that the picture's middle sees, at both ends
    double patchWidth = 0.0, patchHeight = 0.0;        ///< of the part of the receiver that is seen, world units
    int width = 4, height = 4;                         ///< of the picture that is measured, pixels
    double seenFrom = 0.0, seenTo = 1.0;               ///< part of the shutter in which the camera sees the receiver
    /// Casters thinner than a map texel, or there for less than any step of an integration: what maps and their
    /// resolution do can't be put down to the shadow's ends.
    bool fleeting = false;

    /// Numeric only: the shared function's answer, computed in floats.
    double (*evaluate)() = nullptr;

    /// The frame from which the share is measured.
    FrameRequest request(int samplesPerPixel, int mapSize, std::uint32_t seed) const;
};

/// All rows, in their order.
const std::vector<ClosedFormCase>& closedFormCases();
/// Throws UsageError that names the known ones.
const ClosedFormCase& closedFormCase(const std::string& name);

/// Case 28 with the quad `gap` above the receiver, 10 below the light: dark.
ClosedFormCase contactCase(double gap);

/// Case 1 with the quad's start moved by `shift` in x: the same lit share as long as |shift| <= 0.7.
std::shared_ptr<ProceduralScene> sweptPointScene(double shift);

}  // namespace timeshade
