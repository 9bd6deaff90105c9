# SPDX-License-Identifier: BSD-3-Clause
# One source with mistakes in it, each of which the compiler must refuse in our words:
#
#   // expect: a sentence fragment              #ifdef PENDULAR_MISTAKE ... #endif
# or, for several mistakes in one file,
#   // expect 1: a sentence fragment            #if PENDULAR_MISTAKE == 1 ... #endif
#   // expect 2: another one                    #if PENDULAR_MISTAKE == 2 ... #endif
#
# Without the macro the file must compile; otherwise a missing semicolon would pass for a caught mistake.
cmake_minimum_required(VERSION 3.24)
set(ENV{LC_ALL} C.UTF-8)

# The caret view would echo the source, and with it the expectation itself.
if(compiler_id MATCHES "Clang")
  set(no_echo -fno-caret-diagnostics)
else()
  set(no_echo -fno-diagnostics-show-caret)
endif()

set(includes -I "${own}")
list(REMOVE_ITEM system "${own}" ${implicit})
foreach(folder IN LISTS system)
  list(APPEND includes -isystem "${folder}")
endforeach()

function(compile result output)
  execute_process(
    COMMAND "${compiler}" ${standard} -fsyntax-only -fmessage-length=0 ${no_echo} ${includes} ${ARGN} "${source}"
    RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
  set(${result} "${status}" PARENT_SCOPE)
  set(${output} "${text}" PARENT_SCOPE)
endfunction()

function(first_lines text count result)
  set(head "")
  foreach(line RANGE 1 ${count})
    string(FIND "${text}" "\n" end)
    if(end EQUAL -1)
      break()
    endif()
    math(EXPR end "${end} + 1")
    string(SUBSTRING "${text}" 0 ${end} line_text)
    string(SUBSTRING "${text}" ${end} -1 text)
    string(APPEND head "${line_text}")
  endforeach()
  set(${result} "${head}" PARENT_SCOPE)
endfunction()

function(check_twin)
  compile(status output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "the twin without the mistake does not compile\n${output}")
  endif()
endfunction()

function(check_mistake number sentence)
  compile(status output "-DPENDULAR_MISTAKE=${number}")
  if(status EQUAL 0)
    message(FATAL_ERROR "mistake ${number} compiles")
  endif()
  first_lines("${output}" 40 head)
  string(FIND "${head}" "${sentence}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "mistake ${number} is refused, but not in the words \"${sentence}\"; instead:\n${head}")
  endif()
endfunction()

function(check_every_mistake_is_expected code numbers)
  string(REGEX MATCHALL "PENDULAR_MISTAKE *== *[0-9]+" uses "${code}")
  list(TRANSFORM uses REPLACE ".*== *" "")
  foreach(use IN LISTS uses)
    if(NOT use IN_LIST numbers)
      message(FATAL_ERROR "mistake ${use} has no line \"// expect ${use}: ...\"")
    endif()
  endforeach()
endfunction()

file(READ "${source}" code)
file(STRINGS "${source}" expectations REGEX "^ *// expect( [0-9]+)?: ")
if(NOT expectations)
  message(FATAL_ERROR "no line \"// expect: ...\" in ${source}")
endif()

check_twin()
# An interval such as [0, 1) would glue the elements of a CMake list together.
string(REPLACE "[" "<bracket>" expectations "${expectations}")
set(numbers "")
foreach(expectation IN LISTS expectations)
  string(REGEX MATCH "^ *// expect ?([0-9]*): +(.*[^ ]) *$" matched "${expectation}")
  set(number "${CMAKE_MATCH_1}")
  string(REPLACE "<bracket>" "[" sentence "${CMAKE_MATCH_2}")
  if(number STREQUAL "")
    set(number 1)
  endif()
  check_mistake(${number} "${sentence}")
  list(APPEND numbers ${number})
endforeach()
check_every_mistake_is_expected("${code}" "${numbers}")
