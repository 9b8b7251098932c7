#pragma once

#include <string>

namespace timeshade::gl {

// OpenGL goes on after an error: the call does nothing, and a picture that lacks a pass looks like any other. So the
// error flags are read once in every frame, in every build, and whoever makes an allocation checks that one by itself.

/// Moves errors that the driver has noted to a list kept here, so that the next check is about one call alone.
void collectErrors();

/// Names of the errors noted since the last call, "GL_INVALID_VALUE, GL_OUT_OF_MEMORY"; empty without any. Forgets
/// them.
std::string takeErrors();

/// Throws Error "WHAT: the driver reports NAMES ..." where there was any error since the last check, with the call that
/// made it where a DebugLog knows it.
void requireNoErrors(const std::string& what);

/// What the driver says of an error, for the next line of requireNoErrors. DebugLog calls it.
void noteDriverMessage(const std::string& text);

/// To be called right after an allocation, with collectErrors() before it. Throws LimitError that names what could not
/// be had, its size, and `advice`.
void requireAllocated(const std::string& label, std::size_t bytes, const std::string& advice);

/// For tests: makes an OpenGL error where the environment's TIMESHADE_TEST_GL_ERROR names this pass.
void injectErrorForTest(const std::string& pass);

}  // namespace timeshade::gl
