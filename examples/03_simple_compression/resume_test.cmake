# SPDX-License-Identifier: BSD-3-Clause
# A job killed without warning and resumed ends with the same bits as one that was left alone.
set(job --grains 150 --duration 0.05 --wall-speed 5e-3 --checkpoint-interval 5000 --snapshots 2 --no-pictures)
file(REMOVE_RECURSE "${folder}/whole" "${folder}/killed")
file(MAKE_DIRECTORY "${folder}/killed")

execute_process(COMMAND "${program}" "${folder}/whole" ${job} --threads 1 RESULT_VARIABLE code ERROR_VARIABLE said OUTPUT_QUIET)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "the job failed: ${said}")
endif()

# Killed as soon as it has written a few checkpoints, in whatever stage that is, again and again until it ends by itself.
set(resume "")
foreach(attempt RANGE 1 40)
  execute_process(COMMAND timeout -s KILL 1.1 "${program}" "${folder}/killed" ${job} --threads 2 ${resume}
                  RESULT_VARIABLE code ERROR_VARIABLE said OUTPUT_QUIET)
  if(code EQUAL 0)
    break()
  endif()
  if(EXISTS "${folder}/killed/checkpoint.bin")
    set(resume --resume)
  endif()
endforeach()
message(STATUS "ended in attempt ${attempt}")
if(NOT code EQUAL 0)
  message(FATAL_ERROR "the job never came to its end: ${said}")
endif()

foreach(name stress_strain.csv grains_0002.vtp bonds_0002.vtp)
  file(SHA256 "${folder}/whole/${name}" whole)
  file(SHA256 "${folder}/killed/${name}" killed)
  if(NOT whole STREQUAL killed)
    message(FATAL_ERROR "${name} differs between the whole and the resumed job")
  endif()
endforeach()
