// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/contact/force.hpp>
#include <pendular/core/as_eigen.hpp>
#include <pendular/law/stiffness.hpp>
#include <pendular/liquid/bonds.hpp>
#include <pendular/space/grains.hpp>
#include <pendular/space/pair_list.hpp>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace pendular {

/// Something a scene must keep below a bound, with the grain where it comes closest.
struct scene_limit {
  std::string what;
  double value;
  double bound;
  std::int64_t grain = -1;
  bool holds() const { return value <= bound; }
};

namespace detail {

/// Stiffness and damping that a grain's contacts add up to, and the most that one direction sees of them.
struct grain_rigidity {
  Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();  // N/m
  Eigen::Matrix3d damping = Eigen::Matrix3d::Zero();    // N s/m
  double contacts = 0;

  static double largest(const Eigen::Matrix3d& m) {
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m, Eigen::EigenvaluesOnly).eigenvalues()(2);
  }
};

/// Of dashpots at a contact that nobody remembers yet.
template <class Material>
double first_resistance(const Material& m, const approach<double>& a, double tangent) {
  typename Material::template memory<double> memory{};
  return resistance(m.damping(), a, elastic<double>{repulsion(m, a, memory), tangent},
                    part_of<typename Material::damping_law>(memory));
}

/// Tangents of the laws at one contact; a grain without contacts is measured at a touch of 1e-4 of its radius.
template <class Material>
struct contact_tangent {
  double normal, tangential, damping;

  static contact_tangent of(const Material& m, approach<double> a) {
    a.gap = std::min(a.gap, -1e-4 * std::min(a.radius_i, a.radius_j));
    a.closing_speed = 0;
    contact_tangent t{stiffness(m.normal(), a), 0, 0};
    if constexpr (Material::has_damping) {
      a.closing_speed = 1e-6;
      t.damping = std::abs(first_resistance(m, a, t.normal)) / a.closing_speed;
    }
    if constexpr (requires { m.friction().tangential_stiffness; }) t.tangential = m.friction().tangential_stiffness;
    return t;
  }
};

/// By how much the stiffness of a friction spring counts. Charged with velocities of its own time it has a dashpot
/// k_t dt / 2 beside it, and is stable as a spring of twice the stiffness: x'' = -w^2 x with this dashpot, of a lagging
/// velocity, asks for 4 >= (w dt)^2 + 2 (w dt)^2 / 2.
template <class Integration>
constexpr double spring_weight = 2 - 2 * double(Integration::velocity_lag);

template <class Material>
void add_contact(grain_rigidity& g, const contact_tangent<Material>& t, const vector& normal, double spring_weight) {
  const Eigen::Matrix3d along = as_eigen(normal) * as_eigen(normal).transpose();
  // A solid sphere answers a tangential push with translation and rotation: 7/2 of its inverse mass.
  g.stiffness += t.normal * along + 3.5 * spring_weight * t.tangential * (Eigen::Matrix3d::Identity() - along);
  g.damping += t.damping * along;
  g.contacts += 1;
}

/// What grains feel at their touching pairs, and what an isolated pair would feel.
template <class Grains, class Material>
std::vector<grain_rigidity> rigidities(const Grains& g, const pair_list& list, const Material& material,
                                       double spring_weight) {
  const auto position = g.template get<column::position>();
  const auto radius = g.template get<column::radius>();
  const auto inverse_mass = g.template get<column::inverse_mass>();
  std::vector<grain_rigidity> all(g.size());
  for (std::size_t p = 0; p < list.size(); ++p) {
    const auto i = static_cast<std::size_t>(list.first()[p]), j = static_cast<std::size_t>(list.second()[p]);
    const vector branch = position[j] - position[i];
    const double distance = norm(branch), gap = distance - radius[i] - radius[j];
    if (gap >= 0) continue;
    const approach<double> a{gap, 0, 1 / (inverse_mass[i] + inverse_mass[j]), radius[i], radius[j]};
    const auto tangent = contact_tangent<Material>::of(material, a);
    add_contact(all[i], tangent, (1 / distance) * branch, spring_weight);
    add_contact(all[j], tangent, (1 / distance) * branch, spring_weight);
  }
  for (std::size_t k = 0; k < g.size(); ++k) {
    if (all[k].contacts > 0) continue;
    const approach<double> a{0, 0, 0.5 / inverse_mass[k], radius[k], radius[k]};
    add_contact(all[k], contact_tangent<Material>::of(material, a), vector{0, 0, 1}, spring_weight);
  }
  return all;
}

/// visit(row, tangent, normal) for every grain within `reach` of a wall, as if it touched it.
template <class Grains, class Wall, class Material, class Visit>
void for_each_touch(const Grains& g, const Wall& wall, const Material& material, double reach, const Visit& visit) {
  const auto position = g.template get<column::position>();
  const auto radius = g.template get<column::radius>();
  const auto inverse_mass = g.template get<column::inverse_mass>();
  for (std::size_t row = 0; row < g.size(); ++row) {
    const auto m = wall.shape.meet(position[row], radius[row]);
    if (m.gap > reach) continue;
    const approach<double> a{m.gap, 0, 1 / inverse_mass[row], radius[row], std::numeric_limits<double>::infinity()};
    visit(row, contact_tangent<Material>::of(material, a), m.normal);
  }
}
}  // namespace detail

