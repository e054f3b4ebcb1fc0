# The bunny of the built-in scenes is not part of the project: it is taken from Debian's glmark2-data while building.
set(LIXEL_BUNNY /usr/share/glmark2/models/bunny.obj CACHE FILEPATH "The Stanford bunny as glmark2 has it")
if(NOT EXISTS ${LIXEL_BUNNY})
  message(FATAL_ERROR "The built-in scenes need ${LIXEL_BUNNY}: install the package glmark2-data, or set LIXEL_BUNNY.")
endif()
find_package(meshoptimizer REQUIRED)

add_executable(convert_bunny ${PROJECT_SOURCE_DIR}/tools/convert_bunny.cpp)
target_link_libraries(convert_bunny PRIVATE meshoptimizer::meshoptimizer lixel_flags)
set(bunny_mesh ${CMAKE_CURRENT_BINARY_DIR}/generated/bunny_mesh.inc)
file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/generated)
add_custom_command(OUTPUT ${bunny_mesh}
  COMMAND convert_bunny ${LIXEL_BUNNY} 9000 ${bunny_mesh}
  DEPENDS convert_bunny ${LIXEL_BUNNY}
  COMMENT "Converting the bunny" VERBATIM)
target_sources(lixel_scene PRIVATE ${bunny_mesh})
target_include_directories(lixel_scene PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/generated)
