# SPDX-License-Identifier: BSD-3-Clause
# How far the strengths depend on what is not physics: <series>/<value>/seed<k> beside reference/<test>/seed<k>.

set(folder "${PROJECT_BINARY_DIR}/convergence")
set(results)
set(dense --preparation-friction 0 --solid-fraction 0.6)  # without a rate and from the densest deposit
set(shear_packing --preparation-friction 0)
set(compression_packing)
set(shear_usual --grains 1000 --displacement 3.3e-3 --residual-from 1 --friction coulomb-spring ${dense} --no-pictures
                --snapshots 0)
set(compression_usual --grains 1000 --duration 0.6 --no-pictures --snapshots 0)

# twice the seeds in shear, which scatters more
set(shear_seeds 16)
set(compression_seeds 8)
set(law_seeds 8)
foreach(test shear compression)
  foreach(seed RANGE 1 ${${test}_seeds})
    pendular_packing("${folder}/packings/${test}/seed${seed}" ${${test}} --grains 1000 --seed ${seed}
                     ${${test}_packing})
  endforeach()
endforeach()

# pendular_study(<test> <series> <value> <number of seeds> <options>...): on the packings of the reference.
macro(pendular_study test series value seeds)
  foreach(seed RANGE 1 ${seeds})
    pendular_job(results "${folder}/${test}/${series}/${value}/seed${seed}" ${${test}} --seed ${seed}
                 PACKING "${folder}/packings/${test}/seed${seed}" ${${test}_usual} ${ARGN})
  endforeach()
endmacro()

# The same with a packing of its own.
macro(pendular_study_from_scratch test series value seeds)
  foreach(seed RANGE 1 ${seeds})
    pendular_job(results "${folder}/${test}/${series}/${value}/seed${seed}" ${${test}} --seed ${seed} ${${test}_usual}
                 ${ARGN})
  endforeach()
endmacro()

pendular_study(shear reference reference ${shear_seeds})
pendular_study(compression reference reference ${compression_seeds} --time-step 4e-6 --mass-scaling 1)

foreach(step 1e-6 2e-6)
  pendular_study(shear time_step ${step} ${shear_seeds} --time-step ${step})
endforeach()
foreach(step 1e-6 2e-6 4.8e-6)
  pendular_study(compression time_step ${step} ${compression_seeds} --time-step ${step} --mass-scaling 1)
endforeach()

# mass and step together, as sqrt(mass) is the step that stays stable
foreach(mass_and_steps 4:7e-6:8e-6 16:1.4e-5:1.6e-5 64:2.8e-5:3.2e-5 256:5.6e-5:6.4e-5)
  string(REPLACE ":" ";" parts ${mass_and_steps})
  list(GET parts 0 mass)
  list(GET parts 1 shear_step)
  list(GET parts 2 compression_step)
  pendular_study(shear mass_scaling ${mass} ${shear_seeds} --mass-scaling ${mass} --time-step ${shear_step})
  pendular_study(compression mass_scaling ${mass} ${compression_seeds} --mass-scaling ${mass} --time-step ${compression_step})
endforeach()

foreach(speed 1e-3 2.5e-3 10e-3 20e-3 50e-3)
  pendular_study(shear shear_speed ${speed} 4 --shear-speed ${speed})
endforeach()
foreach(speed_and_time 0.3e-3:2 3e-3:0.2 10e-3:0.06 30e-3:0.02)
  string(REPLACE ":" ";" pair ${speed_and_time})
  list(GET pair 0 speed)
  list(GET pair 1 time)
  pendular_study(compression wall_speed ${speed} 4 --wall-speed ${speed} --duration ${time} --time-step 4e-6 --mass-scaling 1)
endforeach()

foreach(stiffness_and_step 1000:5.5e-6 2500:3.5e-6 10000:1.75e-6 40000:8.75e-7)
  string(REPLACE ":" ";" pair ${stiffness_and_step})
  list(GET pair 0 stiffness)
  list(GET pair 1 step)
  pendular_study_from_scratch(shear stiffness ${stiffness} 4 --stiffness ${stiffness} --time-step ${step})
endforeach()
foreach(stiffness_and_step 700:4.7e-6 1000:4e-6 4000:2e-6 16000:1e-6)
  string(REPLACE ":" ";" pair ${stiffness_and_step})
  list(GET pair 0 stiffness)
  list(GET pair 1 step)
  pendular_study_from_scratch(compression stiffness ${stiffness} 4 --stiffness ${stiffness} --time-step ${step}
                     --mass-scaling 1)
endforeach()

foreach(grains 500 2000 4000)
  pendular_study_from_scratch(shear grains ${grains} 4 --grains ${grains})
  pendular_study_from_scratch(compression grains ${grains} 4 --grains ${grains} --time-step 4e-6 --mass-scaling 1)
endforeach()

foreach(skin 0.05 0.2 0.5)
  pendular_study(shear skin ${skin} 1 --skin ${skin})
  pendular_study(compression skin ${skin} 1 --skin ${skin} --time-step 4e-6 --mass-scaling 1)
endforeach()

pendular_study(shear dry dry ${law_seeds} --water-content 0)
foreach(law richefeu-harmonic willett laplace-young)
  pendular_study(shear law ${law} ${law_seeds} --law ${law})
  pendular_study(compression law ${law} ${law_seeds} --law ${law} --time-step 4e-6 --mass-scaling 1)
endforeach()

# Eq. 12: in time steps, then in gamma_t and speed
foreach(step 5e-7 1e-6 2e-6 3.5e-6)
  pendular_study(shear viscous_time_step ${step} 3 --friction viscous-coulomb --time-step ${step})
  pendular_study(compression viscous_time_step ${step} 3 --friction viscous-coulomb --time-step ${step} --mass-scaling 1)
endforeach()
foreach(viscosity 0.3 1 3 10)
  set(viscous --friction viscous-coulomb --tangential-viscosity ${viscosity} --time-step 3.5e-6)
  pendular_study(shear viscosity ${viscosity} 4 ${viscous})
  pendular_study(compression viscosity ${viscosity} 4 ${viscous} --mass-scaling 1)
endforeach()
foreach(viscosity 0.3 1 3 10)
  foreach(speed_and_time 0.3e-3:6.667 1e-3:2 3e-3:0.6667 10e-3:0.2)
    string(REPLACE ":" ";" pair ${speed_and_time})
    list(GET pair 0 speed)
    list(GET pair 1 time)
    pendular_study(compression viscosity_and_speed ${viscosity}_${speed} 3 --friction viscous-coulomb --tangential-viscosity
          ${viscosity} --wall-speed ${speed} --duration ${time} --time-step 3.5e-6 --mass-scaling 1)
  endforeach()
endforeach()

add_custom_target(convergence_jobs DEPENDS ${results})
pendular_collected(convergence convergence "${folder}")
