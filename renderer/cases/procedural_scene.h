#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "plan/frame_request.h"
#include "scene/scene.h"

namespace timeshade {

/// A quadrilateral in world space, at both ends of the shutter. Corners in order around it.
struct MovingQuad {
    glm::dvec3 open[4];
    glm::dvec3 close[4];
};

/// A triangle in world space, at both ends of the shutter.
struct MovingCorners {
    glm::dvec3 open[3];
    glm::dvec3 close[3];
};

/// The rectangle [centre.x - halfX, centre.x + halfX] x [lowY, highY] at height centre.z, moving from a to b.
MovingQuad slidingQuad(glm::dvec3 a, glm::dvec3 b, double halfX, double lowY, double highY);

/// A scene of quads and triangles with known motion, for cases with exact answers. Its time from 0 s to 1 s is one
/// shutter: frames per second 1, shutter length 1, frame 0 (its defaults). Quads come first: quad i is the triangles 2i
/// and 2i + 1.
class ProceduralScene final : public Scene {
  public:
    std::vector<MovingQuad> quads;
    std::vector<MovingCorners> triangles;
    CameraPose cameraOpen, cameraClose;
    std::optional<CameraPose> overview;  ///< a second camera, static
    LightPose lightOpen, lightClose;

    /// Must be called once, after the members above are set.
    void finish(std::string name = "procedural");
    /// The request that opens the shutter at u = 0 and closes it at u = 1.
    static FrameRequest request(int width, int height, int samplesPerPixel, const MapSize& mapSize, std::uint32_t seed);

    const std::string& name() const override { return name_; }
    double duration() const override { return 1.0; }
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
    std::string name_;
    SceneDefaults defaults_{0.0, 1.0, 1.0};
    std::vector<Material> materials_{Material{}};
    std::vector<Image> images_;
    std::vector<CameraBookmark> cameras_{{"only"}};
    std::vector<std::string> notes_;
    Bounds bounds_;
    std::shared_ptr<const MeshTopology> topology_;
};

}  // namespace timeshade
