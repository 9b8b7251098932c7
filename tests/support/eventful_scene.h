#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace timeshade {

/// Quads over a ground that start and stop, come in and go out of the camera's and the light's views, as do the light
/// and the camera themselves: each has a position at every whole frame, moves linearly in between, and pauses for some
/// frames. One second is one frame. The same seed makes the same scene.
class EventfulScene final : public Scene {
  public:
    static constexpr int frames = 8;
    EventfulScene(std::uint32_t seed, bool directionalLight);

    const std::string& name() const override { return name_; }
    double duration() const override { return frames; }
    const SceneDefaults& defaults() const override { return defaults_; }
    const std::vector<Material>& materials() const override { return materials_; }
    const std::vector<Image>& images() const override { return images_; }
    const std::vector<CameraBookmark>& cameras() const override { return cameras_; }
    CameraPose camera(std::size_t index, double seconds) const override;
    LightPose light(double seconds) const override;
    MotionMesh motionMesh(double openSeconds, double closeSeconds) const override;
    const Bounds& bounds() const override { return bounds_; }
    const std::vector<std::string>& notes() const override { return notes_; }

  private:
    using Path = std::vector<glm::dvec3>;  ///< a position for each whole frame from 0 to `frames`
    struct Quad {
        Path centres;
        Path sides;  ///< half of one side; the other stays
        glm::dvec3 up;
    };
    static glm::dvec3 at(const Path& path, double seconds);
    std::vector<glm::dvec3> corners(double seconds) const;

    std::string name_ = "eventful";
    SceneDefaults defaults_{0.0, 1.0, 1.0};
    std::vector<Material> materials_{Material{}};
    std::vector<Image> images_;
    std::vector<CameraBookmark> cameras_{{"only"}};
    std::vector<std::string> notes_;
    Bounds bounds_;
    std::vector<Quad> quads_;
    Path eyes_, lights_;
    bool directional_;
    std::shared_ptr<const MeshTopology> topology_;
};

}  // namespace timeshade
