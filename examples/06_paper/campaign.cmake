# SPDX-License-Identifier: BSD-3-Clause
# The tests of the paper: <group>/<case>/seed<k>, three seeds each.

set(folder "${PROJECT_BINARY_DIR}/paper")
set(results)
# What these settings cost in accuracy: docs/explanation/paper.md for the shear, docs/explanation/convergence.md.
set(shear_usual --friction viscous-coulomb --solid-fraction 0.57 --time-step 1.4e-5 --mass-scaling 16
                --displacement 3.3e-3 --residual-from 1)
set(compression_usual --time-step 3.2e-5 --mass-scaling 64 --relaxation 0.2 --duration 0.8)
set(quiet --no-pictures --snapshots 0)
set(own_friction --friction viscous-coulomb --time-step 1e-6 --mass-scaling 1)
set(mass_as_it_is --time-step 3.5e-6 --mass-scaling 1)
# Ways to make the shear sample: which packing, and how far it is consolidated before friction comes. The usual one is
# looser than the paper's 0.6 over the cell.
set(dense_packing shear_smooth)
set(dense --preparation-friction 0 --solid-fraction 0.6)
set(consolidated_packing shear)
set(consolidated --solid-fraction 0.6)
set(looser_packing shear)
set(looser)
set(as_deposited_packing shear)
set(as_deposited --solid-fraction 0.3)

# pendular_campaign(<test> <group> <case> <options>...): a later option overrules an earlier one.
macro(pendular_campaign test group case)
  pendular_campaign_on(${test} ${test} ${group} ${case} ${ARGN})
endmacro()

# The same on packings of another kind.
macro(pendular_campaign_on packing test group case)
  foreach(seed 1 2 3)
    pendular_job(results "${folder}/${group}/${case}/seed${seed}" ${${test}} --seed ${seed}
                 PACKING "${folder}/packings/${packing}/seed${seed}" ${${test}_usual} ${ARGN})
  endforeach()
endmacro()

foreach(seed 1 2 3)
  foreach(test shear compression)
    pendular_packing("${folder}/packings/${test}/seed${seed}" ${${test}} --seed ${seed})
  endforeach()
  pendular_packing("${folder}/packings/shear_smooth/seed${seed}" ${shear} --seed ${seed} --preparation-friction 0)
endforeach()

# Fig. 5: mass as it is, to three diameters; and the cohesion with it
foreach(water 0 0.01)
  pendular_campaign(shear true_mass w${water}_s300 --water-content ${water} ${mass_as_it_is} --displacement 5e-3 ${quiet})
  pendular_campaign(shear true_mass w${water}_s800 --water-content ${water} ${mass_as_it_is} --normal-stress 800 ${quiet})
endforeach()
# once at the paper's step
pendular_campaign(shear paper_step w0.01_s300 ${mass_as_it_is} --time-step 1e-6 ${quiet})
# how the sample is made, and the friction law; looser with Eq. 12 is in yield_loci
foreach(water 0 0.01)
  foreach(stress 300 550 800)
    foreach(density dense consolidated looser as_deposited)
      # as it was deposited single grains stand out, which a lid of 800 Pa may press by more than a tenth of their radius
      if(density STREQUAL as_deposited AND stress EQUAL 800 OR NOT density STREQUAL as_deposited AND stress EQUAL 550)
        continue()
      endif()
      pendular_campaign_on(${${density}_packing} shear choices ${density}/spring_w${water}_s${stress} ${${density}}
                           --friction coulomb-spring --water-content ${water} --normal-stress ${stress} ${quiet})
      if(NOT density STREQUAL looser)
        pendular_campaign_on(${${density}_packing} shear choices ${density}/viscous_w${water}_s${stress} ${${density}}
                             --water-content ${water} --normal-stress ${stress} ${quiet})
      endif()
    endforeach()
  endforeach()
  # Eq. 12 at twice the speed
  foreach(stress 300 800)
    pendular_campaign(shear speed v10e-3_w${water}_s${stress} --shear-speed 10e-3 --water-content ${water}
                      --normal-stress ${stress} ${quiet})
  endforeach()
endforeach()
# which pairs are wet
foreach(stress 300 800)
  pendular_campaign(shear wet_pairs touching_s${stress} --widest-gap 0 --normal-stress ${stress} ${quiet})
