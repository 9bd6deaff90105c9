# SPDX-License-Identifier: BSD-3-Clause
# What find_package(pendular) reads, in an installation or a build folder.

# The first copy is that of the whole program.
if(TARGET pendular::pendular)
  get_target_property(pendular_first pendular::pendular PENDULAR_VERSION)
  if(NOT pendular_first VERSION_EQUAL pendular_VERSION)
    message(WARNING "pendular ${pendular_first} is there already and is taken in place of ${pendular_VERSION} in "
                    "'${CMAKE_CURRENT_LIST_DIR}': bring one version")
  endif()
  unset(pendular_first)
  return()
endif()

# A project may have these as targets of its own. The CMakeLists.txt of pendular asks for the same.
include(CMakeFindDependencyMacro)
if(NOT TARGET Eigen3::Eigen)
  find_dependency(Eigen3 3.4 NO_MODULE)
endif()
if(NOT TARGET Boost::headers)
  find_dependency(Boost CONFIG)
endif()
if(NOT TARGET range-v3::range-v3)
  find_dependency(range-v3)
endif()

include("${CMAKE_CURRENT_LIST_DIR}/pendular-targets.cmake")
