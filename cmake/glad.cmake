# The OpenGL loader is generated at configure time from the registry that python3-glad ships; nothing is downloaded.
set(GLAD_DIRECTORY ${PROJECT_BINARY_DIR}/glad)
set(GLAD_SOURCE ${GLAD_DIRECTORY}/src/gl.c)
# Debian's generator needs Debian's interpreter, whatever other python3 comes first on PATH.
find_program(GLAD_PYTHON NAMES python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)
find_program(GLAD_COMMAND NAMES glad PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)
if(NOT EXISTS ${GLAD_SOURCE})
  execute_process(
    COMMAND ${GLAD_PYTHON} ${GLAD_COMMAND} --reproducible --api gl:core=4.5 --extensions ""
            --out-path ${GLAD_DIRECTORY} c
    RESULT_VARIABLE glad_result OUTPUT_VARIABLE glad_output ERROR_VARIABLE glad_output)
  if(NOT glad_result EQUAL 0)
    message(FATAL_ERROR "glad could not generate the OpenGL 4.5 loader: ${glad_output}")
  endif()
endif()
add_library(glad STATIC ${GLAD_SOURCE})
target_include_directories(glad SYSTEM PUBLIC ${GLAD_DIRECTORY}/include)
target_link_libraries(glad PUBLIC ${CMAKE_DL_LIBS})
