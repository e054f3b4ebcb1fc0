# What `cmake --install` puts where, a component a library, so that
#
#   find_package(lixel 0.1 REQUIRED COMPONENTS plan)      gives lixel::plan and what it needs, and looks for nothing else.
#
#   include/lixel/<name>/            public headers
#   lib/liblixel_<name>.a
#   lib/cmake/lixel/                 the package: lixel-config.cmake, and for each library lixel-<name>.cmake (what it needs)
#                                    and lixel-<name>-targets.cmake
#   share/lixel/glsl/                GLSL for hosts, each a single file without #include
include(CMakePackageConfigHelpers)
set(LIXEL_INSTALL_PACKAGE ${CMAKE_INSTALL_LIBDIR}/cmake/lixel)
set(LIXEL_INSTALL_GLSL ${CMAKE_INSTALL_DATADIR}/lixel/glsl)

# lixel_install(name NEEDS libs... PRIVATE_HEADERS patterns...): the library lixel_<name>. NEEDS is what it links, by target:
# lixel_<station>, Package::Target, PkgConfig::module. What is needed to build only stands in $<BUILD_INTERFACE:...>.
function(lixel_install name)
  cmake_parse_arguments(ARG "" "" "NEEDS;PRIVATE_HEADERS" ${ARGN})
  install(TARGETS lixel_${name} EXPORT lixel_${name}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${name}
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT lixel_${name} FILE lixel-${name}-targets.cmake NAMESPACE lixel::
    DESTINATION ${LIXEL_INSTALL_PACKAGE} COMPONENT ${name})

  set(excluded)
  foreach(pattern IN LISTS ARG_PRIVATE_HEADERS)
    list(APPEND excluded PATTERN ${pattern} EXCLUDE)
  endforeach()
  # Folders without headers would be made all the same.
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/lixel/${name} COMPONENT ${name}
    FILES_MATCHING PATTERN "*.h" ${excluded} PATTERN "page" EXCLUDE PATTERN "shaders" EXCLUDE PATTERN "data" EXCLUDE)

  set(needs "")
  foreach(target IN LISTS ARG_NEEDS)
    if(target MATCHES "^lixel_(.+)$")
      string(APPEND needs "lixel_need_own(${name} ${CMAKE_MATCH_1})\n")
    elseif(target MATCHES "^PkgConfig::(.+)$")
      string(APPEND needs "lixel_need_module(${name} ${CMAKE_MATCH_1})\n")
    elseif(target STREQUAL "embree")
      string(APPEND needs "lixel_need_package(${name} embree 3)\n")
    elseif(target MATCHES "^([A-Za-z_]+)::")
      string(APPEND needs "lixel_need_package(${name} ${CMAKE_MATCH_1})\n")
    endif()
  endforeach()
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/lixel-${name}.cmake "${needs}")
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/lixel-${name}.cmake DESTINATION ${LIXEL_INSTALL_PACKAGE} COMPONENT ${name})
endfunction()

# lixel_install_glsl(component file): `file` and all it includes as share/lixel/glsl/<its name>.
function(lixel_install_glsl component file)
  get_filename_component(source ${file} ABSOLUTE)
  get_filename_component(file_name ${file} NAME)
  set(output ${PROJECT_BINARY_DIR}/glsl/${file_name})
  file(GLOB_RECURSE included CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/lixel/shared/*)
  set(script ${PROJECT_SOURCE_DIR}/cmake/single_file_glsl.cmake)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -DFILE=${source} -DOUTPUT=${output} -P ${script}
    DEPENDS ${source} ${included} ${script}
    COMMENT "Making ${file_name} one file" VERBATIM)
  string(MAKE_C_IDENTIFIER lixel_install_${file_name} target)
  add_custom_target(${target} ALL DEPENDS ${output})
  install(FILES ${output} DESTINATION ${LIXEL_INSTALL_GLSL} COMPONENT ${component})
endfunction()

# lixel_install_package(): the package's own files, when all libraries are known.
function(lixel_install_package)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/lixel-config.cmake.in ${PROJECT_BINARY_DIR}/lixel-config.cmake
    INSTALL_DESTINATION ${LIXEL_INSTALL_PACKAGE} PATH_VARS LIXEL_INSTALL_GLSL NO_CHECK_REQUIRED_COMPONENTS_MACRO)
  # While the version is 0.x, a minor version may change anything.
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/lixel-config-version.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/lixel-config.cmake ${PROJECT_BINARY_DIR}/lixel-config-version.cmake
    DESTINATION ${LIXEL_INSTALL_PACKAGE} COMPONENT base)
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT base)
endfunction()
