# All installed headers compile together, from the installation alone.
cmake_minimum_required(VERSION 3.25)
file(GLOB_RECURSE headers RELATIVE ${PREFIX}/include ${PREFIX}/include/lixel/*.h)
list(TRANSFORM headers REPLACE "(.+)" "#include <\\1>\n")
string(JOIN "" text ${headers})
file(WRITE ${WORK}/headers.cpp "${text}")
execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only -Wall -Wextra -Werror -I${PREFIX}/include ${WORK}/headers.cpp
  COMMAND_ERROR_IS_FATAL ANY)
