# <timeshade/commit.h> names the commit, or "unknown" outside a checkout or without git. Looked up when the project is
# configured, which is repeated after each commit, since git then appends to this log.
set(commit_log ${PROJECT_SOURCE_DIR}/.git/logs/HEAD)
if(EXISTS ${commit_log})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${commit_log})
endif()
execute_process(COMMAND git -C ${PROJECT_SOURCE_DIR} rev-parse --short=12 HEAD
                OUTPUT_VARIABLE TIMESHADE_COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET
                RESULT_VARIABLE commit_result)
if(NOT commit_result STREQUAL "0")
  set(TIMESHADE_COMMIT unknown)
endif()
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/timeshade/commit.h
     CONTENT "#pragma once\n#define TIMESHADE_COMMIT \"@TIMESHADE_COMMIT@\"\n" @ONLY)
