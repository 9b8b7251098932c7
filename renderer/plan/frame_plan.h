#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "plan/dynamic_caster_mask.h"
#include "plan/frame_request.h"
#include "plan/light_motion.h"
#include "plan/motion_classifier.h"
#include "plan/path_warning.h"
#include "plan/rest_pose.h"
#include "plan/triangle_motion.h"
#include "plan/view_plan.h"
#include "scene/cutouts.h"
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
    std::vector<PathWarning> pathWarnings;  ///< also among the warnings
    std::vector<std::string> warnings;
    /// The linear pieces of a shutter that is cut into more than one, in order; empty where it is not. Each is the plan
    /// of its own part of the shutter, over which its u runs, with its share of the strata and the rest of the request
    /// as it is; no cached samples. The plan itself says what holds for all: request, samples, weights, passes,
    /// warnings, what moves; its mesh, camera and light are those of the first piece.
    std::vector<FramePlan> pieces;
    const std::vector<Material>* materials = nullptr;  ///< owned by the scene, which must outlive the plan
    const std::vector<Image>* images = nullptr;
    std::optional<GroundSquare> ground;      ///< that was added to the scene's own things
    std::shared_ptr<const Cutouts> cutouts;  ///< of the materials; null where none is cut out
};

/// Whether the triangle's material is cut out by its alpha: what such a triangle hides or shadows does not follow from
/// its edges.
inline bool isCutOut(const FramePlan& plan, std::uint32_t triangle) {
    return plan.cutouts && plan.cutouts->sheet(plan.mesh->topology->triangleMaterials[triangle]).cuts;
}

/// Plans the frames of one scene. The mesh is deformed and packed only when the shutter's instants change, and motion
/// is classified only for triangles that changed. The scene must outlive the planner and its plans.
class FramePlanner {
  public:
    explicit FramePlanner(const Scene& scene);
    FramePlan plan(const FrameRequest& request);

  private:
    /// What the scene is between two times.
    struct Shape {
        double openSeconds = 0.0, closeSeconds = -1.0;
        std::shared_ptr<const MotionMesh> mesh;
        std::shared_ptr<const MeshTexels> texels;
        Bounds extent;
        std::size_t movingTriangles = 0;
        InnerMotion inner;
    };
    FramePlan planPiece(const FrameRequest& request, int piece, int pieces);
    void deform(Shape& shape, double openSeconds, double closeSeconds) const;
    void decideMotion(FramePlan& plan);
    double exposureFor(const LightChange& change);

    const Scene& scene_;
    glm::dvec3 origin_{0.0};
    double exposure_ = 1.0;  ///< of the light as it is placed by `placed_`
    LightChange placed_;
    std::shared_ptr<const RestPose> rest_;
    std::shared_ptr<const Cutouts> cutouts_;
    std::vector<Shape> shapes_;  ///< of the pieces of the last frame
    MotionClassifier memory_;
};

/// Into how many renders a frame falls for a technique that draws so many instants of it, or 1: those instants, or the
/// shutter's pieces.
int rendersOf(const FramePlan& plan, int instants);

/// The plan of one of these renders.
FramePlan renderOf(const FramePlan& plan, int render, int instants);

/// The piece of which that render is: the plan itself where there is but one.
const FramePlan& pieceOf(const FramePlan& plan, int render, int instants);

/// Gives all pieces the samples of the whole: each its share of the strata, with the places and times that they have
/// there. Of a plan without pieces nothing.
void shareSamples(FramePlan& plan);

/// The plan of a frame that is drawn in so many pieces.
FramePlan planOfPieces(const FrameRequest& request, std::vector<FramePlan> pieces);

/// The plan of render m (0 <= m < renders) of a frame that is accumulated from `renders` instants: one camera sample
/// per pixel, all at u = (m + 1/2) / renders, at another sub-pixel position in each render, with the weight that the
/// shutter's response gives to that instant among all of them: 1 / renders for a box.
FramePlan planAtInstant(const FramePlan& plan, int m, int renders);

}  // namespace timeshade
