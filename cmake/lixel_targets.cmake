# Every file of a folder belongs to its library, so that adding one is adding a file.
add_library(lixel_flags INTERFACE)
target_compile_options(lixel_flags INTERFACE -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wpedantic)
if(LIXEL_WARNINGS_ARE_ERRORS)
  target_compile_options(lixel_flags INTERFACE -Werror)
endif()
# GCC 12 sees overlaps in std::string's operator+ that are not there (GCC bug 105651).
target_compile_options(lixel_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
# Floating point as written: executors and twins must agree, so no contraction into fused multiply-adds.
target_compile_options(lixel_flags INTERFACE -ffp-contract=off)
if(LIXEL_SANITIZE)
  add_compile_options(-fsanitize=${LIXEL_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${LIXEL_SANITIZE})
endif()

# lixel_run_in_frames(target): what runs within a host's frame is optimised further than the rest, a tenth to a fifth faster.
function(lixel_run_in_frames target)
  if(NOT LIXEL_SANITIZE)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release,RelWithDebInfo>:-O3>)
  endif()
endfunction()

# lixel_library(name PUBLIC libs... PRIVATE libs... BUILD_ONLY libs... PRIVATE_HEADERS patterns...): the static library
# lixel_<name> from all .cpp below this folder, as it is built and installed. BUILD_ONLY: headers that only its sources see.
function(lixel_library name)
  cmake_parse_arguments(ARG "" "" "PUBLIC;PRIVATE;BUILD_ONLY;PRIVATE_HEADERS" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp ${CMAKE_CURRENT_SOURCE_DIR}/*.h)
  add_library(lixel_${name} STATIC ${sources})
  add_library(lixel::${name} ALIAS lixel_${name})
  target_include_directories(lixel_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  target_link_libraries(lixel_${name} PUBLIC ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  foreach(library IN LISTS ARG_BUILD_ONLY ITEMS lixel_flags)
    target_link_libraries(lixel_${name} PRIVATE $<BUILD_INTERFACE:${library}>)
  endforeach()
  target_compile_features(lixel_${name} PUBLIC cxx_std_20)
  set_target_properties(lixel_${name} PROPERTIES LINKER_LANGUAGE CXX EXPORT_NAME ${name})
  lixel_install(${name} NEEDS ${ARG_PUBLIC} ${ARG_PRIVATE} PRIVATE_HEADERS ${ARG_PRIVATE_HEADERS})
endfunction()

# lixel_test(name libs... [TOGETHER suites...]): one test program from all .cpp of tests/<name>, each of its tests known to ctest; those of
# TOGETHER as one, since they look at one run that takes long.
function(lixel_test name)
  cmake_parse_arguments(test "" "" "TOGETHER" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(${name}_test ${sources})
  target_link_libraries(${name}_test
    PRIVATE ${test_UNPARSED_ARGUMENTS} lixel_test_support lixel_flags GTest::gtest GTest::gtest_main)
  set(properties LABELS ${name})
  if(name STREQUAL "gl" OR name STREQUAL "apps")
    list(APPEND properties RESOURCE_LOCK graphics COST 1000) # first: one at a time, beside the others
  endif()
  set(apart)
  foreach(suite IN LISTS test_TOGETHER)
    add_test(NAME ${suite} COMMAND ${name}_test --gtest_filter=${suite}.*)
    set_tests_properties(${suite} PROPERTIES ${properties})
    list(APPEND apart ${suite}.*)
  endforeach()
  list(JOIN apart ":" apart)
  gtest_discover_tests(${name}_test DISCOVERY_TIMEOUT 60 DISCOVERY_MODE PRE_TEST TEST_FILTER "*-${apart}"
    PROPERTIES ${properties})
endfunction()
