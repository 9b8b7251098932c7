#pragma once

#include "contexts/gl_context.h"
#include "frame/frame_renderer.h"
#include "gl/debug_log.h"

namespace timeshade {

/// The one OpenGL context of a test program: EGL, or what TIMESHADE_TEST_CONTEXT names ("egl", "osmesa"). It is made
/// before the first test and is current throughout. A test during which the driver reports an error or a warning
/// fails with the driver's message. A program that links timeshade_gl_test_support gets all this, and its main(), by
/// linking.
GlContext& sharedContext();

/// Hooked into that context. A test that provokes the driver on purpose clears it before its end.
gl::DebugLog& sharedDebugLog();

/// One renderer on that context for all tests of the program, so that programs are compiled once; made at the first
/// call. Every frame is drawn from its plan alone, so what a test before has drawn makes no difference.
FrameRenderer& sharedRenderer();

}  // namespace timeshade
