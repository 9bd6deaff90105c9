// SPDX-License-Identifier: BSD-3-Clause
// Integrators on x'' = -omega^2 x - rate x', against the exact solution and against the spectral radius of their own
// map from one step to the next, found by stepping unit vectors.
#include "../catch.hpp"

#include <pendular/motion/velocity_verlet.hpp>

#include <Eigen/Eigenvalues>
#include <boost/hana/for_each.hpp>
#include <boost/hana/tuple.hpp>
#include <boost/hana/type.hpp>

#include <cmath>
#include <complex>
#include <limits>

using namespace pendular;

namespace {
struct oscillator {
  double omega2, rate;
  double acceleration(double x, double v) const { return -omega2 * x - rate * v; }
};

/// Position, velocity, and the acceleration of the last forces.
struct state {
  double x, v, a;
};

template <class Integration>
state stepped(const Integration& integrator, const oscillator& o, const state& s) {
  vector position{s.x, 0, 0}, velocity{s.v, 0, 0};
  integrator.predict(position, velocity, {s.a, 0, 0});
  const double now = o.acceleration(position.x, velocity.x);
  integrator.correct(velocity, {s.a, 0, 0}, {now, 0, 0});
  return {position.x, velocity.x, now};
}

template <class Integration>
double error_at_one_second(const oscillator& o, int steps) {
  const Integration integrator{1.0 / steps};
  state s{1, 0.5, o.acceleration(1, 0.5)};
  for (int k = 0; k < steps; ++k) s = stepped(integrator, o, s);
  const double decay = 0.5 * o.rate, omega = std::sqrt(o.omega2 - decay * decay);
  const double exact = std::exp(-decay) * (std::cos(omega) + (0.5 + decay) / omega * std::sin(omega));
  return std::abs(s.x - exact);
}

template <class Integration>
double order(const oscillator& o) {
  return std::log2(error_at_one_second<Integration>(o, 800) / error_at_one_second<Integration>(o, 1600));
}

template <class Integration>
double spectral_radius(const oscillator& o, double time_step) {
  Eigen::Matrix3d map;
  for (int column = 0; column < 3; ++column) {
    const state unit{column == 0 ? 1.0 : 0, column == 1 ? 1.0 : 0, column == 2 ? 1.0 : 0};
    const state s = stepped(Integration{time_step}, o, unit);
    map.col(column) << s.x, s.v, s.a;
  }
  return map.eigenvalues().cwiseAbs().maxCoeff();
}

/// The longest stable step by bisection; stability is lost once and for all on the way up.
template <class Integration>
double longest_stable_step(const oscillator& o) {
  double stable = 0, unstable = 100 / (std::sqrt(o.omega2) + o.rate);
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (stable + unstable);
    (spectral_radius<Integration>(o, middle) <= 1 + 1e-9 ? stable : unstable) = middle;
  }
  return stable;
}

constexpr auto both = boost::hana::tuple_t<velocity_verlet, half_step_velocity_verlet>;
}  // namespace

TEST_CASE("both integrators are of second order without damping") {
  CHECK(order<velocity_verlet>({9, 0}) == near(0.05, 2.0));
  CHECK(order<half_step_velocity_verlet>({9, 0}) == near(0.05, 2.0));
}

TEST_CASE("with a dashpot synchronised velocities stay of second order, those of half a step ago fall to first") {
  CHECK(order<velocity_verlet>({9, 1}) == near(0.05, 2.0));
  CHECK(order<half_step_velocity_verlet>({9, 1}) == near(0.05, 1.0));
  CHECK(error_at_one_second<velocity_verlet>({9, 1}, 1600) < 1e-6);
  CHECK(error_at_one_second<half_step_velocity_verlet>({9, 1}, 1600) < 1e-3);
}

TEST_CASE("free fall is exact at any step") {
  boost::hana::for_each(both, [](auto type) {
    const typename decltype(type)::type integrator{0.25, {0, 0, -8}};
    vector position{0, 0, 10}, velocity{1, 0, 2};
    for (int k = 0; k < 4; ++k) {
      integrator.predict(position, velocity, integrator.gravity);
      integrator.correct(velocity, integrator.gravity, integrator.gravity);
    }
    CHECK(position == vector{1, 0, 8});  // 10 + 2 - 4
    CHECK(velocity == vector{1, 0, -6});
  });
}

TEST_CASE("an undamped oscillator keeps its energy for a million steps") {
  boost::hana::for_each(both, [](auto type) {
    const typename decltype(type)::type integrator{0.05};
    const oscillator o{1, 0};
    state s{1, 0, -1};
    double lowest = 1, highest = 0;
    for (int k = 0; k < 1000000; ++k) {
      s = stepped(integrator, o, s);
      lowest = std::min(lowest, s.x * s.x + s.v * s.v);
      highest = std::max(highest, s.x * s.x + s.v * s.v);
    }
    CHECK(lowest > 0.999);
    CHECK(highest < 1.001);
  });
}

TEST_CASE("spins are moved as velocities are") {
  boost::hana::for_each(both, [](auto type) {
    const typename decltype(type)::type integrator{0.3};
    vector position{0, 0, 0}, velocity{1, 2, 3}, spin = velocity;
    integrator.predict(position, velocity, {4, 5, 6});
    integrator.predict_spin(spin, {4, 5, 6});
    CHECK(spin == velocity);
  });
}

TEST_CASE("the stable step is where the map from one step to the next begins to grow") {
  boost::hana::for_each(both, [](auto type) {
    using integration = typename decltype(type)::type;
    for (const double omega2 : {1.0, 2500.0}) {
      for (const double share : {0.0, 0.01, 0.3, 1.0, 2.0, 10.0, 300.0}) {
        const oscillator o{omega2, share * std::sqrt(omega2)};
        CAPTURE(omega2, share);
        CHECK(integration::stable_step(o.omega2, o.rate) == within(1e-5, longest_stable_step<integration>(o)));
      }
    }
    const oscillator viscous{0, 3};
    CHECK(integration::stable_step(0, 3) == within(1e-5, longest_stable_step<integration>(viscous)));
  });
}

TEST_CASE("the limits everybody knows") {
  CHECK(velocity_verlet::stable_step(4, 0) == 1);  // 2 / omega
  CHECK(half_step_velocity_verlet::stable_step(4, 0) == 1);
  CHECK(velocity_verlet::stable_step(0, 2) == 0.5);          // 1 / rate, synchronised
  CHECK(half_step_velocity_verlet::stable_step(0, 2) == 1);  // 2 / rate, half a step ago
}

TEST_CASE("steps and gravities without meaning are refused") {
  boost::hana::for_each(both, [](auto type) {
    using integration = typename decltype(type)::type;
    CHECK_NOTHROW(validate(integration{1e-6, {0, 0, -9.81}}));
    for (const double bad : {0.0, -1e-6, std::nan(""), std::numeric_limits<double>::infinity()}) {
      CHECK_THROWS_AS(validate(integration{bad}), input_error);
    }
    CHECK_THROWS_AS(validate(integration{1e-6, {0, std::nan(""), 0}}), input_error);
  });
}
