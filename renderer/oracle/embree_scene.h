#pragma once

#include <cstdint>
#include <memory>

#include <glm/glm.hpp>

#include "oracle/cutout_cover.h"
#include "plan/frame_plan.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace timeshade::oracle {

/// Eight rays as structures of arrays. Lanes that are not `active` are left alone.
struct RayPacket {
    static constexpr int size = 8;
    bool active[size] = {};
    glm::vec3 from[size];
    glm::vec3 direction[size];
    float time[size] = {};
    /// A triangle that firstHits does not meet, or none.
    std::uint32_t except[size] = {NO_TRIANGLE, NO_TRIANGLE, NO_TRIANGLE, NO_TRIANGLE,
                                  NO_TRIANGLE, NO_TRIANGLE, NO_TRIANGLE, NO_TRIANGLE};
    float low = 0.0f, high = 1.0f;  ///< part of the rays that counts
    /// Whether a triangle that is cut out by its alpha is met where floats can't tell if it covers.
    bool keepsDoubtful = false;
};

/// What a ray met first.
struct PacketHits {
    bool hit[RayPacket::size] = {};
    std::uint32_t triangle[RayPacket::size];
    float distance[RayPacket::size];          ///< in lengths of the ray's direction
    bool doubtful[RayPacket::size] = {};      ///< floats can't tell whether it covers there; only of what keeps such
    float leastBarycentric[RayPacket::size];  ///< how far inside the triangle: 1/3 at its centre, 0 on an edge
};

/// The plan's mesh as one Embree geometry with linear motion blur.
class EmbreeScene {
  public:
    explicit EmbreeScene(const FramePlan& plan);
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    /// The nearest hit of each ray but those of its own `except`.
    PacketHits firstHits(const RayPacket& packet) const;
    /// The nearest of all hits but those of one-sided triangles from behind.
    PacketHits firstSeen(const RayPacket& packet) const;

  private:
    struct ReleaseDevice {
        void operator()(RTCDeviceTy* device) const;
    };
    struct ReleaseScene {
        void operator()(RTCSceneTy* scene) const;
    };

    std::shared_ptr<const MeshTexels> texels_;
    CutoutCover cutouts_;
    std::unique_ptr<RTCDeviceTy, ReleaseDevice> device_;
    std::unique_ptr<RTCSceneTy, ReleaseScene> scene_;
};

}  // namespace timeshade::oracle
