// Mean over a pixel's camera samples of shading times lit: the only place where light becomes colour.
//
// VIEW_VISIBILITY: mean of lit alone.
// VERTEX_COLOURS: vertices have colours.
// MORE_COORDINATES: vertices have texture coordinates 1 and 2.
// INTERVAL_SAMPLES: camera samples are positions, and of each its parts count by their exposure.
// SHUTTER_WEIGHTS: each sample counts by the shutter's response at its time; else all alike.
#include "lib/receiver.glsl"
#include "lib/material_images.glsl"
#ifdef INTERVAL_SAMPLES
#include "lib/seen_parts.glsl"
#endif
#if defined(SHUTTER_WEIGHTS) || defined(INTERVAL_SAMPLES)
#include "shared/shutter_response.shared.h"
#endif

#ifdef INTERVAL_SAMPLES
uniform usampler2DArray partsOfPositions;  // first and count
uniform sampler2D visibilityOfParts;
#else
layout(binding = VISIBILITY_UNIT) uniform sampler2DArray visibility;
#endif
layout(binding = MATERIALS_UNIT) uniform samplerBuffer materials;
#ifdef VERTEX_COLOURS
layout(binding = VERTEX_COLOURS_UNIT) uniform samplerBuffer vertexColours;
#endif

layout(location = 0) out vec4 outputRadiance;

const float PI = 3.14159265358979;

struct Surface {
    vec3 normal;  // smooth, towards the viewer's side
    vec3 baseColor;
    float metallic;
    float roughness;
    vec3 emissive;
};

// The images of a material: those of its base colour, of metalness and roughness, of what it emits.
void readImages(inout Surface s, MovingTriangle t, Receiver r, float color, float data, float emissive) {
    vec4 uses = texelFetch(materials, int(t.material) * MATERIAL_TEXELS + 3);
    Footprint footprint = footprintOf(t, r);
    if (color >= 0.0) s.baseColor *= readImage(colorImages, color, uint(uses.x), r, footprint).rgb;
    if (data >= 0.0) {
        vec3 values = readImage(dataImages, data, uint(uses.y), r, footprint).rgb;
        s.roughness *= values.g;
        s.metallic *= values.b;
    }
    if (emissive >= 0.0) s.emissive *= readImage(colorImages, emissive, uint(uses.z), r, footprint).rgb;
}

Surface surfaceOf(MovingTriangle t, Receiver r) {
    int first = int(r.triangle) * TRIANGLE_SHADING_TEXELS;
    vec4 a = texelFetch(triangleShading, first), b = texelFetch(triangleShading, first + 1),
         c = texelFetch(triangleShading, first + 2), d = texelFetch(triangleShading, first + 3),
         e = texelFetch(triangleShading, first + 4);
    VertexMotion n = unpackMotion(a, b, c, d, e);
    vec3 normal = r.barycentrics.x * mix(n.open0, n.close0, r.time) +
                  r.barycentrics.y * mix(n.open1, n.close1, r.time) + r.barycentrics.z * mix(n.open2, n.close2, r.time);
    float squared = dot(normal, normal);
    normal = squared > 1e-12 ? normal * inversesqrt(squared) : normalize(r.geometricNormal);
    int material = int(t.material) * MATERIAL_TEXELS;
    vec4 factors = texelFetch(materials, material + 1), emissive = texelFetch(materials, material + 2);
    Surface s;
    s.normal = dot(normal, r.geometricNormal) < 0.0 ? -normal : normal;
    s.baseColor = texelFetch(materials, material).rgb;
    s.emissive = emissive.rgb;
    s.metallic = factors.x;
    s.roughness = factors.y;
    if (factors.z >= 0.0 || factors.w >= 0.0 || emissive.w >= 0.0)
        readImages(s, t, r, factors.z, factors.w, emissive.w);
#ifdef VERTEX_COLOURS
    ivec3 v = verticesOf(r.triangle);
    s.baseColor *= r.barycentrics.x * texelFetch(vertexColours, v.x).rgb +
                   r.barycentrics.y * texelFetch(vertexColours, v.y).rgb +
                   r.barycentrics.z * texelFetch(vertexColours, v.z).rgb;
#endif
    return s;
}

