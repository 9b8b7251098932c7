# Our own targets are compiled with these; third-party headers come in as SYSTEM.
add_library(timeshade_options INTERFACE)
target_compile_options(timeshade_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wold-style-cast -Wdouble-promotion
  $<$<BOOL:${TIMESHADE_WARNINGS_ARE_ERRORS}>:-Werror>
  # GCC 12 sees overlaps in std::string where there are none (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  $<$<CXX_COMPILER_ID:GNU>:${TIMESHADE_PRECOMPILED_WARNINGS}>
  # Of macros of GoogleTest that are given no further arguments.
  $<$<CXX_COMPILER_ID:Clang>:-Wno-gnu-zero-variadic-macro-arguments>
  # The shared numerics must give the same bits in C++ as in GLSL: no contraction of a*b+c into one rounding.
  -ffp-contract=off)
target_compile_definitions(timeshade_options INTERFACE
  GLM_FORCE_SILENT_WARNINGS GLM_FORCE_XYZW_ONLY
  TIMESHADE_VERSION="${PROJECT_VERSION}")
# <timeshade/paths.h> says where the sources lie. A header of its own and no flag for all, so that checkouts in several
# folders share what ccache has compiled.
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/generated/timeshade/paths.h
     CONTENT "#pragma once\n#define TIMESHADE_SOURCE_DIRECTORY \"@PROJECT_SOURCE_DIR@\"\n" @ONLY)
target_include_directories(timeshade_options INTERFACE ${PROJECT_SOURCE_DIR}/renderer ${PROJECT_SOURCE_DIR}/shaders
  ${PROJECT_BINARY_DIR}/generated)
if(TIMESHADE_SANITIZE)
  # Division of floats by zero and conversion of too large floats to integers are not part of `undefined`.
  target_compile_options(timeshade_options INTERFACE
    -fsanitize=address,undefined,float-divide-by-zero,float-cast-overflow -fno-omit-frame-pointer
    -fno-sanitize-recover=undefined,float-divide-by-zero,float-cast-overflow)
  # GCC 12 with -fsanitize=address sees std::function and std::regex use what they have just set (GCC bug 105562).
  target_compile_options(timeshade_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(timeshade_options INTERFACE -fsanitize=address,undefined)
endif()
if(TIMESHADE_FUZZ)
  # What a run has reached decides what is tried next.
  target_compile_options(timeshade_options INTERFACE -fsanitize=fuzzer-no-link)
endif()
