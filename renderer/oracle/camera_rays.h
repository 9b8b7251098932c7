#pragma once

#include "oracle/oracle.h"
#include "oracle/segment_triangle.h"
#include "oracle/swept_bvh.h"

namespace timeshade::oracle {

/// A camera sample in double precision: its time and its ray. Time and place in the image are the floats of the shared
/// sample pattern, taken as exact. Positions are world space less the plan's origin.
struct CameraRay {
    double time = 0.0;
    glm::dvec3 eye{0.0};
    glm::dvec3 direction{0.0};  ///< to the image plane at distance 1
};

CameraRay cameraRay(const FramePlan& plan, SampleIndex sample);
/// The ray through a place in the image (pixels from the lower left corner) at time u.
CameraRay cameraRayThrough(const FramePlan& plan, glm::vec2 place, float u);

/// Where the camera ray meets the plane of the triangle that the sample sees, and what it has to do with the light.
struct Receiver {
    OracleAnswer answer;     ///< all but `lit`; `marginal` where facing or cone are within a float's rounding
    glm::dvec3 light{0.0};   ///< the far end of the shadow segment
    double clearance = 0.0;  ///< how near a caster's plane may pass without shadowing it
};

Receiver receiverOf(const FramePlan& plan, const MovingTriangles& triangles, SampleIndex sample,
                    std::uint32_t triangle);
/// The same for a ray that is at hand.
Receiver receiverOf(const FramePlan& plan, const MovingTriangles& triangles, const CameraRay& ray,
                    std::uint32_t triangle);

/// The point with the barycentrics (1 - y - z, y, z) of a triangle at time u, whether or not the camera sees it then:
/// two-sided triangles face the eye's side of their plane.
Receiver receiverOnTriangle(const FramePlan& plan, const MovingTriangles& triangles, std::uint32_t triangle,
                            glm::dvec2 barycentrics, float u);

/// Barycentrics (y, z) of a point in the plane of a triangle at time u; not finite where the triangle has no area.
glm::dvec2 barycentricsOf(const MovingTriangles& triangles, std::uint32_t triangle, const glm::dvec3& position,
                          double u);

/// The far end of the shadow segment of a point. A directional light's segment is as long as the light's map is deep,
/// which takes it past all of the scene.
glm::dvec3 lightEnd(const FramePlan& plan, const glm::dvec3& position, double u);

}  // namespace timeshade::oracle
