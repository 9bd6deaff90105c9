# SPDX-License-Identifier: BSD-3-Clause
# The page is complete and its errors are those of the laws as they are; its times are not compared.
add_test(NAME example_05_page_is_current
  COMMAND 05_error_against_run_time --check "${PROJECT_SOURCE_DIR}/docs/explanation/accuracy.md")
