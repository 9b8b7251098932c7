#pragma once

#ifdef TIMESHADE_EMBREE_4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace timeshade::embree {

/// Embree 3 and 4 by the same names: packets of eight rays that lie near each other. `valid`: -1 for a ray that counts,
/// 0 for others. A filter function is called for each hit, in scenes with `filterFlag`, and gets the context, which may
/// be the first member of a structure with what it needs.
#ifdef TIMESHADE_EMBREE_4

using Context = RTCRayQueryContext;
inline constexpr RTCSceneFlags filterFlag = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS;

inline void firstHits(const int* valid, RTCScene scene, RTCRayHit8& rays, Context& context,
                      RTCFilterFunctionN filter = nullptr) {
    rtcInitRayQueryContext(&context);
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &context;
    arguments.filter = filter;
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    if (filter != nullptr)
        arguments.flags = static_cast<RTCRayQueryFlags>(arguments.flags | RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER);
    rtcIntersect8(valid, scene, &rays, &arguments);
}

inline void anyHits(const int* valid, RTCScene scene, RTCRay8& rays) {
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    rtcOccluded8(valid, scene, &rays, &arguments);
}

#else

using Context = RTCIntersectContext;
inline constexpr RTCSceneFlags filterFlag = RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;

inline void firstHits(const int* valid, RTCScene scene, RTCRayHit8& rays, Context& context,
                      RTCFilterFunctionN filter = nullptr) {
    rtcInitIntersectContext(&context);
    context.filter = filter;
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect8(valid, scene, &context, &rays);
}

inline void anyHits(const int* valid, RTCScene scene, RTCRay8& rays) {
    Context context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcOccluded8(valid, scene, &context, &rays);
}

#endif

}  // namespace timeshade::embree
