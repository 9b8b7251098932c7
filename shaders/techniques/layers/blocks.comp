// Nearest and farthest depth at the middle of the shutter of the samples in each block of BLOCK x BLOCK texels; the
// first above the second where there is nothing. Windows are made of whole blocks, and empty ones cost nothing more.
// Samples that saw nothing get their times here, which the rasteriser leaves to those that saw something.
#include "shared/sample_pattern.shared.h"
#include "techniques/layers/samples.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
#include "lib/work_groups.glsl"

layout(rg32f) uniform writeonly image2DArray extents;
layout(rgba32f) uniform writeonly image2DArray emptySamples;
uniform uint strata;
uniform float sampleLength;  // of a stratum of the map, u

void storeTime(ivec3 place) {
    float xi = samplePattern(uvec2(place.xy), frame.firstStratum + uint(place.z), frame.seed, SALT_LIGHT).z;
    imageStore(emptySamples, place, vec4(0.0, 0.0, 0.0, sampleTime(frame.timeBase, sampleLength, uint(place.z), xi)));
}

void main() {
    ivec2 block = placeInRows(imageSize(extents).xy);
    if (any(greaterThanEqual(block, imageSize(extents).xy))) return;
    ivec2 end = min((block + 1) * BLOCK, ivec2(lightView.size));
    vec2 range = vec2(1e30, -1e30);
    for (uint k = 0u; k < strata; ++k)
        for (int y = block.y * BLOCK; y < end.y; ++y)
            for (int x = block.x * BLOCK; x < end.x; ++x) {
                ivec3 place = ivec3(x, y, k);
                if (isEmpty(place)) {
                    storeTime(place);
                    continue;
                }
                float depth = depthAtMiddle(sampleAt(place));
                range = vec2(min(range.x, depth), max(range.y, depth));
            }
    imageStore(extents, ivec3(block, 0), vec4(range, 0.0, 0.0));
}
