#pragma once

#include <memory>

#include "oracle/camera_rays.h"
#include "oracle/embree_scene.h"
#include "oracle/oracle.h"

namespace timeshade {

/// What the oracle holds of a plan: the triangles, in Embree's hierarchy and in its own.
struct Oracle::Implementation {
    explicit Implementation(const FramePlan& plan);

    /// Hits of Embree that its own floats might have got wrong are resolved exactly: those near to the receiver or to
    /// the light always, those near to a caster's edge only where `edges` says so. At an edge a float errs to either
    /// side alike, on a millionth of all rays: a mean over many need not care.
    enum class Edges { AsEmbreeSays, ResolvedExactly };

    /// Resolves `lit` of a receiver that is tested, in double precision.
    OracleAnswer resolve(const oracle::Receiver& receiver, std::uint32_t triangle) const;
    /// The same by Embree for up to eight receivers and their triangles: fills `lit` of those that are tested.
    void testLanes(oracle::Receiver* receivers, const std::uint32_t* triangles, int lanes, Edges edges) const;
    /// Which triangle each of up to eight camera rays sees.
    void traceLanes(const FramePlan& plan, const oracle::CameraRay* rays, std::uint32_t* triangles, int lanes) const;

    std::shared_ptr<const MeshTexels> texels;
    std::shared_ptr<const MotionMesh> mesh;
    oracle::CutoutCover cutouts;
    oracle::EmbreeScene embree;
    oracle::MovingTriangles triangles;
    oracle::SweptBvh bvh;
};

}  // namespace timeshade
