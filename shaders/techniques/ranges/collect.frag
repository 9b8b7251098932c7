// One texel of a prism's surface: when the triangle comes or goes there, and at which distance. Drawn twice, without and
// with FILL: to count the fragments of each texel, and to put them into its list.
#include "lib/blocks.glsl"
#include "lib/cell_lists.glsl"
#include "techniques/ranges/prism_parts.glsl"

#ifdef FILL
in float prismTime;
#ifdef LIGHT_ORTHOGRAPHIC
in float prismDistance;
#endif
flat in uint prismId;
flat in uint prismPart;

#include "techniques/ranges/fragment_lists.glsl"
#endif

#ifdef FILL
// How the time changes from texel to texel. Nothing at the caps; a surface seen edge on has no slope that can be told.
uint timeSlope() {
    vec2 slope = vec2(dFdx(prismTime), dFdy(prismTime));
    bool finite = all(lessThan(abs(slope), vec2(1e4)));  // false for what is no number, too
    return packHalf2x16(prismPart == PART_SIDE && finite ? slope : vec2(0.0));
}
#endif

void main() {
    uint slot = listSlot(uint(gl_FragCoord.y) * frame.mapSize + uint(gl_FragCoord.x));
#ifdef FILL
    // At the caps the time is known; interpolating it would only round it.
    fragmentTimes[slot] = prismPart == PART_SIDE ? clamp(prismTime, 0.0, 1.0) : float(prismPart - PART_OPEN);
    fragmentIds[slot] = prismId;
    fragmentSlopes[slot] = timeSlope();
#ifdef LIGHT_ORTHOGRAPHIC
    fragmentDistances[slot] = prismDistance;
#else
    fragmentDistances[slot] = 1.0 / gl_FragCoord.w;
#endif
#endif
}
