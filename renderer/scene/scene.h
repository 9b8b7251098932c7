#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/camera.h"
#include "scene/ground.h"
#include "scene/inner_motion.h"
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

/// The frame and shutter that a scene suggests, from the glTF scene's `extras.timeshade`. These values are used for a
/// file without them and without motion.
struct SceneDefaults {
    double frame = 0.0;
    double framesPerSecond = 24.0;
    double shutterLength = 0.5;  ///< frames
};

/// What something is at the opening (u = 0) and at the closing (u = 1) of a shutter.
template <typename Pose>
struct ShutterEnds {
    Pose open, close;
};

/// A parameter of a computed scene.
struct SceneParameter {
    std::string key;
    double value = 0.0;
};

/// A scene that moves, as functions of time. Time is in seconds of the chosen clip and may be any finite number.
/// Immutable; safe to read from several threads.
class Scene {
  public:
    virtual ~Scene() = default;

    virtual const std::string& name() const = 0;
    /// Seconds that the motion lasts, after which it repeats or is held (loops()); 0 if nothing moves.
    virtual double duration() const = 0;
    /// Whether the end of the motion joins its start, so that it repeats; otherwise it is held at both ends.
    virtual bool loops() const { return true; }
    virtual const SceneDefaults& defaults() const = 0;
    virtual const std::vector<Material>& materials() const = 0;  ///< never empty
    virtual const std::vector<Image>& images() const = 0;
    virtual const std::vector<CameraBookmark>& cameras() const = 0;  ///< never empty; the first is the default
    virtual CameraPose camera(std::size_t index, double seconds) const = 0;
    /// The light at an instant.
    virtual LightPose light(double seconds) const = 0;
    /// Positions at both ends of the shutter; openSeconds <= closeSeconds. What jumps inside the shutter (STEP keys) is
    /// at both ends where it is in the shutter's middle, so that no jump is smeared.
    virtual MotionMesh motionMesh(double openSeconds, double closeSeconds) const = 0;
    /// A camera and the light at both ends of the shutter; jumps as in motionMesh().
    virtual ShutterEnds<CameraPose> cameraEnds(std::size_t index, double openSeconds, double closeSeconds) const {
        return {camera(index, openSeconds), camera(index, closeSeconds)};
    }
    virtual ShutterEnds<LightPose> lightEnds(double openSeconds, double closeSeconds) const {
        return {light(openSeconds), light(closeSeconds)};
    }
    /// Where the things of motionMesh() really are inside the shutter. Empty for a scene that does not say.
    virtual InnerMotion innerMotion(double openSeconds, double closeSeconds) const {
        static_cast<void>(openSeconds), static_cast<void>(closeSeconds);
        return {};
    }
    /// World-space bounds over the whole clip (sampled), never empty. Fitted cameras, lights and origins use them.
    virtual const Bounds& bounds() const = 0;
    /// Unique names of the file's clips, and the index of the one that plays. Empty if there are none.
    virtual const std::vector<std::string>& clips() const {
        static const std::vector<std::string> none;
        return none;
    }
    virtual std::size_t clip() const { return 0; }
    /// Unique names of the file's lights, and the index of the one that is used; that of none where it is a fitted one.
    virtual const std::vector<std::string>& lights() const {
        static const std::vector<std::string> none;
        return none;
    }
    virtual std::size_t chosenLight() const { return 0; }
    /// The square of ground that was added to the file's things; it lies outside bounds().
    virtual const std::optional<GroundSquare>& ground() const {
        static const std::optional<GroundSquare> none;
        return none;
    }
    /// Notes for the user, one line each, about parts of the file that are left out or replaced.
    virtual const std::vector<std::string>& notes() const = 0;
    /// Parameters of a computed scene, for reports; empty for a file.
    virtual const std::vector<SceneParameter>& parameters() const {
        static const std::vector<SceneParameter> none;
        return none;
    }
    /// Names what the scene is made of: with one program, equal texts mean equal scenes but for the clip. Of a file: a
    /// SHA-256 over it and the files that it refers to. Of a computed scene: its name and parameters.
    virtual std::string contentDigest() const;
};

}  // namespace timeshade
