// Which texel of the light's map a receiver is tested in. False outside the map.
#include "lib/light_map.glsl"
#include "techniques/ranges/bindings.shared.h"

bool texelOf(MapPoint m, out ivec2 texel) {
    texel = ivec2(floor(m.position * lightView.size));
    return all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, ivec2(lightView.size)));
}

int listNumber(ivec2 texel) { return texel.y * int(frame.mapSize) + texel.x; }
