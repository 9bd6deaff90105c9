# SPDX-License-Identifier: BSD-3-Clause
# Many grains and few steps: long enough to be killed, and with less to wait for where threads share a busy core.
set(job --grains 450 --unbalanced-force 0.03 --relaxation 0.015 --checkpoint-interval 1000 --snapshots 2 --no-pictures)
pendular_add_job_tests(07_cohesive_sample "${job}"
                       "relaxation.csv;forces.csv;pressures.csv;classes.csv;packing.bin;grains_0001.vtp;bonds_0001.vtp"
                       --continue)
