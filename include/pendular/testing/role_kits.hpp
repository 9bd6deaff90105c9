// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// For roles of your own that are no law, in any test framework: every report is a list of sentences and must be empty.
#include <pendular/testing/boundary.hpp>
#include <pendular/testing/drive.hpp>
#include <pendular/testing/formation_rule.hpp>
#include <pendular/testing/geometry.hpp>
#include <pendular/testing/global_protocol.hpp>
#include <pendular/testing/grain_tag.hpp>
#include <pendular/testing/host.hpp>
#include <pendular/testing/integrator.hpp>
#include <pendular/testing/local_protocol.hpp>
#include <pendular/testing/observer.hpp>
#include <pendular/testing/source.hpp>
