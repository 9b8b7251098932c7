#pragma once

#include <vector>

#include "core/frame_caches.h"
#include "passes/static_map.h"

namespace timeshade {

/// Ordinary shadow maps of a frame, for whichever technique wants one: drawn when first asked for, and only when what
/// they show has changed.
class LightMaps {
  public:
    using Coverage = StaticMap::Coverage;

    LightMaps(gl::ProgramCache& programs, FrameCaches& caches) : programs_(programs), caches_(caches) {}
    /// Names the frame whose maps are asked for next; plan and mesh must live until the next call. The frame's uniforms
    /// and the mesh must be bound when a map is asked for.
    void begin(const FramePlan& plan, const GpuMesh& mesh);

    /// The nearest depth of everything that is static in the light's frame.
    const gl::Texture& ofStaticCasters(Coverage coverage);
    /// The same with exact coverage, and the triangle that each depth is of.
    const StaticMap& ofStaticTriangles();
    /// The nearest depth of everything as it is at one instant of the shutter. Valid until the next call.
    const gl::Texture& atInstant(float u);

    /// What has been asked for since begin, for checks.
    const std::vector<const gl::Texture*>& textures() const { return textures_; }

    /// How the entries of `caches` are called whose memory is that of these maps.
    static constexpr const char* cacheNames = "light maps: ";

  private:
    StaticMap& staticMap(Coverage coverage, bool keepsTriangles = false);
    const gl::Texture& handOut(const gl::Texture& map);

    gl::ProgramCache& programs_;
    FrameCaches& caches_;
    const FramePlan* plan_ = nullptr;
    const GpuMesh* mesh_ = nullptr;
    std::vector<const gl::Texture*> textures_;
};

}  // namespace timeshade