// glTF's metallic-roughness BRDF times cosine: Lambert plus GGX (Walter et al. 2007) with height-correlated Smith
// shadowing and Schlick's Fresnel term.
vec3 reflected(Surface s, vec3 toLight, vec3 toEye) {
    float nl = dot(s.normal, toLight), nv = max(dot(s.normal, toEye), 1e-3);
    if (nl <= 0.0) return vec3(0.0);
    vec3 sum = toLight + toEye;
    vec3 halfway = sum * inversesqrt(max(dot(sum, sum), 1e-12));  // opposite directions: no highlight, no division by 0
    // A cosine may round to above 1, and a power of a negative number is no number.
    float nh = clamp(dot(s.normal, halfway), 0.0, 1.0), vh = clamp(dot(toEye, halfway), 0.0, 1.0);
    float alpha = max(s.roughness * s.roughness, 1e-3), alpha2 = alpha * alpha;
    float d = nh * nh * (alpha2 - 1.0) + 1.0;
    float distribution = alpha2 / (PI * d * d);
    float smithing =
        0.5 / (nl * sqrt(nv * nv * (1.0 - alpha2) + alpha2) + nv * sqrt(nl * nl * (1.0 - alpha2) + alpha2));
    vec3 f0 = mix(vec3(0.04), s.baseColor, s.metallic);
    vec3 fresnel = f0 + (1.0 - f0) * pow(1.0 - vh, 5.0);
    vec3 diffuse = (1.0 - fresnel) * (1.0 - s.metallic) * s.baseColor / PI;
    return (diffuse + fresnel * distribution * smithing) * nl;
}

vec3 lightArriving(vec3 toLight, float u) {
    if (frame.lightDirection.w != 0.0) return frame.lightIntensity.rgb;
    float squared = dot(toLight, toLight);
    float cosine = dot(-toLight, lightDirectionAt(u)) * inversesqrt(squared);
    float cone = clamp((cosine - frame.lightCone.x) * frame.lightCone.z, 0.0, 1.0);
    float reach = squared * frame.lightIntensity.w;  // KHR_lights_punctual: fades to nothing at the range
    return frame.lightIntensity.rgb * (cone * cone / squared) * clamp(1.0 - reach * reach, 0.0, 1.0);
}

// Shading at one time: without the light, and what comes from it if nothing is between.
struct Shaded {
    vec3 unlit, arriving, reflected;
};

Shaded shadedAt(MovingTriangle t, Receiver r, bool needsLight) {
    Surface s = surfaceOf(t, r);
    vec3 toLight = towardsLight(r.position, r.time);
    vec3 eye = mix(frame.cameraPositionOpen.xyz, frame.cameraPositionClose.xyz, r.time);
    vec3 toEye = normalize(eye - r.position);
    vec3 ambient = mix(frame.ambientGround.rgb, frame.ambientSky.rgb, 0.5 + 0.5 * s.normal.y);
    Shaded shaded;
    shaded.unlit = s.emissive + ambient * mix(s.baseColor, vec3(0.04), 0.2);
    shaded.arriving = shaded.reflected = vec3(0.0);
    if (needsLight) {
        shaded.arriving = lightArriving(toLight, r.time);
        shaded.reflected = reflected(s, normalize(toLight), toEye);
    }
    return shaded;
}

vec3 shade(MovingTriangle t, Receiver r, float lit) {
    Shaded s = shadedAt(t, r, lit > 0.0);
    return s.unlit + lit * s.arriving * s.reflected;
}

#ifdef INTERVAL_SAMPLES
Shaded shadedAt(MovingTriangle t, SeenPart part, float share) {
    return shadedAt(t, receiverOnRay(t, part.triangle, part.place, mix(part.begin, part.end, share)), true);
}

vec3 directOf(Shaded s) { return s.arriving * s.reflected; }

