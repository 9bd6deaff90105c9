// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/motion/admissible_time_step.hpp>

#include <numbers>
#include <string>
#include <vector>

namespace pendular {

/// Grains must stay nearly rigid: overlaps that bend the geometry falsify gaps and bridges.
inline constexpr double least_stiffness_number = 1e3;  // k_n d / force, Richefeu et al. 2007 scenes are near 4e3

/// Damping of every touching pair below critical, as the ratio c / (2 sqrt(m k)).
template <class Grains, class Material>
scene_limit damping_limit(const Grains& g, const Material& material) {
  const auto radius = g.template get<column::radius>();
  const auto inverse_mass = g.template get<column::inverse_mass>();
  scene_limit worst{"the damping rate of a contact (1 is critical)", 0, 1.0 - 1e-6};
  for (std::size_t k = 0; k < g.size(); ++k) {
    const double mass = 0.5 / inverse_mass[k];
    const auto t = detail::contact_tangent<Material>::of(material, {0, 0, mass, radius[k], radius[k]});
    const double ratio = t.damping / (2 * std::sqrt(mass * t.normal));
    if (ratio > worst.value) worst = {worst.what, ratio, worst.bound, g.template get<column::id>()[k]};
  }
  return worst;
}

/// Largest stress a lid imposes, Pa. `for_each_wall` is as in contact_limits.
template <class Walls>
double lid_stress(const Walls& for_each_wall) {
  double largest = 0;
  for_each_wall([&](const auto& wall, const auto&) {
    if constexpr (requires { wall.drive.stress; }) largest = std::max(largest, wall.drive.stress);
  });
  return largest;
}

/// Time step against the contacts of a lid, a wall that moves as a free mass, bounded as those of a grain are.
template <class Integration, class Grains, class Walls>
scene_limit lid_step_limit(const Integration& integrator, const Grains& g, const Walls& for_each_wall, double reach) {
  scene_limit worst{"the time step (s), against the mass of a lid", integrator.time_step, HUGE_VAL};
  for_each_wall([&](const auto& wall, const auto& own) {
    if constexpr (requires { wall.drive.inertia(integrator.time_step); }) {
      double stiffness = 0, damping = 0;
      detail::for_each_touch(g, wall, own, reach, [&](std::size_t, const auto& tangent, const vector&) {
        stiffness += tangent.normal;
        damping += tangent.damping;
      });
      const double twice = 2 / wall.drive.inertia(integrator.time_step);
      worst.bound = std::min(worst.bound, Integration::stable_step(twice * stiffness, twice * damping));
    }
  });
  return worst;
}

/// Force of a load or a bridge against k_n d: the stiffness number k_n d / f must be at least 1e3.
template <class Material>
scene_limit softness_limit(const Material& material, const std::string& of_what, double force, double radius,
                           std::int64_t grain) {
  const approach<double> a{-1e-3 * radius, 0, 1, radius, radius};
  const double overlap = force / std::max(stiffness(material.normal(), a), tiny);
  return {"the overlap over the diameter under " + of_what, overlap / (2 * radius), 1 / least_stiffness_number, grain};
}

/// The largest bridge force against the contact stiffness.
template <class Material, class Liquid>
scene_limit bridge_softness_limit(const Material& material, const pair_view& view, const bonds<Liquid>& b) {
  scene_limit worst{"the overlap over the diameter under the capillary force", 0, 1 / least_stiffness_number};
  view.for_each_row([&](std::size_t p) {
    if (!b.is_bonded(p)) return;
    const bridge<double> closed = view.bridge_of(p, 0, b.book().bonds()[p]);
    const auto c = prepare(b.policies().law(), closed, b.policies().substance());
    const double pull = attraction(b.policies().law(), 0.0, c, b.policies().substance());
    const double smaller = std::min(closed.radius_i, closed.radius_j);
    const scene_limit here = softness_limit(material, "the capillary force", pull, smaller, view.ids(p).first);
    if (here.value > worst.value) worst = here;
  });
  return worst;
}

/// The pressure of the heaviest column or lid, sigma d^2, against the contact stiffness.
template <class Grains, class Material>
scene_limit pressure_limit(const Grains& g, const Material& material, double pressure) {
  const auto radius = g.template get<column::radius>();
  const auto largest = static_cast<std::size_t>(std::max_element(radius.begin(), radius.end()) - radius.begin());
  const double d = 2 * radius[largest];
  return softness_limit(material, "the pressure of the scene", pressure * d * d, radius[largest],
                        g.template get<column::id>()[largest]);
}

/// Weight of all grains over the area they stand on, Pa; 0 without gravity.
template <class Grains>
double weight_pressure(const Grains& g, const vector& gravity) {
  const double strength = norm(gravity);
  if (strength == 0 || g.size() < 2) return 0;
  const vector down = (1 / strength) * gravity;
  const auto position = g.template get<column::position>();
  const auto radius = g.template get<column::radius>();
  double weight = 0, solid = 0, low = HUGE_VAL, high = -HUGE_VAL;
  for (std::size_t k = 0; k < g.size(); ++k) {
    weight += strength / g.template get<column::inverse_mass>()[k];
    solid += 4.0 / 3.0 * std::numbers::pi * radius[k] * radius[k] * radius[k];
    const double depth = dot(position[k], down);
    low = std::min(low, depth - radius[k]);
    high = std::max(high, depth + radius[k]);
  }
  constexpr double dense = 0.6;  // solid fraction once everything has settled
  return weight / solid * dense * (high - low);
}

/// What contacts and loads must keep below a bound, as they stand. `for_each_wall` calls its argument with every wall and
/// the material of the contacts at it.
template <class Integration, class Grains, class Material, class Walls>
std::vector<scene_limit> contact_limits(const Integration& integrator, const Grains& g, const pair_list& list,
                                        const Material& m, const Walls& for_each_wall) {
  constexpr double weight = detail::spring_weight<Integration>;
  auto rigidities = detail::rigidities(g, list, m, weight);
  const double nearby = 0.2 * extreme_radii(g).first;  // whatever the skin
  for_each_wall([&](const auto& wall, const auto& own) {
    detail::for_each_touch(g, wall, own, nearby, [&](std::size_t row, const auto& tangent, const vector& normal) {
      detail::add_contact(rigidities[row], tangent, normal, weight);
    });
  });
  const double pressure = weight_pressure(g, integrator.gravity) + lid_stress(for_each_wall);
  return {contact_step_limit(integrator, g, rigidities), viscosity_step_limit(integrator, g, rigidities, m),
          lid_step_limit(integrator, g, for_each_wall, nearby), damping_limit(g, m), pressure_limit(g, m, pressure)};
}

/// What bridges must keep below a bound besides.
template <class Integration, class Grains, class Material, class Liquid>
std::vector<scene_limit> bridge_limits(const Integration& integrator, const Grains& g, const Material& m,
                                       const pair_view& view, const bonds<Liquid>& b) {
  std::vector<scene_limit> all{capillary_step_limit(integrator, g, view, b)};
  if constexpr (Liquid::is_viscous) all.push_back(bridge_viscosity_step_limit(integrator, g, view, b));
  all.push_back(bridge_softness_limit(m, view, b));
  return all;
}

/// One sentence with all limits that do not hold, or nothing.
inline std::string violations(const std::vector<scene_limit>& limits) {
  std::string text;
  for (const scene_limit& l : limits) {
    if (l.holds()) continue;
    text += (text.empty() ? "" : "; ") + l.what + " is " + detail::number(l.value) + ", but must be at most " +
            detail::number(l.bound) + (l.grain >= 0 ? " (worst at grain " + std::to_string(l.grain) + ")" : "");
  }
  return text.empty() ? text : text + " (see docs/how-to/stability.md; run_options::force overrides)";
}

}  // namespace pendular
