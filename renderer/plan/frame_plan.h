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

/// A motion mesh packed for the GPU: floats, relative to the plan's origin.
struct MeshTexels {
    std::vector<glm::vec4> positions;  ///< TRIANGLE_POSITION_TEXELS per triangle
    std::vector<glm::vec4> shading;    ///< TRIANGLE_SHADING_TEXELS per triangle
    std::vector<glm::vec3> vertices;   ///< two per vertex: position at u = 0, position at u = 1
};

/// What moves in this shutter. Computed once per frame, printed by --explain.
struct MotionSummary {
    std::size_t triangles = 0;
    std::size_t movingTriangles = 0;  ///< at least one vertex moves in world space
    bool lightMoves = false;          ///< its position changes, or its direction
    double lightTurnDegrees = 0.0;    ///< by how much a spot's axis or a sun's direction turns
    bool cameraMoves = false;
    std::size_t reclassified = 0;             ///< triangles whose motion could not be reused from the previous frame
    std::size_t instances = 0;                ///< mesh instances
    std::size_t movingInstances = 0;          ///< of those: move relative to the light
    std::size_t nonTranslatingInstances = 0;  ///< of those: turn or deform
    double largestTurnDegrees = 0.0;
};

/// A pass of the frame and the reason for it, as --explain prints it.
struct PassDecision {
    std::string name;
    std::string reason;
    std::size_t triangles = 0;
};

/// Everything that is decided before a frame is drawn: times, matrices, triangle lists, seed. A technique reads the
/// plan, the mesh and the sample buffer, nothing else. Positions in it are relative to `origin`, in world units, unless
/// stated otherwise.
struct FramePlan {
    FrameRequest request;
    glm::dvec3 origin{0.0};  ///< subtracted from world positions in double before they become floats
    std::shared_ptr<const MotionMesh> mesh;
    std::shared_ptr<const MeshTexels> texels;
    Bounds extent;  ///< of all vertices at both ends of the shutter, relative to the origin
    LightPose lightOpen, lightClose;
    glm::dmat3 lightAxes{
        1.0};  ///< of the light's map, constant during a shutter: right, up, back along the mean direction
    ViewPlan camera;
    ViewPlan light;
    /// Its response is the request's, but a box where nothing moves: then all instants are alike, and a weight would
    /// only spread a pixel's samples less evenly over its area.
    shared::FrameBlock block{};
    MotionSummary motion;
    std::shared_ptr<const std::vector<TriangleMotion>> triangles;  ///< motion of each triangle, by id
    LightMotion casters;                                           ///< static, dynamic and near-plane casters
    std::shared_ptr<const RestPose> rest;  ///< of the scene; the same for all frames of a planner
    StaticVersions versions;               ///< keys for caches that outlive the frame
    DynamicCasterMask reached;             ///< shadow map area of dynamic casters; empty if versions.lit is 0
    std::vector<PassDecision> passes;
    std::vector<std::string> warnings;
    const std::vector<Material>* materials = nullptr;  ///< owned by the scene, which must outlive the plan
    const std::vector<Image>* images = nullptr;
};

/// Plans the frames of one scene. The mesh is deformed and packed only when the shutter's instants change, and motion
/// is classified only for triangles that changed. The scene must outlive the planner and its plans.
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
    InnerMotion inner_;
    MotionClassifier memory_;
};

/// The plan of render m (0 <= m < renders) of a frame that is accumulated from `renders` instants: one camera sample
/// per pixel, all at u = (m + 1/2) / renders, at another sub-pixel position in each render, with the weight that the
/// shutter's response gives to that instant among all of them: 1 / renders for a box.
FramePlan planAtInstant(const FramePlan& plan, int m, int renders);

}  // namespace timeshade
