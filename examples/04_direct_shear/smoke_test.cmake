# SPDX-License-Identifier: BSD-3-Clause
set(job --grains 150 --displacement 1e-3 --shear-speed 10e-3 --residual-from 0.3 --checkpoint-interval 5000
        --snapshots 2 --no-pictures)
pendular_add_job_tests(04_direct_shear "${job}" "shear_curve.csv;grains_0002.vtp;bonds_0002.vtp" --continue)
