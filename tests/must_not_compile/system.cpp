// SPDX-License-Identifier: BSD-3-Clause
// expect 1: a system needs an integrator as its last policy, such as velocity_verlet{1e-6}
// expect 2: an energy balance needs energy_book{} in the material
// expect 3: a system needs its walls between material or liquid and integrator, such as boundary::walls{}
// expect 4: a wall with friction needs grains with friction
// expect 5: a wall with friction::viscous_coulomb needs grains with it too
// expect 6: an observer is called with `const system&`, or has a `notice(const bridge_event&)`, or both
// expect 7: a system is made of a material, a liquid (or nothing), a boundary such as boundary::walls{} and an integrator
// expect 8: a system is made of a material, a liquid (or nothing), a boundary such as boundary::walls{} and an integrator
#include <pendular/boundary/cylinder.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/friction/viscous_coulomb.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/observe/energy.hpp>
#include <pendular/system.hpp>

using namespace pendular;

struct explicit_euler {
  double time_step;
  vector gravity{0, 0, 0};
};

#if PENDULAR_MISTAKE == 4
const none friction_of_glass;
#else
const friction::coulomb_spring friction_of_glass{800, 0.4};
#endif

double settled_energy() {
#if PENDULAR_MISTAKE == 1
  const explicit_euler integrator{1e-6};
#else
  const velocity_verlet integrator{1e-6};
#endif
#if PENDULAR_MISTAKE == 2
  const material glass{normal::linear{1e3}, damping::viscous{0.8}};
#else
  const material glass{normal::linear{1e3}, damping::viscous{0.8}, friction_of_glass, energy_book{}};
#endif
  const boundary::plane ground{{0, 0, 0}, {0, 0, 1}};
#if PENDULAR_MISTAKE == 3
  const boundary::wall walls{ground};
#elif PENDULAR_MISTAKE == 4
  const material rough{normal::linear{1e3}, friction::coulomb_spring{800, 0.4}};
  const boundary::walls walls{boundary::wall{ground, boundary::fixed{}, rough}};
#elif PENDULAR_MISTAKE == 5
  const material rough{normal::linear{1e3}, friction::viscous_coulomb{1, 0.4}};
  const boundary::walls walls{boundary::wall{ground, boundary::fixed{}, rough}};
#else
  const boundary::walls walls{boundary::wall{ground}};
#endif
#if PENDULAR_MISTAKE == 7
  pendular::system scene{glass, integrator};
#elif PENDULAR_MISTAKE == 8
  pendular::system scene{glass, walls, none{}, integrator};
#else
  pendular::system scene{glass, walls, integrator};
#endif
  scene.add({{0, 0, 1e-3}, 1e-3, 2600});
#if PENDULAR_MISTAKE == 6
  scene.run(10, [](const bridge_event&) {});
#else
  scene.run(10, [](const auto& s) { (void)s.time(); });
#endif
  return observe::energies_of(scene).balance();
}
