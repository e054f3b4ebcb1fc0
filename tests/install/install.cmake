# Installs BUILD to PREFIX, anew: nothing of an earlier installation stays.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${PREFIX})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX} --config ${CONFIG} OUTPUT_QUIET
  COMMAND_ERROR_IS_FATAL ANY)
