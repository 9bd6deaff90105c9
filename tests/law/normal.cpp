// SPDX-License-Identifier: BSD-3-Clause
// Normal laws against K. L. Johnson's closed forms at round numbers and against two of the benchmarks of Chung and Ooi,
// Granular Matter 13, 643 (2011): two glass spheres head-on, an aluminium sphere on a rigid plane. Their extreme values
// are those of the elastic impact integral, F = k overlap^{3/2}: (5/4 m v^2 / k)^{2/5} and 2.94 overlap / v.
#include "../catch.hpp"
#include "two_bodies.hpp"

#include <pendular/core/lanes.hpp>
#include <pendular/law/normal/hertz.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/stiffness.hpp>

#include <array>
#include <limits>

using namespace pendular;

namespace {
constexpr double infinity = std::numeric_limits<double>::infinity();

approach<double> at(double gap, double radius_i = 1.0, double radius_j = infinity) {
  return {gap, 0.0, 1.0, radius_i, radius_j};
}

/// A law that keeps its stiffness to itself, so that it has to be found by automatic differentiation.
template <class Law>
struct taciturn {
  Law law;
  template <Scalar T>
  T repulsion(const approach<T>& a) const {
    return law.repulsion(a);
  }
};

two_bodies::pair spheres(double radius, double density) {
  const double mass = 4.18879020478639 * radius * radius * radius * density;
  return {mass, mass, radius, radius};
}
}  // namespace

TEST_CASE("a linear contact pushes by its stiffness times the overlap") {
  const normal::linear law{1e3};
  CHECK(law.repulsion(at(-2e-6)) == within(1e-15, 2e-3));
  CHECK(law.repulsion(at(0.0)) == 0);
  CHECK(law.repulsion(at(1e-300)) == 0);
  CHECK(law.repulsion(at(-1e-300)) == within(1e-15, 1e-297));
  CHECK(law.energy(at(-2e-6)) == within(1e-15, 2e-9));
  CHECK(law.energy(at(2e-6)) == 0);
  CHECK(stiffness(law, at(-2e-6)) == 1e3);
}

TEST_CASE("a Hertz contact of unit modulus and radius gives Johnson's fractions") {
  const normal::hertz law{1.5, 0.5};  // contact modulus 1
  CHECK(law.contact_modulus() == 1);
  CHECK(law.repulsion(at(-0.25)) == within(1e-15, 1.0 / 6));
  CHECK(stiffness(law, at(-0.25)) == within(1e-15, 1.0));
  CHECK(law.energy(at(-0.25)) == within(1e-15, 1.0 / 60));
  CHECK(law.repulsion(at(0.25)) == 0);
  CHECK(law.repulsion(at(0.0)) == 0);
  CHECK(stiffness(law, at(0.0)) == 0);
  // two spheres of radius 2 bend like a unit sphere on a plane, as do 3/2 and 3
  CHECK(law.repulsion(at(-0.25, 2.0, 2.0)) == within(1e-15, 1.0 / 6));
  CHECK(law.repulsion(at(-0.25, 1.5, 3.0)) == within(1e-15, 1.0 / 6));
  CHECK(law.repulsion(at(-0.25, 1.0, 1e300)) == within(1e-15, 1.0 / 6));
}

TEST_CASE("the stiffness by automatic differentiation is the analytic one") {
  const normal::hertz law{7e10, 0.22};
  const taciturn<normal::hertz> silent{law};
  for (const double overlap : {1e-12, 1e-9, 1e-7, 1e-5}) {
    const approach<double> a = at(-overlap, 5e-4, 1e-3);
    CHECK(stiffness(silent, a) == within(1e-13, stiffness(law, a)));
  }
  CHECK(stiffness(taciturn<normal::linear>{{1e3}}, at(-1e-6)) == 1e3);
  CHECK(stiffness(taciturn<normal::linear>{{1e3}}, at(1e-6)) == 0);
  // F = 7e10 / (1 - 0.0484) * 2/3 * sqrt(0.25e-3) * 1e-9 ^ 1.5 in twelve digits elsewhere
  CHECK(law.repulsion(at(-1e-9, 5e-4, 5e-4)) == within(1e-12, 2.45201064873e-5));
}

