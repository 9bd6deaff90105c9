# SPDX-License-Identifier: BSD-3-Clause
# Jobs as files of the build: each has a folder with its summary.json. What is there is not run again; what was stopped goes
# on from its checkpoint; what has other options than last time is run anew, once its folder is removed.

set(shear 04_direct_shear)
set(compression 03_simple_compression)

# pendular_job(<list> <folder> <program> [PACKING <folder>] <options>...): appends the job's result to <list>.
function(pendular_job list folder program)
  cmake_parse_arguments(PARSE_ARGV 3 job "" "PACKING" "")
  set(options ${job_UNPARSED_ARGUMENTS})
  set(result "${folder}/summary.json")
  if(job_PACKING)
    list(APPEND options --packing "${job_PACKING}/packing.bin")
    set(needs "${job_PACKING}/packing.bin")
  endif()
  add_custom_command(OUTPUT "${result}"
    COMMAND ${program} "${folder}" --threads 1 --continue ${options}
    DEPENDS ${needs} COMMENT "${folder}" VERBATIM)
  set(${list} ${${list}} "${result}" PARENT_SCOPE)
endfunction()

function(pendular_packing folder program)
  add_custom_command(OUTPUT "${folder}/packing.bin"
    COMMAND ${program} "${folder}" --threads 1 --continue --packing-only ${ARGN}
    COMMENT "${folder}" VERBATIM)
endfunction()

# pendular_collected(<target> <what> <folder>): the jobs' figures and tables.
function(pendular_collected target what folder)
  add_custom_target(${target} COMMAND 06_paper ${what} "${folder}" USES_TERMINAL VERBATIM)
  add_dependencies(${target} ${what}_jobs)
endfunction()
