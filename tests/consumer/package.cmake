# SPDX-License-Identifier: BSD-3-Clause
# Installs pendular, looks at what is installed, and builds small projects that find it, vendor it, or both.
#   pendular, build, compiler, generator
cmake_minimum_required(VERSION 3.24)
unset(ENV{CXXFLAGS})
unset(ENV{CMAKE_PREFIX_PATH})
unset(ENV{pendular_DIR})

function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE status)
  if(status)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(configure source folder)
  run("${CMAKE_COMMAND}" -S "${source}" -B "${folder}" -G "${generator}" -D "CMAKE_CXX_COMPILER=${compiler}" ${ARGN})
  if(output MATCHES "CMake [A-Za-z ]*[Ww]arning")
    message(FATAL_ERROR "a warning at configuration:\n${output}")
  endif()
endfunction()

# A small project of this folder is configured, built and run.
function(consume project name)
  set(folder "${build}/${name}")
  configure("${CMAKE_CURRENT_LIST_DIR}/${project}" "${folder}" -D CMAKE_BUILD_TYPE=None ${ARGN})
  run("${CMAKE_COMMAND}" --build "${folder}")
  run("${folder}/program")
endfunction()

# Fails unless the files below two folders have the same names.
function(expect_same_files one other)
  file(GLOB_RECURSE names RELATIVE "${one}" "${one}/*")
  file(GLOB_RECURSE other_names RELATIVE "${other}" "${other}/*")
  if(NOT names STREQUAL other_names)
    list(REMOVE_ITEM names ${other_names})
    message(FATAL_ERROR "not the same files in ${one} and ${other}; only in the first: ${names}")
  endif()
endfunction()

file(REMOVE_RECURSE "${build}")

# Installed without building, and moved -------------------------------------------------------------------------------

configure("${pendular}" "${build}/package" -D PENDULAR_BUILD_TESTS=OFF -D PENDULAR_BUILD_EXAMPLES=OFF)
run("${CMAKE_COMMAND}" --install "${build}/package" --prefix "${build}/first place")
set(prefix "${build}/second place")
file(RENAME "${build}/first place" "${prefix}")

expect_same_files("${pendular}/include" "${prefix}/include")
file(GLOB_RECURSE rest RELATIVE "${prefix}" "${prefix}/*")
list(FILTER rest EXCLUDE REGEX "^include/")
set(package share/cmake/pendular/pendular)
set(expected ${package}-config-version.cmake ${package}-config.cmake ${package}-targets.cmake share/doc/pendular/LICENSE)
if(NOT rest STREQUAL expected)
  message(FATAL_ERROR "beside the headers are installed\n${rest}\nin place of\n${expected}")
endif()
file(GLOB_RECURSE installed "${prefix}/*")
foreach(file IN LISTS installed)
  file(READ "${file}" text)
  foreach(path "${pendular}" "${build}" "${compiler}")
    string(FIND "${text}" "${path}" place)
    if(NOT place EQUAL -1)
      message(FATAL_ERROR "${file} names ${path} of the machine it was made on")
    endif()
  endforeach()
endforeach()

# Projects ------------------------------------------------------------------------------------------------------------

set(vendored "-Dpendular=${pendular}")
set(found "-DCMAKE_PREFIX_PATH=${prefix}")
consume(found found_installed ${found})
consume(found found_in_build_folder "-DCMAKE_PREFIX_PATH=${build}/package")
consume(own_targets own_targets_vendored ${vendored})
consume(own_targets own_targets_found ${found} -D way=found)
consume(twice vendored_twice ${vendored} "-Dways=folder,fetched,folder")
consume(twice found_twice ${found} "-Dways=found,found")
consume(twice vendored_then_found ${vendored} ${found} "-Dways=folder,found")
consume(twice found_then_vendored ${vendored} ${found} "-Dways=found,folder")

# Another version of pendular is taken note of ------------------------------------------------------------------------

file(COPY "${pendular}/CMakeLists.txt" "${pendular}/cmake" "${pendular}/include" DESTINATION "${build}/another")
file(READ "${build}/another/include/pendular/version.hpp" header)
string(REGEX REPLACE "(VERSION_MINOR )[0-9]+" "\\1999" header "${header}")
file(WRITE "${build}/another/include/pendular/version.hpp" "${header}")
foreach(ways folder,found found,folder)
  file(REMOVE_RECURSE "${build}/two_versions")
  run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/twice" -B "${build}/two_versions" -G "${generator}"
      -D "CMAKE_CXX_COMPILER=${compiler}" ${found} "-Dpendular=${build}/another" "-Dways=${ways}")
  string(REGEX REPLACE "[ \n]+" " " output "${output}")
  if(NOT output MATCHES "pendular [0-9.]+ is there already and is taken in place of [0-9.]+ in")
    message(FATAL_ERROR "two versions in one program, and no word:\n${output}")
  endif()
endforeach()
