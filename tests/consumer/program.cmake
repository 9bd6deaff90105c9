# SPDX-License-Identifier: BSD-3-Clause
# The program of each small project, at the version that CMake knows.
get_target_property(version pendular::pendular PENDULAR_VERSION)
string(REPLACE "." ";" numbers "${version}")
list(GET numbers 0 major)
list(GET numbers 1 minor)
list(GET numbers 2 patch)

add_executable(program "${CMAKE_CURRENT_LIST_DIR}/program.cpp")
target_link_libraries(program PRIVATE pendular::pendular)
target_compile_definitions(program PRIVATE VERSION_OF_CMAKE_MAJOR=${major} VERSION_OF_CMAKE_MINOR=${minor}
                                           VERSION_OF_CMAKE_PATCH=${patch})
