# SPDX-License-Identifier: BSD-3-Clause
# A stranger's project with pendular inside: configure, build, run, and look at what reached the stranger's compiler.
cmake_minimum_required(VERSION 3.24)
unset(ENV{CXXFLAGS})

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE "${build}")
run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${build}" -G "${generator}" -D "pendular=${pendular}"
    -D "CMAKE_CXX_COMPILER=${compiler}")
run("${CMAKE_COMMAND}" --build "${build}")
run("${build}/consumer")

file(READ "${build}/compile_commands.json" commands)
foreach(flag " -W" " -pedantic" " -O" " -g" " -m" " -f")
  if(commands MATCHES "${flag}[^ ]*")
    message(FATAL_ERROR "a flag nobody asked for:${CMAKE_MATCH_0}")
  endif()
endforeach()

execute_process(COMMAND "${CMAKE_CTEST_COMMAND}" -N --test-dir "${build}" OUTPUT_VARIABLE tests COMMAND_ERROR_IS_FATAL ANY)
if(NOT tests MATCHES "Total Tests: 0")
  message(FATAL_ERROR "tests nobody asked for:\n${tests}")
endif()
