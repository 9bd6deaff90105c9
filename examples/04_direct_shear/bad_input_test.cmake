# SPDX-License-Identifier: BSD-3-Clause
include("${CMAKE_CURRENT_LIST_DIR}/../common/expect_complaint.cmake")

file(REMOVE_RECURSE "${folder}/bad")
expect_complaint("--normalstress" --normalstress 300)
expect_complaint("--normal-stress" --normal-stress 0)
expect_complaint("--shear-speed" --shear-speed nan)
expect_complaint("--water-content" --water-content -0.02)
expect_complaint("--solid-fraction" --solid-fraction 0.9)
expect_complaint("--law willett" --law willett --friction viscous-coulomb)
expect_complaint("displacement.*less than the radius" --displacement 0.05 --grains 150)
expect_complaint("overlap over the diameter" --stiffness 100 --grains 150)
expect_complaint("--residual-from is 2.*at most 0.9" --displacement 1e-3)
expect_complaint("checkpoint" --resume)
