# SPDX-License-Identifier: BSD-3-Clause
set(smoke "${PROJECT_BINARY_DIR}/smoke/simple_compression")
set(resume "${CMAKE_COMMAND}" "-Dprogram=$<TARGET_FILE:03_simple_compression>" "-Dfolder=${smoke}")
add_test(NAME example_03_resume COMMAND ${resume} -P "${folder}/resume_test.cmake")
add_test(NAME example_03_bad_input COMMAND ${resume} -P "${folder}/bad_input_test.cmake")
set_tests_properties(example_03_resume PROPERTIES TIMEOUT 300 PROCESSORS 2)
