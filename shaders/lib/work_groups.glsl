// Numbers of work groups and invocations over all rows of a dispatch (renderer/gl/dispatch.h), from 0. There may be
// more than were asked for. To be included after the local size.

uint groupIndex() { return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }
uint groupCount() { return gl_NumWorkGroups.x * gl_NumWorkGroups.y; }
uint invocationIndex() { return groupIndex() * gl_WorkGroupSize.x + gl_LocalInvocationID.x; }
