# SPDX-License-Identifier: BSD-3-Clause
# pendular_catch2: Catch2 with its main, version 2 or 3.
find_package(Catch2 REQUIRED)

if(Catch2_VERSION VERSION_GREATER_EQUAL 3)
  add_library(pendular_catch2 INTERFACE)
  target_link_libraries(pendular_catch2 INTERFACE Catch2::Catch2WithMain)
  if(PENDULAR_TEST_FILTER)
    # Version 2 passes a program of which the filter leaves nothing; version 3 has to be told.
    list(APPEND PENDULAR_TEST_FILTER --allow-running-no-tests)
  endif()
else()
  # Catch2's main costs 17 s of compilation at -O2, 9 s at -O0.
  add_library(pendular_catch2 STATIC "${CMAKE_CURRENT_LIST_DIR}/catch_main.cpp")
  target_compile_features(pendular_catch2 PUBLIC cxx_std_20)
  target_compile_options(pendular_catch2 PRIVATE -O0 -g0)
  target_link_libraries(pendular_catch2 PUBLIC Catch2::Catch2)
endif()
