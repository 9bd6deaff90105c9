# SPDX-License-Identifier: BSD-3-Clause
add_test(NAME example_01 COMMAND 01_two_grains "${PROJECT_BINARY_DIR}/smoke/two_grains")
