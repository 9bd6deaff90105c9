// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/contact/memory.hpp>
#include <pendular/observe/indices.hpp>
#include <pendular/observe/pairs_in_order.hpp>
#include <pendular/space/grains.hpp>

#include <range/v3/numeric/accumulate.hpp>
#include <range/v3/view/transform.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace pendular::observe {

/// Where the energy of a scene is and went, J. The sum of all entries, wall work negative, stays constant.
struct energies {
  double kinetic = 0;
  double gravity = 0;           // of the heights
  double elastic = 0;           // normal contacts
  double friction_springs = 0;  // part of `friction` below that has not been lost yet; not added again
  double capillary = 0;         // at most 0: minus the work that would open the bridges
  double damping = 0;           // lost
  double friction = 0;          // lost or in friction springs
  double liquid = 0;            // set free by bridges that formed, broke or were refilled, and lost
  double walls = 0;             // work done on the grains by walls and by what drives grains

  double balance() const { return kinetic + gravity + elastic + capillary + damping + friction + liquid - walls; }
  /// Energy that went through the scene since another entry: what a residual of the balance is compared with.
  double turnover_since(const energies& e) const {
    return std::max({damping + friction + liquid - e.damping - e.friction - e.liquid, std::abs(walls - e.walls),
                     std::abs(gravity - e.gravity)});
  }
};

namespace detail {
template <class Rows, class Term>
double sum(const Rows& rows, const Term& term) {
  return ::ranges::accumulate(rows | ::ranges::views::transform(term), 0.0);
}

template <class System>
void add_motion(const System& s, energies& e) {
  const auto& g = s.particles();
  const auto velocity = g.template get<column::velocity>();
  const auto position = g.template get<column::position>();
  const auto inverse_mass = g.template get<column::inverse_mass>();
  e.kinetic =
      sum(indices(g.size()), [&](std::size_t k) { return 0.5 / inverse_mass[k] * dot(velocity[k], velocity[k]); });
  e.gravity = sum(indices(g.size()),
                  [&](std::size_t k) { return -dot(position[k], s.integrator().gravity) / inverse_mass[k]; });
  if constexpr (System::grains_type::rotate) {
    const auto spin = g.template get<column::angular_velocity>();
    const auto inverse_inertia = g.template get<column::inverse_inertia>();
    e.kinetic +=
        sum(indices(g.size()), [&](std::size_t k) { return 0.5 / inverse_inertia[k] * dot(spin[k], spin[k]); });
  }
}

template <class Material, class Memories, class Rows>
void add_springs(const Material& m, const Memories& memories, const Rows& rows, energies& e) {
  using law = typename Material::friction_law;
  if constexpr (requires(const typename Material::template memory<double> row) {
                  m.friction().energy(part_of<law>(row));
                }) {
    e.friction_springs += sum(rows, [&](std::size_t p) {
      const auto row = memories.row(p);
      return m.friction().energy(part_of<law>(row));
    });
  }
}

/// Of the spring of one contact; nothing of a law that does not know it.
template <class Material, class Row>
double elastic_energy(const Material& m, const approach<double>& a, const Row& row) {
  using law = typename Material::normal_law;
  [[maybe_unused]] const auto& memory = part_of<law>(row);
  if constexpr (requires { m.normal().energy(a, memory); } && pendular::detail::Remembers<law, double>) {
    return m.normal().energy(a, memory);
  } else if constexpr (requires { m.normal().energy(a); } && !pendular::detail::Remembers<law, double>) {
    return m.normal().energy(a);
  } else {
    return 0;
  }
}

template <class System>
void add_pairs(const System& s, energies& e) {
  const auto view = s.view();
  const auto pairs = pairs_in_order(s);
  const auto gap = s.contacts().gap();
  const auto inverse_mass = s.particles().template get<column::inverse_mass>();
  const auto& m = s.contact_material();
  e.elastic += sum(pairs, [&](std::size_t p) {
    const double reduced = 1 / (inverse_mass[view.grain_i(p)] + inverse_mass[view.grain_j(p)]);
    const approach<double> a{gap[p], 0, reduced, view.radius[view.grain_i(p)], view.radius[view.grain_j(p)]};
    return elastic_energy(m, a, s.contacts().memories().row(p));
  });
  add_springs(m, s.contacts().memories(), pairs, e);
  if constexpr (System::wet) {
    e.capillary = -sum(pairs, [&](std::size_t p) { return s.bridges().energy(p, gap[p], view); });
    e.liquid = s.bridges().work();
  }
}

/// Of the bridges at one wall. A function of its own, so that a dry system is never asked for its bridges.
template <class System, class WallContacts>
double bridge_energy_at(const System& s, const WallContacts& contacts) {
  if constexpr (WallContacts::carries_bridges) {
    const auto view = s.view();
    return sum(indices(contacts.size()),
               [&](std::size_t k) { return s.bridges().energy(contacts.bond_row(k), contacts.gap(k), view); });
  } else {
    return 0;
  }
}

template <class System>
void add_walls(const System& s, energies& e) {
  const auto radius = s.particles().template get<column::radius>();
  const auto inverse_mass = s.particles().template get<column::inverse_mass>();
  s.for_each_wall([&](const auto& wall, const auto& contacts) {
    e.walls += wall.work;
    const auto& m = s.material_of(wall);
    e.elastic += sum(indices(contacts.size()), [&](std::size_t k) {
      const std::size_t row = contacts.row(k);
      const approach<double> a{contacts.gap(k), 0, 1 / inverse_mass[row], radius[row],
                               std::numeric_limits<double>::infinity()};
      return elastic_energy(m, a, contacts.memories().row(k));
    });
    add_springs(m, contacts.memories(), indices(contacts.size()), e);
    e.capillary -= bridge_energy_at(s, contacts);
    const auto work = contacts.work().total();
    e.damping += work.damping;
    e.friction += work.friction;
  });
}
}  // namespace detail

/// Of a system whose material keeps an energy_book and whose forces have been evaluated.
template <class System>
energies energies_of(const System& s) {
  static_assert(System::material_type::keeps_energy_book,
                "an energy balance needs energy_book{} in the material (docs/reference/material.md)");
  s.expect_evaluated("observe::energies_of");
  energies e;
  detail::add_motion(s, e);
  detail::add_pairs(s, e);
  const auto work = s.contacts().work().total();
  e.damping += work.damping;
  e.friction += work.friction;
  detail::add_walls(s, e);
  e.walls += s.driven().work();
  return e;
}

}  // namespace pendular::observe
