# SPDX-License-Identifier: BSD-3-Clause
# Fails unless the bridge breaks on the way.
add_test(NAME example_02_my_capillary_law COMMAND 02_my_capillary_law)
