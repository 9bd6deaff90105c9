// SPDX-License-Identifier: BSD-3-Clause
// The admissible time step against the whole stiffness matrix of small packings, put together here from the energy of
// their springs with translations and rotations, and its largest eigenvalue.
#include "../catch.hpp"

#include <pendular/boundary/plane.hpp>
#include <pendular/boundary/servo_stress.hpp>
#include <pendular/core/as_eigen.hpp>
#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/friction/viscous_coulomb_explicit.hpp>
#include <pendular/law/normal/hertz.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/system.hpp>

#include <Eigen/Eigenvalues>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace pendular;

namespace {
constexpr double stiff = 1e3;  // N/m
const normal::linear spring{stiff};

template <class System>
scene_limit limit_of(const System& s, const std::string& what) {
  for (const scene_limit& l : s.limits()) {
    if (l.what.find(what) != std::string::npos) return l;
  }
  FAIL("no limit for " << what);
  return {};
}

/// 30 grains of very different size in a small box, so that most of them overlap a little.
std::vector<grain> heap(std::uint64_t seed) {
  boost::random::mt19937_64 random(seed);
  boost::random::uniform_real_distribution<double> unit(0, 1);
  std::vector<grain> grains;
  while (grains.size() < 30) {
    const grain g{
        {4e-3 * unit(random), 4e-3 * unit(random), 4e-3 * unit(random)}, (0.4 + 0.6 * unit(random)) * 1e-3, 2600};
    bool fits = true;
    for (const grain& other : grains) {
      const double gap = norm(g.position - other.position) - g.radius - other.radius;
      fits &= gap > -0.9 * std::min(g.radius, other.radius);
    }
    if (fits) grains.push_back(g);
  }
  return grains;
}

template <class System>
void fill(System& s, const std::vector<grain>& grains) {
  for (const grain& g : grains) s.add(g);
  s.start();
}

run_options unchecked() { return {.overlap_limit = 0.99, .force = true}; }

/// Largest omega^2 of the packing. Every contact stretches its springs by the slip of its two surfaces; a row of B for
/// each spring, in coordinates scaled by the roots of masses and inertias.
template <class System>
double largest_omega2(const System& s, double tangential) {
  const auto& g = s.particles();
  const auto n = static_cast<Eigen::Index>(g.size());
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(6 * n, 6 * n);
  const auto view = s.view();
  for (std::size_t p = 0; p < view.pairs; ++p) {
    const double gap = view.gap(p);
    if (gap >= 0) continue;
    const std::size_t i = view.grain_i(p), j = view.grain_j(p);
    const Eigen::Vector3d normal = as_eigen(view.position[j] - view.position[i]).normalized();
    const Eigen::Vector3d one = normal.unitOrthogonal(), two = normal.cross(one);
    for (const auto& [direction, k] : {std::pair{normal, stiff}, {one, tangential}, {two, tangential}}) {
      Eigen::VectorXd b = Eigen::VectorXd::Zero(6 * n);
      for (const auto& [row, sign] : {std::pair{i, 1.0}, {j, -1.0}}) {
        const double inverse_mass = g.template get<column::inverse_mass>()[row], lever = view.radius[row] + 0.5 * gap;
        const double inverse_inertia = 2.5 * inverse_mass / (view.radius[row] * view.radius[row]);
        const auto at = 6 * static_cast<Eigen::Index>(row);
        b.segment<3>(at) = sign * std::sqrt(inverse_mass) * direction;
        // surface velocity w x (sign lever n), along the direction, with the sign of the pair again
        b.segment<3>(at + 3) = std::sqrt(inverse_inertia) * lever * normal.cross(direction);
      }
      stiffness += k * b * b.transpose();
    }
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(stiffness, Eigen::EigenvaluesOnly).eigenvalues()(6 * n - 1);
}
}  // namespace

TEST_CASE("the limit of an isolated pair is that of its reduced mass") {
  pendular::system s{material{spring}, boundary::walls{}, velocity_verlet{1e-7}};
  fill(s, {{{0, 0, 0}, 0.5e-3, 2600}, {{0.9999e-3, 0, 0}, 0.5e-3, 2600}});
  // m = 1.361357e-6 kg: 2 sqrt(m / (2 k)) = 52.1796 us
  CHECK(limit_of(s, "stiffness").bound == within(1e-5, 5.21796e-5));
}

TEST_CASE("grains that touch nobody are measured as the pair they may become") {
  pendular::system s{material{spring}, boundary::walls{}, velocity_verlet{1e-7}};
  fill(s, {{{0, 0, 0}, 0.5e-3, 2600}, {{5e-3, 0, 0}, 2e-3, 2600}});
  const scene_limit l = limit_of(s, "stiffness");
  CHECK(l.bound == within(1e-5, 5.21796e-5));
  CHECK(l.grain == 0);
}

TEST_CASE("the limit bounds every frequency of a packing from above and is not far from the highest") {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    pendular::system s{material{spring}, boundary::walls{}, velocity_verlet{1e-9}, unchecked()};
    fill(s, heap(seed));
    const double exact = velocity_verlet::stable_step(largest_omega2(s, 0), 0), bound = limit_of(s, "stiffness").bound;
    CHECK(bound <= exact * (1 + 1e-12));
    CHECK(bound > 0.6 * exact);
  }
}

