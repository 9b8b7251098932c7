# Read by cpack for each kind of package.
if(CPACK_GENERATOR STREQUAL DEB)
  set(CPACK_COMPONENTS_ALL program)  # its libraries are dependencies
else()
  set(CPACK_COMPONENTS_ALL program libraries)
endif()
