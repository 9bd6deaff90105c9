# SPDX-License-Identifier: BSD-3-Clause
# A job killed without warning and resumed ends with the same bits as one that was left alone.
# Told: program, folder, job (its options, ; between them), files to compare and how to go on: --resume or --continue.
file(REMOVE_RECURSE "${folder}/whole" "${folder}/killed")
file(MAKE_DIRECTORY "${folder}/killed")

string(TIMESTAMP begun "%s")
execute_process(COMMAND "${program}" "${folder}/whole" ${job} --threads 1 RESULT_VARIABLE code ERROR_VARIABLE said OUTPUT_QUIET)
string(TIMESTAMP ended "%s")
if(NOT code EQUAL 0)
  message(FATAL_ERROR "the job failed: ${said}")
endif()

# Killed about eight times in the time of the whole job, in whatever stage that is, until it ends by itself; a machine that
# has become slower meanwhile gets longer each time.
math(EXPR first "1 + (${ended} - ${begun}) / 8")
set(resume "")
if(again STREQUAL "--continue")
  set(resume --continue)  # from the first start on
endif()
set(resumed OFF)
set(kills 0)
foreach(attempt RANGE 1 60)
  math(EXPR seconds "${first} + ${kills} / 3")
  execute_process(COMMAND timeout -s KILL ${seconds} "${program}" "${folder}/killed" ${job} --threads 2 ${resume}
                  RESULT_VARIABLE code ERROR_VARIABLE said OUTPUT_QUIET)
  if(code EQUAL 0)
    break()
  endif()
  if(said MATCHES "0[0-9]_[a-z_]+: ")
    message(FATAL_ERROR "stopped by itself: ${said}")
  endif()
  math(EXPR kills "${kills} + 1")
  if(EXISTS "${folder}/killed/checkpoint.bin")
    set(resume ${again})
    set(resumed ON)
  endif()
endforeach()
message(STATUS "killed ${kills} times")
if(NOT code EQUAL 0 OR kills EQUAL 0 OR NOT resumed)
  message(FATAL_ERROR "after ${kills} kills the job ended with ${code}; it must be killed, resumed and then succeed: ${said}")
endif()

foreach(name IN LISTS files)
  file(SHA256 "${folder}/whole/${name}" whole)
  file(SHA256 "${folder}/killed/${name}" killed)
  if(NOT whole STREQUAL killed)
    message(FATAL_ERROR "${name} differs between the whole and the resumed job")
  endif()
endforeach()
