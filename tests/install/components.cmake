# find_package(lixel COMPONENTS ...) finds what is there, looks for nothing else, and says in one line what is not.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})
file(WRITE ${WORK}/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)
project(host LANGUAGES CXX)
find_package(lixel \${ASKED} REQUIRED)
get_directory_property(targets IMPORTED_TARGETS)
message(STATUS \"targets: \${targets}.\")
if(NOT EXISTS \${lixel_GLSL_DIR}/lixel_lookup.glsl)
  message(FATAL_ERROR \"no lixel_lookup.glsl\")
endif()
")

# expect(asked pattern): what configuring a host that asks so prints.
function(expect asked pattern)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${WORK} -B ${WORK}/build --fresh -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${PREFIX}
    -DCMAKE_CXX_COMPILER=${COMPILER} "-DASKED=${asked}" OUTPUT_VARIABLE printed ERROR_VARIABLE printed)
  string(REGEX REPLACE "[ \n]+" " " printed "${printed}")
  if(NOT printed MATCHES "${pattern}")
    message(FATAL_ERROR "asked for ${asked}, \"${pattern}\" is not in:\n${printed}")
  endif()
endfunction()

expect("0.1;COMPONENTS;plan" "targets: lixel::base;lixel::shared;lixel::plan\\.")
expect("0.1;COMPONENTS;shared" "targets: lixel::shared\\.")
expect("0.1" "lixel::plan")
expect("0.1;COMPONENTS;plan;window" "There is no component \"window\" in this installation, which has base, ")
expect("0.2;COMPONENTS;plan" "not accepted")
expect("1.0;COMPONENTS;plan" "not accepted")
