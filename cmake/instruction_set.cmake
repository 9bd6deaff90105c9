# SPDX-License-Identifier: BSD-3-Clause
# Says at configuration which registers lanes will have, and what a build without optimisation or for old machines costs.
# Options of single targets are not seen.

# Whether the compiler, with the flags of this build, defines a macro.
function(pendular_defines macro result)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  separate_arguments(flags NATIVE_COMMAND "${CMAKE_CXX_COMPILER_ARG1} ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}}")
  get_directory_property(options COMPILE_OPTIONS)
  list(FILTER options EXCLUDE REGEX "\\$<")
  set(source "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/pendular_instruction_set.cpp")
  file(WRITE "${source}" "#ifndef ${macro}\n#error no\n#endif\n")
  execute_process(COMMAND "${CMAKE_CXX_COMPILER}" ${flags} ${options} -fsyntax-only "${source}"
                  RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
  if(status EQUAL 0)
    set(${result} ON PARENT_SCOPE)
  else()
    set(${result} OFF PARENT_SCOPE)
  endif()
endfunction()

function(pendular_report_instruction_set)
  if(CMAKE_CONFIGURATION_TYPES)
    return()  # which of them is built is not known yet
  endif()
  pendular_defines(__OPTIMIZE__ optimised)
  pendular_defines(__AVX512F__ avx512)
  pendular_defines(__AVX__ avx)
  if(NOT optimised)
    set(line "without optimisation, which takes some hundred times as long: set CMAKE_BUILD_TYPE to Release")
  elseif(avx512)
    set(line "with AVX-512")
  elseif(avx)
    set(line "with AVX")
  else()
    string(CONCAT line "with registers of 16 bytes, about twice the time of AVX-512: "
                       "-march=native in CMAKE_CXX_FLAGS takes what this machine has")
  endif()
  message(STATUS "pendular is built ${line} (docs/how-to/cmake.md)")
endfunction()
