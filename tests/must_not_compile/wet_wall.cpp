// SPDX-License-Identifier: BSD-3-Clause
// expect 1: a wettable wall needs capillary, rupture and viscous bridge laws with `planes` in their validity
// expect 2: a wettable wall needs capillary, rupture and viscous bridge laws with `planes` in their validity
// expect 3: the last part of a wall is wettable{} or nothing
#include <pendular/law/capillary/bagheri.hpp>
#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/law/rupture/willett.hpp>
#include <pendular/system.hpp>

using namespace pendular;
using boundary::plane;
using boundary::wall;

std::size_t bridges_of_a_grain_on_glass() {
#if PENDULAR_MISTAKE == 1
  const liquid water{fluid::water(), capillary::richefeu{}, rupture::willett{}};  // the geometric mean of R and infinity
#elif PENDULAR_MISTAKE == 2
  const liquid water{fluid::water(), capillary::bagheri{}, rupture::lian{}};
#else
  const liquid water{fluid::water(), capillary::bagheri{}, rupture::willett{}};
#endif
#if PENDULAR_MISTAKE == 3
  const wall glass{plane{{0, 0, 0}, {0, 0, 1}}, boundary::fixed{}, none{}, 0.5};
#else
  const wall glass{plane{{0, 0, 0}, {0, 0, 1}}, boundary::fixed{}, none{}, boundary::wettable{}};
#endif
  const pendular::system s{material{normal::linear{1e3}}, water, boundary::walls{glass}, velocity_verlet{1e-6}};
  return s.bridges().count();
}