TEST_CASE("the stiffness of lanes is found lane by lane") {
  using eight = lanes<8>;
  const std::array<double, 8> gaps{-1e-6, -2e-6, -3e-6, 1e-6, 0.5, -1e-9, -1e-7, -4e-6};
  const eight gap = eight::load(gaps.data());
  const approach<eight> a{gap, eight(0), eight(1), eight(5e-4), eight(1e-3)};
  const normal::hertz law{7e10, 0.22};
  const eight found = stiffness(taciturn<normal::hertz>{law}, a);
  for (int k : {0, 1, 2, 5, 6, 7}) CHECK(found[k] == within(1e-13, stiffness(law, at(gap[k], 5e-4, 1e-3))));
  const eight own = stiffness(law, a);
  for (int k = 0; k < 8; ++k) CHECK(own[k] == within(1e-14, stiffness(law, at(gap[k], 5e-4, 1e-3))));
}

TEST_CASE("two glass spheres collide as in benchmark 1 of Chung and Ooi") {
  const normal::hertz law{48e9, 0.2};
  const auto push = [&](const approach<double>& a) { return law.repulsion(a); };
  const auto found = two_bodies::collide(spheres(0.01, 2800), push, 10, -10, 40.34e-6 / 5000);
  CHECK(found.largest_force == within(1e-4, 10697.0));
  CHECK(found.deepest == within(3e-4, 274.1e-6));
  CHECK(found.duration == within(3e-4, 40.34e-6));
  CHECK(found.restitution() == within(1e-6, 1.0));
}

TEST_CASE("an aluminium sphere meets a rigid plane as in benchmark 2 of Chung and Ooi") {
  // A rigid plane halves the compliance, as does a plane of the same material and twice the modulus.
  const normal::hertz law{2 * 70e9, 0.3};
  const auto push = [&](const approach<double>& a) { return law.repulsion(a); };
  two_bodies::pair p = spheres(0.1, 2699);
  p.mass_j = p.radius_j = infinity;
  const auto found = two_bodies::collide(p, push, 0.2, 0, 731.7e-6 / 5000);
  CHECK(found.largest_force == within(1e-4, 11370.0));
  CHECK(found.deepest == within(2e-4, 49.72e-6));
  CHECK(found.duration == within(2e-4, 731.7e-6));
}

TEST_CASE("a linear contact lasts half a period of its oscillator") {
  // pi / sqrt(1e3 / 0.75e-6) s for masses of 1 and 3 mg
  const normal::linear law{1e3};
  const auto push = [&](const approach<double>& a) { return law.repulsion(a); };
  const auto found = two_bodies::collide({1e-6, 3e-6, 5e-4, 7e-4}, push, 0.1, 0, 86.0364e-6 / 5000);
  CHECK(found.duration == within(1e-5, 86.0364e-6));
  CHECK(found.deepest == within(1e-5, 2.738613e-6));
  CHECK(found.restitution() == within(1e-6, 1.0));
  CHECK(1e-6 * found.after.velocity_i + 3e-6 * found.after.velocity_j == within(1e-12, 1e-7));
}

TEST_CASE("normal laws keep their digits at both ends of the range") {
  const normal::hertz glass{7e10, 0.22};
  const double in_double = glass.repulsion(at(-1e-12, 1e-6, 1e-6));
  const float in_float = glass.repulsion(approach<float>{-1e-12f, 0.f, 1.f, 1e-6f, 1e-6f});
  CHECK(double(in_float) == within(1e-6, in_double));
  CHECK(std::isfinite(normal::linear{1e18}.repulsion(at(-1.0))));
  CHECK(std::isfinite(normal::hertz{1e15, 0.49}.repulsion(at(-1.0))));
  CHECK(normal::hertz{1e15, 0.49}.repulsion(at(-1e-12)) > 0);
}

TEST_CASE("parameters that make no material are refused") {
  CHECK_NOTHROW(validate(normal::linear{1e3}));
  CHECK_THROWS_AS(validate(normal::linear{0}), input_error);
  CHECK_THROWS_AS(validate(normal::linear{infinity}), input_error);
  CHECK_THROWS_AS(validate(normal::linear{std::nan("")}), input_error);
  CHECK_NOTHROW(validate(normal::hertz{7e10, 0.5}));
  CHECK_THROWS_AS(validate(normal::hertz{-7e10, 0.2}), input_error);
  CHECK_THROWS_AS(validate(normal::hertz{7e10, 0.51}), input_error);
  CHECK_THROWS_AS(validate(normal::hertz{7e10, -1.0}), input_error);
  CHECK_THROWS_WITH(
      validate(normal::linear{-3}),
      "the normal stiffness k_n (N/m) is -3, but must be positive and finite (see docs/reference/laws.md)");
}
