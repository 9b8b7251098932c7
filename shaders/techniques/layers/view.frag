// The layers as the light sees them: the map as a square in the middle of the picture, at the middle of the shutter.
// Negative beside the map and where there is no such layer.
//
// VIEW_COUNT: layers of the tile. Of the layer `setting.shown_layer`: VIEW_OPACITY, VIEW_WEIGHT, its cell's; VIEW_WAY,
// length of its mean motion; VIEW_DIRECTION, where that goes, in turns from the map's first axis.
#include "techniques/layers/tile.glsl"

#include "lib/settings.glsl"

layout(location = 0) out float outputValue;

uniform sampler2DArray grids;

float valueOf(ivec2 tile, vec2 position) {
#if defined(VIEW_COUNT)
    float count = 0.0;
    for (int i = 0; i < mostLayers; ++i) count += layerOf(tile, i).present ? 1.0 : 0.0;
    return count;
#else
    int number = int(setting.shown_layer) - 1;
    Layer layer = layerOf(tile, number);
    if (!layer.present) return -1.0;
#if defined(VIEW_WAY)
    return length(layer.motion);
#elif defined(VIEW_DIRECTION)
    return fract(atan(layer.motion.y, layer.motion.x) / 6.28318530718);
#else
    vec2 cell = clamp(toGrid(gridOf(layer), position - tileCentre(tile)), vec2(0.0), vec2(float(GRID) - 0.5));
    vec4 sums = texelFetch(grids, ivec3(tile * GRID + ivec2(cell), number), 0);
#ifdef VIEW_OPACITY
    return sums.w > 0.0 ? sums.z / sums.w : -1.0;
#else
    return sums.w;
#endif
#endif
#endif
}

void main() {
    vec2 size = vec2(frame.imageSize);
    float side = min(size.x, size.y);
    vec2 position = (gl_FragCoord.xy - 0.5 * (size - side)) / side;
    bool inside = all(greaterThanEqual(position, vec2(0.0))) && all(lessThan(position, vec2(1.0)));
    vec2 texel = position * lightView.size;
    outputValue = inside ? valueOf(ivec2(texel) / TILE, texel) : -1.0;
}
