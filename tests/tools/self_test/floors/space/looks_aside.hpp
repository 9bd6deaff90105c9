// SPDX-License-Identifier: BSD-3-Clause
#include <pendular/version.hpp>
  #  include <pendular/liquid/ledger.hpp>
