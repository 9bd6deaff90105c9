# SPDX-License-Identifier: BSD-3-Clause
# Where no job has ended every figure is left out by name, and a folder that is not there gets one sentence.
set(empty "${PROJECT_BINARY_DIR}/smoke/06_paper")
file(MAKE_DIRECTORY "${empty}")
add_test(NAME example_06_without_jobs COMMAND 06_paper paper "${empty}")
set_tests_properties(example_06_without_jobs PROPERTIES
  PASS_REGULAR_EXPRESSION "fig. 12 is left out: no job has ended in .*axial_stress/w0.02")
add_test(NAME example_06_bad_input COMMAND 06_paper paper "${CMAKE_CURRENT_SOURCE_DIR}/nowhere")
set_tests_properties(example_06_bad_input PROPERTIES PASS_REGULAR_EXPRESSION "Directory does not exist.*nowhere")
