// Numbers of work groups and invocations over all rows and pieces of a dispatch (renderer/gl/dispatch.h), from 0. There
// may be more than were asked for. To be included after the local size.

uniform uvec2 dispatchedGroups;  // before this piece, and in all

uint groupIndex() { return dispatchedGroups.x + gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }
uint groupCount() { return dispatchedGroups.y; }
uint invocationIndex() { return groupIndex() * gl_WorkGroupSize.x + gl_LocalInvocationID.x; }

/// Of an invocation where groups lie in rows over so many texels. Beyond them where there are more invocations.
ivec2 placeInRows(ivec2 size) {
    uint columns = (uint(size.x) + gl_WorkGroupSize.x - 1u) / gl_WorkGroupSize.x;
    uvec2 group = uvec2(groupIndex() % columns, groupIndex() / columns);
    return ivec2(group * gl_WorkGroupSize.xy + gl_LocalInvocationID.xy);
}