/// Time step against the stability limit of elastic contacts and dashpots. Twice the largest eigenvalue of a grain's
/// own stiffness over its mass bounds every frequency of the packing: (a - b)^2 <= 2 a^2 + 2 b^2 at each contact. `all`
/// is weighted for this integrator.
template <class Integration, class Grains>
scene_limit contact_step_limit(const Integration& integrator, const Grains& g,
                               const std::vector<detail::grain_rigidity>& all) {
  const auto inverse_mass = g.template get<column::inverse_mass>();
  scene_limit worst{"the time step (s), against stiffness and dashpots", integrator.time_step, HUGE_VAL};
  for (std::size_t k = 0; k < g.size(); ++k) {
    const double omega2 = 2 * inverse_mass[k] * detail::grain_rigidity::largest(all[k].stiffness);
    const double rate = 2 * inverse_mass[k] * detail::grain_rigidity::largest(all[k].damping);
    const double step = Integration::stable_step(omega2, rate);
    if (step < worst.bound) worst = {worst.what, worst.value, step, g.template get<column::id>()[k]};
  }
  return worst;
}

/// Time step against the limit of an explicit tangential viscosity, gamma_t n dt < 2 m_t (1 m_t with synchronised
/// velocities); a law that counts contacts is stable at any step.
template <class Integration, class Grains, class Material>
scene_limit viscosity_step_limit(const Integration& integrator, const Grains& g,
                                 const std::vector<detail::grain_rigidity>& all, const Material& material) {
  scene_limit worst{"the time step (s), against the explicit tangential viscosity", integrator.time_step, HUGE_VAL};
  if constexpr (requires { material.friction().tangential_viscosity; } && !Material::counts_contacts) {
    const auto inverse_mass = g.template get<column::inverse_mass>();
    for (std::size_t k = 0; k < g.size(); ++k) {
      const double rate =
          7 * inverse_mass[k] * std::max(all[k].contacts, 1.0) * material.friction().tangential_viscosity;
      const double step = Integration::stable_step(0, rate);
      if (step < worst.bound) worst = {worst.what, worst.value, step, g.template get<column::id>()[k]};
    }
  }
  return worst;
}

/// Time step against the dashpots of viscous bridges at their thinnest films: a grain feels the sum of its bridges.
template <class Integration, class Grains, class Liquid>
scene_limit bridge_viscosity_step_limit(const Integration& integrator, const Grains& g, const pair_view& view,
                                        const bonds<Liquid>& b) {
  const auto inverse_mass = g.template get<column::inverse_mass>();
  std::vector<double> sums(g.size(), 0.0);
  view.for_each_row([&](std::size_t p) {
    if (!b.is_bonded(p)) return;
    const bridge<double> closed = view.bridge_of(p, 0, b.book().bonds()[p]);
    const auto r = b.policies().viscous().resistance(closed, b.policies().substance());
    // a solid sphere answers a push with 7/2 of its inverse mass
    const double rate = std::max(r.normal, 3.5 * r.tangential);
    view.for_each_grain_of(p, [&](std::size_t grain) { sums[grain] += rate; });
  });
  scene_limit worst{"the time step (s), against the viscosity of the bridges", integrator.time_step, HUGE_VAL};
  for (std::size_t k = 0; k < g.size(); ++k) {
    const double step = Integration::stable_step(0, 2 * inverse_mass[k] * sums[k]);
    if (step < worst.bound) worst = {worst.what, worst.value, step, view.id[k]};
  }
  return worst;
}

/// Time step against a tenth of the time in which a bridge's force changes, sqrt(m / slope) at gap 0.
template <class Integration, class Grains, class Liquid>
scene_limit capillary_step_limit(const Integration& integrator, const Grains& g, const pair_view& view,
                                 const bonds<Liquid>& b) {
  const auto inverse_mass = g.template get<column::inverse_mass>();
  scene_limit worst{"the time step (s), against the slope of the capillary force", integrator.time_step, HUGE_VAL};
  view.for_each_row([&](std::size_t p) {
    if (!b.is_bonded(p)) return;
    bridge<double> opening = view.bridge_of(p, 0, b.book().bonds()[p]);
    opening.gap = 1e-9 * std::min(opening.radius_i, opening.radius_j);
    const double steepness = std::abs(slope(b.policies().law(), opening, b.policies().substance()));
    const double step = 0.1 / std::sqrt(steepness * view.sum_over_grains_of(p, inverse_mass));
    // not `<`, for a slope that is no number
    if (!(step >= worst.bound)) worst = {worst.what, worst.value, step, view.ids(p).first};
  });
  return worst;
}

}  // namespace pendular
