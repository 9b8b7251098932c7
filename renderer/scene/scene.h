#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/camera.h"
#include "scene/light.h"
#include "scene/material.h"
#include "scene/motion_mesh.h"

namespace timeshade {

/// Axis-aligned, world space. Empty while low > high.
struct Bounds {
    glm::dvec3 low{1e300};
    glm::dvec3 high{-1e300};
    void add(const glm::dvec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    void add(const Bounds& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    bool empty() const { return !(low.x <= high.x && low.y <= high.y && low.z <= high.z); }
    glm::dvec3 centre() const { return 0.5 * (low + high); }
    double diagonal() const { return empty() ? 0.0 : glm::length(high - low); }
};

/// What a scene suggests for a first look, from the glTF scene's `extras.timeshade`. A file without them, and
/// without any motion, gets these values.
struct SceneDefaults {
    double frame = 0.0;
    double framesPerSecond = 24.0;
    double shutterLength = 0.5;  ///< frames
};

/// One of the numbers that a computed scene was made from.
struct SceneParameter {
    std::string key;
    double value = 0.0;
};

/// A scene that moves: whatever can be asked for at an instant. Time is in seconds of the chosen clip and may
/// be any finite number. Immutable once made; safe to read from several threads.
class Scene {
  public:
    virtual ~Scene() = default;

    virtual const std::string& name() const = 0;
    /// Seconds after which the motion repeats; 0 where nothing moves.
    virtual double duration() const = 0;
    virtual const SceneDefaults& defaults() const = 0;
    virtual const std::vector<Material>& materials() const = 0;  ///< never empty
    virtual const std::vector<Image>& images() const = 0;
    virtual const std::vector<CameraBookmark>& cameras() const = 0;  ///< never empty; the first is the default
    virtual CameraPose camera(std::size_t index, double seconds) const = 0;
    /// A light with an animated direction is sampled where the caller asks; the plan asks for the middle.
    virtual LightPose light(double seconds) const = 0;
    /// Positions at both ends of the shutter. openSeconds <= closeSeconds. A clip that loops seamlessly goes on
    /// through its end; one that does not is held at its end, so that no triangle jumps inside a shutter.
    virtual MotionMesh motionMesh(double openSeconds, double closeSeconds) const = 0;
    /// The instant at which everything else (cameras, the light) stands still with the mesh when the shutter closes:
    /// closeSeconds, or, where motionMesh holds the clip at its end, the last instant before that end.
    virtual double heldCloseSeconds(double openSeconds, double closeSeconds) const {
        static_cast<void>(openSeconds);
        return closeSeconds;
    }
    /// Bounds over the whole clip (sampled), never empty; what cameras, lights and origins are fitted to.
    virtual const Bounds& bounds() const = 0;
    /// Names of the clips of the file, no two alike, and the place among them of the one that plays. Empty where there
    /// are none.
    virtual const std::vector<std::string>& clips() const {
        static const std::vector<std::string> none;
        return none;
    }
    virtual std::size_t clip() const { return 0; }
    /// Notes for the user, one line each: things of the file that are left out or replaced.
    virtual const std::vector<std::string>& notes() const = 0;
    /// What it was made from, for reports; empty for a file, which says all by itself.
    virtual const std::vector<SceneParameter>& parameters() const {
        static const std::vector<SceneParameter> none;
        return none;
    }
};

}  // namespace timeshade
