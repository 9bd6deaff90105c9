// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// For your own law, in any test framework: every report is a list of sentences and must be empty.
#include <pendular/testing/capillary_law.hpp>
#include <pendular/testing/damping_law.hpp>
#include <pendular/testing/friction_law.hpp>
#include <pendular/testing/mean_radius.hpp>
#include <pendular/testing/normal_law.hpp>
#include <pendular/testing/rupture_law.hpp>
#include <pendular/testing/viscous_bridge_law.hpp>
