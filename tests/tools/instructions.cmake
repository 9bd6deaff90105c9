# SPDX-License-Identifier: BSD-3-Clause
# Instructions per grain and step under valgrind against committed numbers:
#   program, build     what is measured and the name of its build in the file of numbers
#   numbers            lines of `<build> <scene> <number>`; with `record` true they are printed and not compared
#   compiler           what compiled the program, `<id> <major version>`; the first line of the file names the one counted with
#   folder             for the packing
cmake_minimum_required(VERSION 3.24)

find_program(valgrind valgrind)
if(NOT valgrind)
  message(STATUS "skipped: valgrind is not installed")
  return()
endif()
file(STRINGS "${numbers}" lines)
list(POP_FRONT lines counted_with)
if(NOT counted_with STREQUAL "# ${compiler}" AND NOT record)
  message(STATUS "skipped: the numbers are those of ${counted_with}, this is ${compiler}")
  return()
endif()

file(MAKE_DIRECTORY "${folder}")
set(packing "${folder}/packing_1000.bin")
execute_process(COMMAND "${program}" make "${packing}" COMMAND_ERROR_IS_FATAL ANY)
set(failures "")
set(recorded "")
foreach(scene wet wet_spring wet_willett dry smooth)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env OMP_NUM_THREADS=1 "${valgrind}" --tool=callgrind "--toggle-collect=*counted*"
            "--callgrind-out-file=${folder}/callgrind.out" "${program}" run "${packing}" ${scene}
    RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE counts)
  if(NOT status EQUAL 0 OR NOT counts MATCHES "Collected : ([0-9]+)")
    message(FATAL_ERROR "valgrind ended with ${status}\n${counts}")
  endif()
  set(instructions ${CMAKE_MATCH_1})
  string(REGEX REPLACE ".*grain steps ([0-9]+).*" "\\1" grain_steps "${text}")
  math(EXPR found "(${instructions} + ${grain_steps} / 2) / ${grain_steps}")
  if(record)
    string(APPEND recorded "${build} ${scene} ${found}\n")
    continue()
  endif()
  set(expected ${lines})
  list(FILTER expected INCLUDE REGEX "^${build} ${scene} ")
  string(REGEX REPLACE ".* " "" expected "${expected}")
  if(NOT expected)
    message(FATAL_ERROR "${numbers} has no line `${build} ${scene} <number>`; counted: ${found}")
  endif()
  math(EXPR difference "(${found} - ${expected}) * 100")
  math(EXPR granted "${expected} * 5")
  message(STATUS "${build} ${scene}: ${found} instructions per grain and step, ${expected} expected")
  if(difference GREATER granted OR difference LESS -${granted})
    string(APPEND failures "${build} ${scene}: ${found} instructions per grain and step, not within 5 % of ${expected}\n")
  endif()
endforeach()
if(record)
  message("${recorded}")
elseif(failures)
  message(FATAL_ERROR "${failures}If that is meant, change ${numbers}")
endif()
