// SPDX-License-Identifier: BSD-3-Clause
// The program of docs/how-to/stability.md.
#include <pendular/pendular.hpp>

#include <cstdio>
#include <cstdlib>
#include <string>

using namespace pendular;

auto stack(double time_step, run_options options = {}) {
  const material m{normal::linear{1e3}, damping::viscous{0.8}, friction::viscous_coulomb_explicit{1.0, 0.4}};
  const liquid l{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::grain_films{}};
  pendular::system s{m, l, boundary::walls{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}}},
                     half_step_velocity_verlet{time_step, {0, 0, -9.81}}, options};
  for (int k = 0; k < 3; ++k) s.add({.position = {0, 0, 0.5e-3 + 1e-3 * k}, .radius = 0.5e-3, .density = 2700});
  return s;
}

int main() {
  std::string sentence;
  // [limits]
  auto s = stack(1e-6, {.force = true});
  s.distribute_liquid(1e-12);
  for (const scene_limit& l : s.limits()) {
    std::printf("%-70s %10.3g <= %10.3g %s\n", l.what.c_str(), l.value, l.bound, l.holds() ? "" : "BROKEN");
  }
  // [/limits]
  // [catch]
  try {
    auto refused = stack(1e-6);
    refused.start();
  } catch (const input_error& error) {
    sentence = error.what();
    std::printf("%s\n", sentence.c_str());
  }
  // [/catch]
  const bool names_it = sentence.find("explicit tangential viscosity") != std::string::npos &&
                        sentence.find("docs/how-to/stability.md") != std::string::npos;
  auto short_enough = stack(1e-8);
  short_enough.start();
  return names_it && s.limits().size() == 6 /* none of a lid */ ? EXIT_SUCCESS : EXIT_FAILURE;
}
