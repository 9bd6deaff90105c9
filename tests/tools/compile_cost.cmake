# SPDX-License-Identifier: BSD-3-Clause
# Compile time is speed too. What the compiler meets in each subject, beyond what it meets in the yardstick, must stay
# within a bound. Seconds would be those of a busy machine; counts are the same everywhere:
#
#   measure=lines     preprocessed lines that are not blank
#   measure=classes   classes made from templates (g++ only, which lists them)
#
# The yardstick includes what a subject may take from other libraries. So a new version of these moves both counts, and
# a subject that includes more of them than its yardstick breaks the bound.
#
#   cmake -D subjects=<files> -D yardstick=<file> -D measure=<measure> -D most=<number> ... -P compile_cost.cmake
cmake_minimum_required(VERSION 3.24)
set(ENV{LC_ALL} C.UTF-8)

set(includes -I "${own}")
list(REMOVE_ITEM system "${own}" ${implicit})
foreach(folder IN LISTS system)
  list(APPEND includes -isystem "${folder}")
endforeach()

if(measure STREQUAL "lines")
  set(how -E -P)
  set(counted "NF { ++count } END { print count + 0 }")
elseif(measure STREQUAL "classes")
  set(how -fsyntax-only -fdump-lang-class=stdout)
  set(counted "/^Class .*</ { ++count } END { print count + 0 }")
else()
  message(FATAL_ERROR "no measure \"${measure}\"")
endif()

function(count_in file result)
  execute_process(
    COMMAND "${compiler}" ${standard} -w ${how} ${includes} -x c++ "${file}"
    COMMAND awk "${counted}"
    RESULTS_VARIABLE statuses OUTPUT_VARIABLE count ERROR_VARIABLE complaint OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT statuses STREQUAL "0;0")
    message(FATAL_ERROR "${file} does not compile\n${complaint}")
  endif()
  set(${result} "${count}" PARENT_SCOPE)
endfunction()

if(NOT subjects)
  message(FATAL_ERROR "nothing to count ${measure} in")
endif()
count_in("${yardstick}" given)
set(too_much FALSE)
foreach(subject IN LISTS subjects)
  count_in("${subject}" count)
  math(EXPR beyond "${count} - ${given}")
  set(verdict "${subject}: ${count} ${measure}, ${beyond} beyond ${yardstick}, at most ${most}")
  message(NOTICE "${verdict}")
  if(beyond GREATER most)
    set(too_much TRUE)
  endif()
endforeach()
if(too_much)
  message(FATAL_ERROR "more than ${most} ${measure} beyond the yardstick")
endif()