endforeach()
# protocols in the shear, and as many bonds as at w = 0.05 %
foreach(stress 300 800)
  foreach(protocol homogeneous gravity)
    pendular_campaign(shear protocols_in_shear ${protocol}_s${stress} --protocol ${protocol} --normal-stress ${stress}
                      ${quiet})
  endforeach()
  pendular_campaign(shear same_bonds t1.2_s${stress} --thinning 1.2 --normal-stress ${stress} ${quiet})
endforeach()
foreach(water 0.02 0.04 0.06)
  pendular_campaign(compression wet_pairs touching_w${water} --water-content ${water} --widest-gap 0 ${quiet})
endforeach()
# Eq. 12 in the compression at the paper's step
pendular_campaign(compression own_friction compression_w0.02_1e-6 ${own_friction} --relaxation 0.03 --duration 0.4
                  ${quiet})
# and at a step at which it gives the same (docs/explanation/convergence.md), to where it is clear what comes of the stress
foreach(water_and_time 0.02:2 0.04:1 0.06:1)
  string(REPLACE ":" ";" pair ${water_and_time})
  list(GET pair 0 water)
  list(GET pair 1 time)
  pendular_campaign(compression own_friction compression_w${water} --water-content ${water} ${own_friction}
                    --time-step 3.5e-6 --relaxation 0.03 --duration ${time} ${quiet})
endforeach()
# settling for long before the test
pendular_campaign(compression settled w0.02 ${own_friction} --time-step 3.5e-6 --relaxation 3 --duration 1 ${quiet})
# Fig. 6
foreach(water 0.01 0 0.0005 0.002 0.02)
  foreach(stress 300 550 800)
    pendular_campaign(shear yield_loci w${water}_s${stress} --water-content ${water} --normal-stress ${stress} ${quiet})
  endforeach()
endforeach()
# Fig. 7, and the cohesion over the number of bonds
foreach(thinning 2 4)
  foreach(stress 300 800)
    pendular_campaign(shear thinned t${thinning}_s${stress} --normal-stress ${stress} --thinning ${thinning} ${quiet})
  endforeach()
endforeach()
# Figs. 10, 11
foreach(water 0.02 0.04 0.06)
  pendular_campaign(compression axial_stress w${water} --water-content ${water} --duration 2 --snapshots 0)
endforeach()
# Fig. 12
foreach(water 0.02 0.04 0.06)
  foreach(protocol grain-films gravity)
    pendular_campaign(compression protocols ${protocol}_w${water} --water-content ${water} --protocol ${protocol}
             ${quiet})
  endforeach()
endforeach()
# these hardly bear their own weight and take longer to come to rest
foreach(water 0.02 0.04)
  pendular_campaign(compression half_bonds w${water} --water-content ${water} --thinning 2 --relaxation 1 --duration 1.2
                    ${quiet})
endforeach()
pendular_campaign(compression not_relaxed w0.02 --relaxation 0 ${quiet})
pendular_campaign(compression not_relaxed half_bonds_w0.02 --relaxation 0 --thinning 2 --duration 1.2 ${quiet})
# Cohesion over grain size, in samples of 2000: stiffness, step and displacement go with the size; friction comes at a solid
# fraction that all of them reach. With the spring, as Eq. 12 has a rate that would change with the size.
foreach(scale_stiffness_step_displacement 0.5:1375:6.6e-6:1.65e-3 1:2750:1.32e-5:3.3e-3 2:5500:2.64e-5:6.6e-3)
  string(REPLACE ":" ";" parts ${scale_stiffness_step_displacement})
  list(GET parts 0 scale)
  list(GET parts 1 stiffness)
  list(GET parts 2 step)
  list(GET parts 3 displacement)
  set(of_size ${shear_usual} --grains 2000 --scale ${scale} --stiffness ${stiffness} --time-step ${step}
              --displacement ${displacement} --friction coulomb-spring --preparation-friction 0 --solid-fraction 0.59)
  foreach(seed 1 2 3)
    set(packing "${folder}/packings/grain_size/x${scale}/seed${seed}")
    pendular_packing("${packing}" ${shear} ${of_size} --seed ${seed})
    foreach(water 0 0.01)
      foreach(stress 300 550 800)
        pendular_job(results "${folder}/grain_size/x${scale}_w${water}_s${stress}/seed${seed}" ${shear} --seed ${seed}
                     PACKING "${packing}" ${of_size} ${quiet} --water-content ${water} --normal-stress ${stress})
      endforeach()
    endforeach()
  endforeach()
endforeach()

add_custom_target(paper_jobs DEPENDS ${results})
pendular_collected(paper paper "${folder}")
