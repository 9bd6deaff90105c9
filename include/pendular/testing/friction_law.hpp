// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/concepts.hpp>
#include <pendular/testing/report.hpp>
#include <pendular/testing/samples.hpp>
#include <pendular/testing/scalars.hpp>

#include <vector>

namespace pendular::testing {

/// The traction of a law with or without memory; the memory of the second kind is empty.
template <class Law, class T>
  requires pendular::detail::Rubs<Law, T> Vec3<T> traction(const Law& law, const slip<T>& s, const T& normal_force,
                                                           contact_memory_t<Law, T>& memory) {
    if constexpr (pendular::detail::Remembers<Law, T>) {
      return law.traction(s, normal_force, memory);
    } else {
      return law.traction(s, normal_force);
    }
  }

namespace detail {
template <class T, class Law>
auto untouched(const Law&) {
  return fresh_memory<contact_memory_t<Law, T>, T>();
}

inline bool finite(const Vec3<double>& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

template <FrictionLaw Law>
void demand_first_touch(report& broken, const Law& law, const slip<double>& s, double normal_force, double limit) {
  auto memory = untouched<double>(law);
  const Vec3<double> force = testing::traction(law, s, normal_force, memory);
  const double power = dot(force, s.velocity);
  const double out_of_plane = dot(force, s.normal);
  const std::initializer_list<quantity> example = {
      {"slip", norm(s.velocity)}, {"normal force", normal_force}, {"traction", norm(force)}, {"power", power}};
  demand(broken, finite(force), "the traction must be finite", example);
  demand(broken, norm(force) <= limit * (1 + 1e-12), "the traction must stay inside the Coulomb cone", example);
  demand(broken, !(power > 0), "the traction must oppose the slip", example);
  demand(broken, norm(s.velocity) != 0 || norm(force) == 0, "the traction must be zero at zero slip", example);
  demand(broken, std::abs(out_of_plane) <= 1e-9 * norm(force), "the traction must lie in the tangent plane", example);
  demand(broken, std::abs(power) >= (1 - 1e-9) * norm(force) * norm(s.velocity),
         "the traction must be parallel to the slip", example);
}

/// A contact that is dragged to and fro while its normal force swells and shrinks.
template <FrictionLaw Law>
void demand_cone_for_any_history(report& broken, const Law& law, double friction_coefficient, double time_step) {
  const std::vector<slip<double>> samples = slip_samples(time_step);
  auto memory = untouched<double>(law);
  for (std::size_t step = 0; step < 2000; ++step) {
    const slip<double>& s = samples[(step * step + 3 * step) % samples.size()];
    const double normal_force = step % 17 == 0 ? 0.0 : 1e-3 * double(1 + step % 13);
    const Vec3<double> force = testing::traction(law, s, normal_force, memory);
    const std::initializer_list<quantity> example = {
        {"step", double(step)}, {"normal force", normal_force}, {"traction", norm(force)}};
    demand(broken, finite(force), "the traction must be finite", example);
    demand(broken, norm(force) <= friction_coefficient * normal_force * (1 + 1e-12),
           "the traction must stay inside the Coulomb cone", example);
  }
}

/// The length of the traction after a few steps, so that the memory counts as well.
template <class T, FrictionLaw Law>
T dragged(const Law& law, const slip<T>& s) {
  auto memory = untouched<T>(law);
  const T normal_force = T(1e-3);
  Vec3<T> force = testing::traction(law, s, normal_force, memory);
  for (int step = 1; step < 5; ++step) force = testing::traction(law, s, normal_force, memory);
  return T(-(force.x + T(2) * force.y + T(4) * force.z));
}

template <class T, FrictionLaw Law>
void demand_friction_in(report& broken, const Law& law, std::string_view property) {
  demand(broken, pendular::detail::Rubs<Law, T>, property, {});
  if constexpr (pendular::detail::Rubs<Law, T>) {
    const auto force = [&]<class U>(const slip<U>& s) { return dragged<U>(law, s); };
    demand_same_in<T>(broken, property, slip_samples(), force);
  }
}
}  // namespace detail

/// What a friction law promises beyond its signature, given the coefficient of its Coulomb cone.
template <FrictionLaw Law>
report friction_law_report(const Law& law, double friction_coefficient) {
  report broken;
  for (const double time_step : {1e-9, 1e-6, 1e-3}) {
    for (const slip<double>& s : slip_samples(time_step)) {
      for (const double normal_force : {0.0, 1e-12, 1e-3, 1e3}) {
        detail::demand_first_touch(broken, law, s, normal_force, friction_coefficient * normal_force);
      }
    }
    detail::demand_cone_for_any_history(broken, law, friction_coefficient, time_step);
  }
  detail::demand_friction_in<float>(broken, law, "the traction must be the same in float");
  detail::demand_friction_in<lanes<8>>(broken, law, "the traction must be the same in lanes of double");
  detail::demand_friction_in<lanes<16, float>>(broken, law, "the traction must be the same in lanes of float");
  detail::demand_friction_in<dual>(broken, law, "the traction must be the same under automatic differentiation");
  return broken;
}

}  // namespace pendular::testing
