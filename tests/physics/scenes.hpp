// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../catch.hpp"

#include <pendular/boundary/cylinder.hpp>
#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/damping/viscous_on_approach.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/friction/viscous_coulomb.hpp>
#include <pendular/law/friction/viscous_coulomb_explicit.hpp>
#include <pendular/law/normal/hertz.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/liquid/protocol/all.hpp>
#include <pendular/observe/energy.hpp>
#include <pendular/system.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

// What the scenes of the system and physics tests share: looking a grain up by its id, and small packings.
namespace scenes {

using pendular::vector;
namespace column = pendular::column;
inline constexpr double pi = std::numbers::pi;

inline double sphere_mass(double radius, double density) { return 4.0 / 3.0 * pi * radius * radius * radius * density; }

template <class System>
std::size_t row_of(const System& s, std::int64_t id) {
  return s.particles().rows_by_id().at(static_cast<std::size_t>(id));
}
template <class System>
vector& position(System& s, std::int64_t id) {
  return s.particles().template get<column::position>()[row_of(s, id)];
}
template <class System>
vector& velocity(System& s, std::int64_t id) {
  return s.particles().template get<column::velocity>()[row_of(s, id)];
}
template <class System>
vector& spin(System& s, std::int64_t id) {
  return s.particles().template get<column::angular_velocity>()[row_of(s, id)];
}
template <class System>
double gap_of(const System& s, std::int64_t i, std::int64_t j) {
  const auto position_of = s.particles().template get<column::position>();
  const auto radius = s.particles().template get<column::radius>();
  const std::size_t a = row_of(s, i), b = row_of(s, j);
  return pendular::norm(position_of[a] - position_of[b]) - radius[a] - radius[b];
}
template <class System>
double kinetic_energy(const System& s) {
  const auto v = s.particles().template get<column::velocity>();
  const auto inverse_mass = s.particles().template get<column::inverse_mass>();
  double sum = 0;
  for (std::size_t k = 0; k < v.size(); ++k) sum += 0.5 / inverse_mass[k] * pendular::dot(v[k], v[k]);
  return sum;
}
template <class System>
double weight(const System& s) {
  double mass = 0;
  for (const double inverse : s.particles().template get<column::inverse_mass>()) mass += 1 / inverse;
  return mass * pendular::norm(s.integrator().gravity);
}

/// Uniform in [-1, 1): Marsaglia's xorshift, so that every platform has the same scene.
class random_numbers {
 public:
  explicit random_numbers(std::uint64_t seed = 88172645463325252u) : state_(seed) {}
  double operator()() {
    state_ ^= state_ << 13, state_ ^= state_ >> 7, state_ ^= state_ << 17;
    return static_cast<double>(state_ >> 11) * 0x1p-52 - 1;
  }
  vector in_cube() {
    const double x = (*this)(), y = (*this)(), z = (*this)();
    return {x, y, z};
  }

 private:
  std::uint64_t state_;
};

/// nx x ny x nz grains on a shaken cubic lattice in the positive octant, radii spread by `spread`; no two overlap when
/// spacing >= 2 radius (1 + spread) + 0.2 spacing.
inline std::vector<pendular::grain> loose_lattice(int nx, int ny, int nz, double radius, double spread, double spacing,
                                                  double speed, std::uint64_t seed = 12345) {
  random_numbers random(seed);
  std::vector<pendular::grain> grains;
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        const vector lattice{spacing * (i + 0.5), spacing * (j + 0.5), spacing * (k + 0.5)};
        const vector shift = random.in_cube();
        const double r = radius * (1 + spread * random());
        const vector v = random.in_cube();
        grains.push_back({lattice + (0.05 * spacing) * shift, r, 2600, speed * v});
      }
    }
  }
  return grains;
}

/// Six fixed planes around the box from the origin to `size`.
inline auto closed_box(const vector& size) {
  using pendular::boundary::plane;
  using pendular::boundary::wall;
  return pendular::boundary::walls{wall{plane{{0, 0, 0}, {1, 0, 0}}}, wall{plane{{size.x, 0, 0}, {-1, 0, 0}}},
                                   wall{plane{{0, 0, 0}, {0, 1, 0}}}, wall{plane{{0, size.y, 0}, {0, -1, 0}}},
                                   wall{plane{{0, 0, 0}, {0, 0, 1}}}, wall{plane{{0, 0, size.z}, {0, 0, -1}}}};
}

inline auto floor_plane() {
  using pendular::boundary::plane;
  return pendular::boundary::walls{pendular::boundary::wall{plane{{0, 0, 0}, {0, 0, 1}}}};
}

/// Damping rate of the two-sided dashpot on a linear spring for a restitution (physics: ln e = -pi a / sqrt(1 - a^2)).
inline double damping_rate_for(double restitution) {
  const double l = std::log(restitution);
  return -l / std::sqrt(pi * pi + l * l);
}

}  // namespace scenes
