# SPDX-License-Identifier: BSD-3-Clause
set(job --grains 150 --time-step 8e-6 --mass-scaling 4 --duration 0.2 --wall-speed 5e-3 --checkpoint-interval 2000 --snapshots 2 --no-pictures)
pendular_add_job_tests(03_simple_compression "${job}" "stress_strain.csv;relaxation.csv;grains_0002.vtp;bonds_0002.vtp" --resume)
