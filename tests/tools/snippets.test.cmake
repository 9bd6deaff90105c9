# SPDX-License-Identifier: BSD-3-Clause

# snippets: the pages agree with the code; snippets.<case>: the check itself can fail, and for the right reason.
function(pendular_add_snippet_check name folder verdict)
  add_test(NAME ${name}
    COMMAND ${CMAKE_COMMAND} -D "project=${folder}" -P "${PROJECT_SOURCE_DIR}/tests/tools/snippets.cmake")
  set_tests_properties(${name} PROPERTIES LABELS docs PASS_REGULAR_EXPRESSION "${verdict}")
endfunction()

pendular_add_snippet_check(snippets "${PROJECT_SOURCE_DIR}" "pages agree with the code")
set(self_tests "${PROJECT_SOURCE_DIR}/tests/tools/snippets.self_test")
pendular_add_snippet_check(snippets.good "${self_tests}/good" "1 pages agree with the code")
pendular_add_snippet_check(snippets.different "${self_tests}/different" "the snippet is not region sum of tests/x.cpp")
pendular_add_snippet_check(snippets.unmarked "${self_tests}/unmarked" "a cpp block has no line")
pendular_add_snippet_check(snippets.dead_link "${self_tests}/dead_link" "the link gone.md leads nowhere")
pendular_add_snippet_check(snippets.dead_heading "${self_tests}/dead_heading" "names a heading that is not there")
pendular_add_snippet_check(snippets.dead_name "${self_tests}/dead_name" "there is no tests/y.cpp")
pendular_add_snippet_check(snippets.dead_reference "${self_tests}/dead_reference" "include/x.hpp: there is no docs/gone.md")
