# The standard library's headers and those of two packages, which nearly every file includes, compiled once: a file
# takes two thirds of the time. With GCC, with which most are compiled; Clang's builds see to it that a file still names
# all that it uses.
set(gcc OFF)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  set(gcc ON)
endif()
option(TIMESHADE_PRECOMPILED "Compile common headers once" ${gcc})
if(TIMESHADE_PRECOMPILED)
  # It forgets that these are the system's, and says what it otherwise does not of std::string (GCC bug 105651 and
  # others).
  set(TIMESHADE_PRECOMPILED_WARNINGS -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
endif()
set(TIMESHADE_COMMON_HEADERS
  <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <optional> <span> <string>
  <string_view> <utility> <vector> <fmt/format.h> <glm/glm.hpp>)

# timeshade_precompile(TARGET [HEADERS...]): TARGET's files have the common headers, and these, compiled once.
function(timeshade_precompile target)
  if(TIMESHADE_PRECOMPILED)
    target_precompile_headers(${target} PRIVATE ${TIMESHADE_COMMON_HEADERS} ${ARGN})
  endif()
endfunction()

# timeshade_precompiled_as(TARGET OTHER): as OTHER, which is compiled with the same options.
function(timeshade_precompiled_as target other)
  if(TIMESHADE_PRECOMPILED)
    target_precompile_headers(${target} REUSE_FROM ${other})
  endif()
endfunction()
