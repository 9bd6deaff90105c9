# SPDX-License-Identifier: BSD-3-Clause

# pendular_add_test(<name> SOURCES <file>... [OPENMP] [LABELS <label>...] [TIMEOUT <seconds>])
function(pendular_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "OPENMP" "TIMEOUT" "SOURCES;LABELS")
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 600)
    if(CMAKE_BUILD_TYPE STREQUAL "Debug")
      set(arg_TIMEOUT 2400)  # sanitizers take their time
    endif()
  endif()
  add_executable(test_${name} ${arg_SOURCES})
  target_include_directories(test_${name} PRIVATE "${PROJECT_SOURCE_DIR}/tests")
  target_link_libraries(test_${name} PRIVATE pendular::pendular pendular_developer pendular_catch2)
  add_test(NAME ${name} COMMAND test_${name} ${PENDULAR_TEST_FILTER})
  set_tests_properties(${name} PROPERTIES TIMEOUT ${arg_TIMEOUT} LABELS "${arg_LABELS}")
  if(arg_OPENMP)
    # Small scenes open a parallel region every few microseconds: where another program holds a core, each costs a time
    # slice. Tests that are about threads ask for their own number.
    target_link_libraries(test_${name} PRIVATE $<TARGET_NAME_IF_EXISTS:OpenMP::OpenMP_CXX>)
    set_tests_properties(${name} PROPERTIES ENVIRONMENT "OMP_NUM_THREADS=1;OMP_WAIT_POLICY=passive")
  endif()
endfunction()

# One program from all sources of tests/<room>; a room without sources has no program.
function(pendular_add_room room)
  file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${room}/*.cpp")
  if(sources)
    pendular_add_test(${room} SOURCES ${sources} LABELS ${room} ${ARGN})
  endif()
endfunction()

# must_not_compile.<file>: see must_not_compile.cmake.
function(pendular_add_must_not_compile source)
  cmake_path(GET source STEM stem)
  set(name must_not_compile.${stem})
  add_test(NAME ${name}
    COMMAND ${CMAKE_COMMAND}
      -D "source=${source}"
      -D "compiler=${CMAKE_CXX_COMPILER}"
      -D "compiler_id=${CMAKE_CXX_COMPILER_ID}"
      -D "standard=${CMAKE_CXX20_STANDARD_COMPILE_OPTION}"
      -D "own=${include_dir}"
      -D "system=$<TARGET_PROPERTY:pendular,INTERFACE_INCLUDE_DIRECTORIES>"
      -D "implicit=${CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES}"
      -P "${PROJECT_SOURCE_DIR}/tests/tools/must_not_compile.cmake")
  set_tests_properties(${name} PROPERTIES LABELS must_not_compile TIMEOUT 240)
endfunction()
