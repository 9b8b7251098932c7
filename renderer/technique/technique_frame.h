#pragma once

#include <string>
#include <utility>

#include "core/frame_caches.h"
#include "gl/late_counts.h"
#include "gl/pass_timer.h"
#include "gl/shader_source.h"
#include "passes/fullscreen.h"
#include "passes/gpu_mesh.h"
#include "passes/light_maps.h"
#include "passes/sample_buffer.h"
#include "passes/visibility_buffer.h"
#include "plan/frame_plan.h"

namespace timeshade {

/// What a technique may read of a frame, the tools of the frame that it may use, and the one buffer that it writes.
struct TechniqueFrame {
    const FramePlan& plan;
    const GpuMesh& mesh;
    const SampleBuffer& samples;
    const VisibilityBuffer& visibility;
    const Fullscreen& fullscreen;
    gl::PassTimer& timer;  ///< for steps inside build and lookup, named "build/..." and "lookup/..."
    LightMaps& maps;       ///< ordinary shadow maps that any technique may use
    FrameCaches&
        caches;  ///< for what is the same in many frames; the names of a technique's entries begin with its own
    gl::LateCounts& counts;                        ///< of lists: read at once or later, as who draws the frame wants
    std::pair<std::string, std::string> settings;  ///< the define that lib/settings.glsl wants

    /// Defines that lib/receiver.glsl, lib/light_map.glsl and lib/settings.glsl want. The frame gives them to lookup
    /// programs by itself.
    gl::ShaderDefines defines() const;
};

/// Those of the plan alone: CAMERA_TURNS, LIGHT_ORTHOGRAPHIC, CUTOUTS.
gl::ShaderDefines viewDefines(const FramePlan& plan);

}  // namespace timeshade
