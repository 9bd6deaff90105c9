# SPDX-License-Identifier: BSD-3-Clause
# The companion paper's sample (Richefeu et al. 2006): <packing>-<wet pairs>-w<water>/seed<k>, three seeds each.

set(folder "${PROJECT_BINARY_DIR}/companion")
set(results)
set(dense --preparation-friction 0)
set(loose --preparation-friction 0.4)
set(quiet --no-pictures --snapshots 0)

# pendular_companion(<packing> <case> <options>...): all seeds.
macro(pendular_companion packing case)
  foreach(seed 1 2 3)
    pendular_job(results "${folder}/${packing}-${case}/seed${seed}" 07_cohesive_sample --seed ${seed}
                 PACKING "${folder}/packings/${packing}${seed}" ${${packing}} ${quiet} ${ARGN})
  endforeach()
endmacro()

foreach(packing dense loose)
  foreach(seed 1 2 3)
    pendular_packing("${folder}/packings/${packing}${seed}" 07_cohesive_sample --seed ${seed} ${${packing}})
  endforeach()
  foreach(water 0.0001 0.0003 0.001 0.007 0.02)
    pendular_companion(${packing} eligible-w${water} --water-content ${water})
  endforeach()
  pendular_companion(${packing} touching-w0.007 --water-content 0.007 --widest-gap 0)
endforeach()

add_custom_target(companion_jobs DEPENDS ${results})
pendular_collected(companion companion "${folder}")
