// SPDX-License-Identifier: BSD-3-Clause
// expect 1: a liquid needs exactly one fluid, such as fluid::water()
// expect 2: a liquid takes at most one redistribution protocol
// expect 3: a liquid needs exactly one capillary law, such as capillary::richefeu{}
// expect 4: a liquid needs exactly one rupture law, such as rupture::lian{}
// expect 5: a liquid takes at most one formation rule
// expect 6: every policy of a liquid must be a fluid, a capillary, rupture or viscous bridge law, a formation rule, a protocol, a source or none
#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/law/rupture/willett.hpp>
#include <pendular/liquid/liquid.hpp>
#include <pendular/liquid/protocol/all.hpp>

using namespace pendular;

double tension_of_water() {
#if PENDULAR_MISTAKE == 1
  const liquid water{capillary::richefeu{}, rupture::lian{}};
#elif PENDULAR_MISTAKE == 2
  const liquid water{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::gravity{},
                     protocol::grain_films{}};
#elif PENDULAR_MISTAKE == 3
  const liquid water{fluid::water(), rupture::lian{}};
#elif PENDULAR_MISTAKE == 4
  const liquid water{fluid::water(), capillary::richefeu{}, rupture::lian{}, rupture::willett{}};
#elif PENDULAR_MISTAKE == 5
  const liquid water{fluid::water(), capillary::richefeu{}, rupture::lian{}, formation::at_contact{},
                     formation::within_rupture_distance{}};
#elif PENDULAR_MISTAKE == 6
  const liquid water{fluid::water(), capillary::richefeu{}, rupture::lian{}, normal::linear{1e3}};
#else
  const liquid water{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::gravity{},
                     formation::at_contact{}};
#endif
  return water.substance().surface_tension;
}
