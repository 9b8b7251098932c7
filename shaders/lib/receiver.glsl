// The receiver of a camera sample: which point of which triangle it sees, at its own time. Derived again from the
// triangle's number and the time wherever it is needed, so that no G-buffer has to be written or read.
//
// CAMERA_TURNS, LIGHT_ORTHOGRAPHIC: kinds of view.
#include "lib/blocks.glsl"
#include "lib/triangle_texels.glsl"
#include "shared/moving_triangle.shared.h"
#include "shared/sample_pattern.shared.h"
#include "shared/segment_triangle.shared.h"

layout(binding = TRIANGLE_POSITIONS_UNIT) uniform samplerBuffer trianglePositions;
layout(binding = SAMPLE_IDS_UNIT) uniform usampler2DArray sampleIds;

struct Receiver {
    uint triangle;
    float time;
    vec3 barycentrics;
    vec3 position;         // world space less the origin
    float clearance;       // how near a caster's plane may pass without shadowing it (segment_triangle.shared.h)
    vec3 edge1, edge2;     // two edges of the triangle at this time: its plane
    vec3 geometricNormal;  // not normalised; of a two-sided triangle the one towards the camera
    vec2 place;            // in the image, where it was found on a ray
};

MovingTriangle fetchTriangle(uint id) { return fetchTriangleFrom(trianglePositions, id); }

// The point of a triangle with the given barycentrics, at time u.
Receiver pointAt(MovingTriangle t, uint id, vec3 barycentrics, float u) {
    vec3 p0 = mix(t.open0, t.close0, u), p1 = mix(t.open1, t.close1, u), p2 = mix(t.open2, t.close2, u);
    Receiver r;
    r.triangle = id;
    r.time = u;
    r.barycentrics = barycentrics;
    r.position = barycentrics.x * p0 + barycentrics.y * p1 + barycentrics.z * p2;
    r.clearance = receiverClearance(p0, p1, p2);
    r.edge1 = p1 - p0;
    r.edge2 = p2 - p0;
    r.geometricNormal = cross(r.edge1, r.edge2);
    return r;
}

vec3 inCameraAt(vec3 open, vec3 close, float u) {
    return mix(transformed(cameraView.viewFromWorldOpen, open), transformed(cameraView.viewFromWorldClose, close), u);
}

// The ray through an image position of a camera that turns, at time u, in view coordinates.
vec3 cameraRayAt(vec2 position, float u) {
    return mix((cameraView.raysOpen * vec4(position, 1.0, 0.0)).xyz,
               (cameraView.raysClose * vec4(position, 1.0, 0.0)).xyz, u);
}

// The edge functions of a triangle at an image position, at time u: barycentrics are their shares of their sum. The
// same arithmetic as the sample pass.
vec3 edgesOnRay(MovingTriangle t, vec2 position, float u) {
    vec3 v0 = inCameraAt(t.open0, t.close0, u);
    vec3 v1 = inCameraAt(t.open1, t.close1, u);
    vec3 v2 = inCameraAt(t.open2, t.close2, u);
#ifdef CAMERA_TURNS
    vec3 ray = cameraRayAt(position, u);
    return edgeFunctions(v0.xy * ray.z - ray.xy * v0.z, v1.xy * ray.z - ray.xy * v1.z, v2.xy * ray.z - ray.xy * v2.z);
#else
    return edgeFunctions(v0.xy - position * v0.z, v1.xy - position * v1.z, v2.xy - position * v2.z);
#endif
}

// Where the camera ray through an image position meets the triangle's plane at time u.
Receiver receiverOnRay(MovingTriangle t, uint id, vec2 position, float u) {
    vec3 e = edgesOnRay(t, position, u);
    float sum = e.x + e.y + e.z;
#ifdef INTERVAL_SAMPLES
    // At the end of what is seen of a triangle the ray meets its edge, up to rounding.
    e = sum < 0.0 ? min(e, vec3(0.0)) : max(e, vec3(0.0));
    float inside = e.x + e.y + e.z;
    Receiver r = pointAt(t, id, inside != 0.0 ? e / inside : vec3(1.0 / 3.0), u);
#else
    Receiver r = pointAt(t, id, e / sum, u);
#endif
    if (sum < 0.0) r.geometricNormal = -r.geometricNormal;  // only two-sided triangles are seen from behind
    r.place = position;
    return r;
}

// Of a camera sample, at its own time.
Receiver receiverOf(MovingTriangle t, uint id, uvec2 pixel, uint stratum) {
    vec3 pattern = cameraSample(pixel, frame.firstStratum + stratum, frame.seed, frame.pixelCentres);
    float u = sampleTime(frame.timeBase, frame.timeScale, stratum, pattern.z);
    return receiverOnRay(t, id, (vec2(pixel) + pattern.xy) / cameraView.size, u);
}

// The way light travels at time u, or a spot's axis, as FrameBlock has them. Of a light that does not turn: the very
// same numbers at every u.
vec3 lightDirectionAt(float u) {
    vec3 change = frame.lightDirectionClose.xyz - frame.lightDirection.xyz, d = frame.lightDirection.xyz + change * u;
    return frame.lightDirection.w != 0.0 || change == vec3(0.0) ? d : normalize(d);
}

// From the receiver to the light at its time, not normalised.
vec3 towardsLight(vec3 position, float u) {
    return frame.lightDirection.w != 0.0 ? -lightDirectionAt(u)
                                         : mix(frame.lightPositionOpen.xyz, frame.lightPositionClose.xyz, u) - position;
}

// Only receivers that face the light and lie inside its cone are tested for shadow.
bool facesLight(Receiver r) {
    vec3 l = towardsLight(r.position, r.time);
    bool inCone = frame.lightDirection.w != 0.0 || dot(-l, lightDirectionAt(r.time)) >= frame.lightCone.x * length(l);
    return inCone && dot(r.geometricNormal, l) > 0.0;
}
