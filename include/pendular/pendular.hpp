// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Everything, for the impatient. Library headers never include this one.
#include <pendular/boundary/cylinder.hpp>
#include <pendular/boundary/servo_stress.hpp>
#include <pendular/boundary/turning.hpp>
#include <pendular/law/all.hpp>
#include <pendular/law/check.hpp>
#include <pendular/liquid/check.hpp>
#include <pendular/liquid/protocol/all.hpp>
#include <pendular/liquid/source/all.hpp>
#include <pendular/motion/check.hpp>
#include <pendular/observe/bytes.hpp>
#include <pendular/observe/coordination.hpp>
#include <pendular/observe/coulomb_fit.hpp>
#include <pendular/observe/energy.hpp>
#include <pendular/observe/exponential_decay.hpp>
#include <pendular/observe/fabric.hpp>
#include <pendular/observe/force_distribution.hpp>
#include <pendular/observe/grain_pressures.hpp>
#include <pendular/observe/pair_signs.hpp>
#include <pendular/observe/pairs.hpp>
#include <pendular/observe/probability_density.hpp>
#include <pendular/observe/solid_fraction.hpp>
#include <pendular/observe/stress.hpp>
#include <pendular/parts.hpp>
#include <pendular/scene/cohesive_sample.hpp>
#include <pendular/scene/direct_shear.hpp>
#include <pendular/scene/simple_compression.hpp>
#include <pendular/space/check.hpp>
#include <pendular/system.hpp>
#include <pendular/version.hpp>
