#ifdef __cplusplus
#pragma once
#endif
#include "shared/types.shared.h"

// Uniform block bindings.
#define FRAME_BLOCK_BINDING 0
#define CAMERA_VIEW_BINDING 1
#define LIGHT_VIEW_BINDING 2
#define TECHNIQUE_BLOCK_BINDING 3     // a technique's own
#define TECHNIQUE_SETTINGS_BINDING 4  // made of its settings: lib/settings.glsl

// Storage block bindings. A technique's own follow.
#define LIST_CURSORS_BINDING 0
#define LIST_OFFSETS_BINDING 1
#define LIST_BLOCKS_BINDING 2
#define TECHNIQUE_STORAGE_BINDING 3
#define LIST_SCAN_BLOCK 1024  // cells that one work group of the scan sees
/// As are all from here on: where there is no room for all entries.
#define NO_LIST_SLOT 0x80000000u

// Texture units of the frame. Samplers that name none get those from gl::firstFreeUnit on, by their names.
#define TRIANGLE_POSITIONS_UNIT 0  // buffer texture, TRIANGLE_POSITION_TEXELS RGBA32F a triangle
#define TRIANGLE_SHADING_UNIT 1    // buffer texture, TRIANGLE_SHADING_TEXELS RGBA32F a triangle
#define SAMPLE_IDS_UNIT 2          // R32UI array, one layer a stratum
#define VISIBILITY_UNIT 3          // R32F array, one layer a stratum
#define LARGE_TRIANGLES_UNIT 4     // buffer texture, R32UI: triangles drawn as rectangles
#define MATERIALS_UNIT 5           // buffer texture, MATERIAL_TEXELS RGBA32F a material
#define VERTEX_INDICES_UNIT 6      // buffer texture, R32UI: three vertices a triangle
#define VERTEX_COLOURS_UNIT 7      // buffer texture, RGBA32F a vertex; where VERTEX_COLOURS
#define MORE_COORDINATES_UNIT 8    // buffer texture, RGBA32F a vertex: coordinates 1 and 2; where MORE_COORDINATES
#define CUTOUT_MATERIALS_UNIT 9    // buffer texture, RGBA32UI: a record a material (cutout.shared.h)
#define COLOR_IMAGES_UNIT 10       // 2D array of base colour and emissive images, sRGB
#define DATA_IMAGES_UNIT 11        // 2D array of metallic-roughness images, linear
#define CUTOUT_ALPHAS_UNIT 12      // buffer texture, R8UI: the alphas of all that are cut out

#define TRIANGLE_POSITION_TEXELS 5
#define TRIANGLE_SHADING_TEXELS 6
#define MATERIAL_TEXELS 4

// How a material's images are read, as one small whole number each: which texture coordinates, and how they wrap.
#define TEXTURE_COORDINATES 3u  // bits
#define TEXTURE_WRAP 3u         // bits, after a shift:
#define TEXTURE_WRAP_U_SHIFT 2
#define TEXTURE_WRAP_V_SHIFT 4
#define TEXTURE_REPEATS 0u
#define TEXTURE_MIRRORS 1u
#define TEXTURE_CLAMPS 2u
#define NO_TRIANGLE 0xffffffffu
#define REACHED_SIDE 128  // cells along a side of the map
#define NO_CELL 1024.0    // more than any: where nothing can be shadowed

SHARED_BEGIN

/// Constants of a whole frame. Positions are world space less FramePlan::origin.
struct FrameBlock {
    vec4 lightPositionOpen;   // xyz at u = 0; directional: not used
    vec4 lightPositionClose;  // xyz at u = 1
    vec4 cameraPositionOpen;  // xyz: the eye at u = 0
    vec4 cameraPositionClose;
    // The way light travels, or a spot's axis, at u = 0; w: 1 for directional, else 0. A direction is as long as makes
    // its component along the map's axis 1, and is linear in u; a spot's axis is a unit vector, interpolated and then
    // normalised.
    vec4 lightDirection;
    vec4 lightDirectionClose;  // xyz at u = 1
    vec4 lightIntensity;       // rgb: candela or lux, times exposure; w: 1 / range^2 of a spot, 0 if it has none
    vec4 lightCone;   // x: cos outer, y: cos inner, z: 1 / (cos inner - cos outer), w: texel width (per distance for a
                      // spot)
    vec4 ambientSky;  // rgb: radiance from above, exposed
    vec4 ambientGround;  // rgb: radiance from below, exposed
    vec4 background;     // rgb: what a camera sample that hits nothing sees, exposed
    float timeBase;      // u of the first stratum's start
    float timeScale;     // length of a stratum in u
    uint strata;         // of the shutter: camera samples per pixel, unless those are positions
    uint seed;
    uvec2 imageSize;
    uint mapWidth;        // texels in a row of the shadow map
    float weight;         // share of this render in the picture; of renders that count alike 1 / renders
    uint pixelCentres;    // 1: camera samples lie at pixel centres
    uint response;        // of the shutter, as in shutter_response.shared.h; SHUTTER_BOX where nothing moves
    float responseWidth;  // standard deviation of SHUTTER_GAUSSIAN in u; else 0
    uint positions;       // interval samples: per pixel; 0: camera samples have a time each
    // Where the frame is a linear piece of a shutter: the strata before it in the shutter, those of the whole shutter
    // and their length. Else 0, strata and timeScale.
    uint firstStratum;
    uint wholeStrata;
    float wholeTimeScale;
    float unused;
};

/// How vertices become what a rasteriser with a sample in space and time needs: view coordinates (X, Y, Z) that are
/// linear in u, with the image position s = X/Z, t = Y/Z in [0, 1] under perspective and s = X, t = Y when
/// orthographic. t grows upwards, Z is the distance from the eye's plane along the view direction.
struct ViewBlock {
    mat4 viewFromWorldOpen;   // affine, at u = 0
    mat4 viewFromWorldClose;  // affine, at u = 1
    mat4 raysOpen;  // columns 0..2: the ray of (s, t, 1) in view coordinates at u = 0; identity unless the view turns
    mat4 raysClose;
    vec2 size;           // pixels or texels
    float nearDistance;  // perspective: nothing nearer is seen. Orthographic: 0
    float farDistance;   // orthographic: depth range. Perspective: not used
};

SHARED_END

#ifdef __cplusplus
namespace timeshade::shared {
static_assert(sizeof(FrameBlock) == 11 * 16 + 64, "std140 layout changed: fix both readers");
static_assert(sizeof(ViewBlock) == 4 * 64 + 16, "std140 layout changed: fix both readers");
}  // namespace timeshade::shared
#endif