TEST_CASE("it also bounds the frequencies of rolling on tangential springs") {
  for (const double share : {0.3, 0.8, 3.0}) {
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
      pendular::system s{material{spring, friction::coulomb_spring{share * stiff, 0.5}}, boundary::walls{},
                         half_step_velocity_verlet{1e-9}, unchecked()};
      fill(s, heap(seed));
      const double exact = half_step_velocity_verlet::stable_step(largest_omega2(s, share * stiff), 0);
      const double bound = limit_of(s, "stiffness").bound;
      CHECK(bound <= exact * (1 + 1e-12));
      CHECK(bound > 0.5 * exact);
    }
  }
}

TEST_CASE("springs charged with velocities of their own time count twice") {
  for (const double share : {0.3, 0.8, 3.0}) {
    pendular::system s{material{spring, friction::coulomb_spring{share * stiff, 0.5}}, boundary::walls{},
                       velocity_verlet{1e-9}, unchecked()};
    fill(s, heap(1));
    const double exact = velocity_verlet::stable_step(largest_omega2(s, 2 * share * stiff), 0);
    const double bound = limit_of(s, "stiffness").bound;
    CHECK(bound <= exact * (1 + 1e-12));
    CHECK(bound > 0.5 * exact);
  }
}

TEST_CASE("the limit names the grain whose contacts are the stiffest for its mass") {
  // A light grain with six neighbours among heavy ones, and elsewhere a heavy pair.
  pendular::system s{material{spring}, boundary::walls{}, velocity_verlet{1e-7}};
  std::vector<grain> grains{{{50e-3, 0, 0}, 2e-3, 2600}, {{53.9999e-3, 0, 0}, 2e-3, 2600}, {{0, 0, 0}, 0.4e-3, 2600}};
  const double reach = 1.2999e-3;
  for (const vector& n :
       {vector{1, 0, 0}, vector{-1, 0, 0}, vector{0, 1, 0}, vector{0, -1, 0}, vector{0, 0, 1}, vector{0, 0, -1}}) {
    grains.push_back({reach * n, 0.9e-3, 2600});
  }
  fill(s, grains);
  const scene_limit l = limit_of(s, "stiffness");
  CHECK(l.grain == 2);
  // two springs along each axis: 2 (2 k) / m with m = 6.97014e-7 kg
  CHECK(l.bound == within(1e-4, 2 / std::sqrt(4 * stiff / 6.97014e-7)));
}

TEST_CASE("dashpots shorten the step as the integrator says") {
  const std::vector<grain> two{{{0, 0, 0}, 0.5e-3, 2600}, {{0.9999e-3, 0, 0}, 0.5e-3, 2600}};
  // omega^2 = 2 k / m; the rate is 2 alpha omega
  const double omega = std::sqrt(2 * stiff / 1.361356816555577e-6);
  pendular::system synchronised{material{spring, damping::viscous{0.8}}, boundary::walls{}, velocity_verlet{1e-7}};
  fill(synchronised, two);
  CHECK(limit_of(synchronised, "stiffness").bound == within(1e-6, 2 / (omega * (std::sqrt(2.56 + 1) + 1.6))));
  pendular::system lagging{material{spring, damping::viscous{0.8}}, boundary::walls{}, half_step_velocity_verlet{1e-7}};
  fill(lagging, two);
  CHECK(limit_of(lagging, "stiffness").bound == within(1e-6, 2 / (omega * (std::sqrt(0.64 + 1) + 0.8))));
}

TEST_CASE("a law without a stiffness of its own is measured at the overlap it has") {
  // Hertz: a touch of 1e-4 of the radius where there is no contact, the present overlap where there is one.
  const normal::hertz glass{1e9, 0.2};
  const auto bound_at = [&](double overlap) {
    pendular::system s{material{glass}, boundary::walls{}, velocity_verlet{1e-9}, unchecked()};
    fill(s, {{{0, 0, 0}, 0.5e-3, 2600}, {{1e-3 - overlap, 0, 0}, 0.5e-3, 2600}});
    return limit_of(s, "stiffness").bound;
  };
  CHECK(bound_at(4e-6) / bound_at(1e-6) == within(1e-9, 1 / std::sqrt(2.0)));  // stiffness goes with the root
  CHECK(bound_at(-1e-3) == within(1e-9, bound_at(0.5e-7)));
}

