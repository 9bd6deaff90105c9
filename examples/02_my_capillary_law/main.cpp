// SPDX-License-Identifier: BSD-3-Clause
// A capillary law of one's own, and a pair of wet beads pulled apart with it.
#include <pendular/boundary/wall.hpp>
#include <pendular/law/check.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/rupture/willett.hpp>
#include <pendular/liquid/protocol/grain_films.hpp>
#include <pendular/system.hpp>

#include <cstdio>

// [law]
/// F = 2 pi gamma cos(theta) R_h / (1 + 1.05 S + 2.5 S^2),  S = D sqrt(R_h / V),  R_h = 2 R_i R_j / (R_i + R_j).
/// Source: Willett, Adams, Johnson and Seville 2000, Langmuir 16, 9396, closed form for small bridges.
struct willett_bridge {
  template <pendular::Scalar T>
  T attraction(const pendular::bridge<T>& b, const pendular::fluid& f) const {
    const T radius = T(2) * b.radius_i * b.radius_j / (b.radius_i + b.radius_j);
    const T gap = pendular::max(b.gap, T(0));  // the pull of a closed contact is that at gap 0
    const T scaled = gap * pendular::sqrt(T(radius / pendular::max(b.volume, T(pendular::tiny))));
    return T(pendular::capillary_tension(f)) * radius / (T(1) + T(1.05) * scaled + T(2.5) * scaled * scaled);
  }
};

static_assert(pendular::check::capillary_law<willett_bridge>);
// [/law]

int main() {
  using namespace pendular;
  // [scene]
  pendular::system pair{material{normal::linear{1e3}, damping::viscous{0.8}},
                        liquid{fluid::water(), willett_bridge{}, rupture::willett{}, protocol::grain_films{}},
                        boundary::walls{}, half_step_velocity_verlet{1e-7}};
  const double radius = 0.5e-3, speed = 2e-3;
  pair.add({{0, 0, 0}, radius, 2600});
  pair.add({{2 * radius - 1e-9, 0, 0}, radius, 2600});
  pair.distribute_liquid(1.25e-12);
  // [/scene]

  std::puts("gap, um  bridge, nl  pull, uN  film on a bead, nl");
  for (int line = 0; line <= 14; ++line) {
    const double force = norm(pair.contacts().force(0)), gap = pair.view().gap(0);
    std::printf("%7.2f  %10.4f  %8.2f  %18.4f\n", 1e6 * gap, 1e12 * pair.bridges().book().bonds()[0], 1e6 * force,
                1e12 * pair.bridges().book().films()[0]);
    // Beads on two slow holders: before every step their velocities are what the holders want.
    for (int step = 0; step < 50000; ++step) {
      const auto velocity = pair.particles().get<column::velocity>();
      velocity[0] = {-0.5 * speed, 0, 0};
      velocity[1] = {0.5 * speed, 0, 0};
      pair.run(1);
    }
  }
  return pair.bridges().count() == 0 ? 0 : 1;
}
