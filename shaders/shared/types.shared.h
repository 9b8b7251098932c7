// The common ground of C++ and GLSL for files named *.shared.h: they are compiled as both, from this one text.
// Allowed there: scalars, vec*, mat4 in structs (std140 without holes), constants as #define, functions marked
// SHARED_FUNCTION. Not allowed: vec3, bool or arrays in structs that are uploaded.
#ifdef __cplusplus
#pragma once
#include <cmath>
#include <glm/glm.hpp>
#define SHARED_FUNCTION inline
#define SHARED_BEGIN              \
    namespace timeshade::shared { \
    using namespace glm;
#define SHARED_END }
#define SHARED_FLOAT(x) x##f
#define SHARED_PRECISE  // the C++ side is compiled without contraction as a whole
#else
#define SHARED_FUNCTION
#define SHARED_BEGIN
#define SHARED_END
#define SHARED_FLOAT(x) x
#define SHARED_PRECISE precise
#endif