TEST_CASE("an explicit viscosity asks for a step that shrinks with the contacts of a grain") {
  // A row of three: the middle grain has two contacts. rate = 7 n gamma_t / m
  const material rough{spring, friction::viscous_coulomb_explicit{0.01, 0.4}};
  pendular::system s{rough, boundary::walls{}, half_step_velocity_verlet{1e-7}};
  fill(s, {{{0, 0, 0}, 0.5e-3, 2600}, {{0.9999e-3, 0, 0}, 0.5e-3, 2600}, {{1.9998e-3, 0, 0}, 0.5e-3, 2600}});
  const scene_limit l = limit_of(s, "tangential viscosity");
  CHECK(l.bound == within(1e-9, 2 / (7 * 2 * 0.01 / 1.361356816555577e-6)));
  CHECK(l.grain == 1);
}

TEST_CASE("a scene that breaks a limit is refused in words that name value, bound and grain, and runs if forced") {
  const std::vector<grain> two{{{0, 0, 0}, 0.5e-3, 2600}, {{0.9999e-3, 0, 0}, 0.5e-3, 2600}};
  pendular::system hasty{material{spring}, boundary::walls{}, velocity_verlet{6e-5}};
  for (const grain& g : two) hasty.add(g);
  try {
    hasty.start();
    FAIL("accepted");
  } catch (const input_error& error) {
    const std::string text = error.what();
    for (const std::string part : {"the time step (s)", "is 6e-05", "at most 5.21796e-05", "grain 0", "stability.md"}) {
      CAPTURE(text);
      CHECK(text.find(part) != std::string::npos);
    }
  }
  pendular::system forced{material{spring}, boundary::walls{}, velocity_verlet{6e-5}, run_options{.force = true}};
  for (const grain& g : two) forced.add(g);
  CHECK_NOTHROW(forced.start());
  pendular::system careful{material{spring}, boundary::walls{}, velocity_verlet{5e-5}};
  for (const grain& g : two) careful.add(g);
  CHECK_NOTHROW(careful.start());
}

TEST_CASE("a load that is too much for the stiffness, and a bridge that is, are refused") {
  const std::vector<grain> two{{{0, 0, 0}, 0.5e-3, 2600}, {{0.9999e-3, 0, 0}, 0.5e-3, 2600}};
  // sigma d^2 / (k d) = 1e-3 at 1 kPa for d = 1 mm and k = 1 kN/m
  for (const auto& [stress, holds] : {std::pair{990.0, true}, std::pair{1010.0, false}}) {
    const boundary::walls lid{
        boundary::wall{boundary::plane{{0, 0, 5e-3}, {0, 0, -1}}, boundary::servo_stress{stress, 1e-4, 1e-3, 1}}};
    pendular::system s{material{spring}, lid, velocity_verlet{1e-6}, run_options{.force = true}};
    fill(s, two);
    CHECK(limit_of(s, "pressure").holds() == holds);
  }
  // 0.2287 mN over k d: 0.229 at 1 N/m per mm
  pendular::system wet{material{normal::linear{100}}, liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}},
                       boundary::walls{}, velocity_verlet{1e-6}, run_options{.force = true}};
  fill(wet, two);
  wet.distribute_liquid(1.25e-12);
  CHECK(limit_of(wet, "under the capillary force").value == within(1e-5, 2.28708e-4 / (100 * 1e-3)));
  CHECK_FALSE(limit_of(wet, "under the capillary force").holds());
}

TEST_CASE("walls stiffen the grains that touch them: a chain of two between two walls has omega^2 = 3 k / m") {
  const boundary::walls vice{boundary::wall{boundary::plane{{0, 0, 0}, {1, 0, 0}}},
                             boundary::wall{boundary::plane{{1.9997e-3, 0, 0}, {-1, 0, 0}}}};
  pendular::system s{material{spring}, vice, velocity_verlet{1e-7}};
  fill(s, {{{0.4999e-3, 0, 0}, 0.5e-3, 2600}, {{1.4998e-3, 0, 0}, 0.5e-3, 2600}});
  CHECK(limit_of(s, "stiffness").bound <= 2 / std::sqrt(3 * stiff / 1.361356816555577e-6) * (1 + 1e-9));
}

TEST_CASE("a lid is measured by its mass and the contacts at it") {
  const boundary::servo_stress load{100, 1e-6, 1e-7, 0};
  const boundary::walls press{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}},
                              boundary::wall{boundary::plane{{0, 0, 0.9998e-3}, {0, 0, -1}}, load}};
  std::vector<grain> row;
  for (int count = 1; count <= 3; ++count) {
    row.push_back({{2e-3 * count, 0, 0.4999e-3}, 0.5e-3, 2600});
    pendular::system s{material{spring}, press, half_step_velocity_verlet{1e-7}};
    fill(s, row);
    CHECK(limit_of(s, "mass of a lid").bound == within(1e-12, 2 / std::sqrt(2 * count * stiff / 1e-7)));
    pendular::system damped{material{spring, damping::viscous{0.5}}, press, half_step_velocity_verlet{1e-7}};
    fill(damped, row);
    CHECK(limit_of(damped, "mass of a lid").bound < 0.99 * limit_of(s, "mass of a lid").bound);
  }
}
