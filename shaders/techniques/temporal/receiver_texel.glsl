#include "lib/light_map.glsl"
#include "lib/only_if.glsl"
#include "techniques/temporal/bindings.shared.h"

// The texel that the point lies in; false outside the map.
bool texelOf(MapPoint m, out ivec2 texel) {
    texel = ivec2(floor(m.position * lightView.size));
    return all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, ivec2(lightView.size)));
}

// What a view shows of a texel's list.
struct ListSummary {
    int tuples;
    float firstTime;  // when the first begins; 2 where there is none
};
