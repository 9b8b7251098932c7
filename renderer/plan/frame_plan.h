#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "plan/dynamic_caster_mask.h"
#include "plan/frame_request.h"
#include "plan/light_motion.h"
#include "plan/motion_classifier.h"
#include "plan/rest_pose.h"
#include "plan/triangle_motion.h"
#include "plan/view_plan.h"
#include "scene/light.h"
#include "scene/scene.h"
#include "shared/frame_blocks.shared.h"

namespace timeshade {

/// A motion mesh in the form that the GPU reads, relative to the plan's origin.
struct MeshTexels {
    std::vector<glm::vec4> positions;  ///< TRIANGLE_POSITION_TEXELS a triangle
    std::vector<glm::vec4> shading;    ///< TRIANGLE_SHADING_TEXELS a triangle
    std::vector<glm::vec3> vertices;   ///< two a vertex: position at u = 0, position at u = 1
};

/// What moves in this shutter; decided once per frame, printed by --explain.
struct MotionSummary {
    std::size_t triangles = 0;
    std::size_t movingTriangles = 0;  ///< any vertex moves in the world
    bool lightMoves = false;
    bool cameraMoves = false;
    std::size_t reclassified = 0;  ///< triangles whose motion was not known from the frame before
    std::size_t instances = 0, movingInstances = 0,
                nonTranslatingInstances = 0;  ///< meshes; that move in the light's frame; of those, that turn or deform
    double largestTurnDegrees = 0.0;
};

/// A pass of the frame and why it is there.
struct PassDecision {
    std::string name;
    std::string reason;
    std::size_t triangles = 0;
};

/// All that is decided before anything is drawn: times, matrices, lists, seed. Techniques read it and nothing else
/// but the mesh and the sample buffer.
struct FramePlan {
    FrameRequest request;
    glm::dvec3 origin{0.0};  ///< subtracted from world positions in double before they become floats
    std::shared_ptr<const MotionMesh> mesh;
    std::shared_ptr<const MeshTexels> texels;
    Bounds extent;  ///< of all vertices at both ends of the shutter, relative to the origin
    LightPose lightOpen, lightClose;
    ViewPlan camera;
    ViewPlan light;
    shared::FrameBlock block{};
    MotionSummary motion;
    std::shared_ptr<const std::vector<TriangleMotion>> triangles;  ///< what each does in this shutter
    LightMotion casters;                   ///< the light's side of it, by the way in which a technique has to draw them
    std::shared_ptr<const RestPose> rest;  ///< of the scene: the same for all of a planner's frames
    StaticVersions versions;               ///< what may be kept from frame to frame
    DynamicCasterMask
        reached;  ///< where in the light's map something that moves may cast a shadow; empty unless still.lit
    std::vector<PassDecision> passes;
    std::vector<std::string> warnings;
    const std::vector<Material>* materials = nullptr;  ///< the scene's, which outlives the plan
    const std::vector<Image>* images = nullptr;
};

/// Makes plans for one scene, and keeps what two frames in a row share: a mesh is deformed and converted only when
/// its instants change.
class FramePlanner {
  public:
    explicit FramePlanner(const Scene& scene);
    FramePlan plan(const FrameRequest& request);

  private:
    void deform(double openSeconds, double closeSeconds);
    void decideMotion(FramePlan& plan);

    const Scene& scene_;
    glm::dvec3 origin_{0.0};
    double exposure_ = 1.0;
    double openSeconds_ = 0.0, closeSeconds_ = -1.0;
    std::shared_ptr<const MotionMesh> mesh_;
    std::shared_ptr<const RestPose> rest_;
    std::shared_ptr<const MeshTexels> texels_;
    Bounds extent_;
    std::size_t movingTriangles_ = 0;
    MotionClassifier memory_;
};

/// The plan of render m of `renders` of the same frame: one camera sample per pixel, all of them at the instant
/// u = (m + 1/2) / renders, with another position inside the pixel in each render, and 1 / renders of the picture's
/// weight. What brute force draws.
FramePlan planAtInstant(const FramePlan& plan, int m, int renders);

}  // namespace timeshade