// The mean of shading times visibility over a part. Shading is taken for quadratic in time, through the three nodes of
// Gauss and Legendre: what is lit early and what is lit late count as they are shaded then.
vec3 meanOver(MovingTriangle t, SeenPart part, vec4 value) {
    const float node = 0.38729833;  // from the middle: sqrt(3 / 20)
    Shaded first = shadedAt(t, part, 0.5 - node), middle = shadedAt(t, part, 0.5), last = shadedAt(t, part, 0.5 + node);
    vec3 unlit = (5.0 * (first.unlit + last.unlit) + 8.0 * middle.unlit) / 18.0;
    float mean = (value.z - 0.5) / node, square = max(value.w - value.z + 0.25, 0.0) / (node * node);
    vec3 direct = 0.5 * (square - mean) * directOf(first) + (1.0 - square) * directOf(middle) +
                  0.5 * (square + mean) * directOf(last);
    return unlit + value.x * value.y * max(direct, vec3(0.0));
}

vec3 colourOf(uint number, SeenPart part) {
    ivec2 at = ivec2(number % SEEN_PARTS_IN_ROW, number / SEEN_PARTS_IN_ROW);
    vec4 value = texelFetch(visibilityOfParts, at, 0);
#ifdef VIEW_VISIBILITY
    return vec3(part.triangle == NO_TRIANGLE ? 1.0 : value.x * value.y);
#else
    if (part.triangle == NO_TRIANGLE) return frame.background.rgb;
    MovingTriangle t = fetchTriangle(part.triangle);
#ifdef SOLVES_INTERVALS
    return meanOver(t, part, value);
#else
    return shade(t, receiverOnRay(t, part.triangle, part.place, part.time), value.x * value.y);
#endif
#endif
}

float exposureUntil(float u) { return shutterExposure(frame.response, frame.responseWidth, u); }

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    vec3 sum = vec3(0.0);
    for (uint position = 0u; position < frame.positions; ++position) {
        uvec2 parts = texelFetch(partsOfPositions, ivec3(pixel, position), 0).xy;
        for (uint number = parts.x; number < parts.x + parts.y; ++number) {
            SeenPart part = seenPart(number);
            sum += (exposureUntil(part.end) - exposureUntil(part.begin)) * colourOf(number, part);
        }
    }
    outputRadiance = vec4(sum / (exposureUntil(1.0) * float(frame.positions)), 1.0) * frame.weight;
}
#else
vec3 colourOf(uvec2 pixel, uint stratum) {
    float lit = texelFetch(visibility, ivec3(pixel, stratum), 0).x;
#ifdef VIEW_VISIBILITY
    return vec3(lit);
#else
    uint id = texelFetch(sampleIds, ivec3(pixel, stratum), 0).x;
    if (id == NO_TRIANGLE) return frame.background.rgb;
    MovingTriangle t = fetchTriangle(id);
    return shade(t, receiverOf(t, id, pixel, stratum), lit);
#endif
}

#ifdef SHUTTER_WEIGHTS
// Of a sample in the whole shutter.
float weightOf(uvec2 pixel, uint k) {
    float xi = samplePattern(pixel, k, frame.seed, SALT_CAMERA).z;
    float u = sampleTime(0.0, frame.wholeTimeScale, k, xi);
    return shutterWeight(frame.response & SHUTTER_KIND, frame.responseWidth, u);
}
#endif

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    vec3 sum = vec3(0.0);
#ifdef SHUTTER_WEIGHTS
    float weights = 0.0;
    for (uint stratum = 0u; stratum < frame.strata; ++stratum)
        sum += weightOf(pixel, frame.firstStratum + stratum) * colourOf(pixel, stratum);
    // Of all pieces together: a piece adds its part of one quotient.
    for (uint k = 0u; k < frame.wholeStrata; ++k) weights += weightOf(pixel, k);
    outputRadiance = vec4(sum / weights, 1.0);
#else
    for (uint stratum = 0u; stratum < frame.strata; ++stratum) sum += colourOf(pixel, stratum);
    outputRadiance = vec4(sum / float(frame.strata), 1.0) * frame.weight;
#endif
}
#endif
