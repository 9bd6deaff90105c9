// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/wall.hpp>
#include <pendular/boundary/wall_contacts_of.hpp>
#include <pendular/boundary/wet_rows.hpp>
#include <pendular/contact/pair_contacts.hpp>
#include <pendular/contact/trouble.hpp>
#include <pendular/contact/wall_loads.hpp>
#include <pendular/liquid/redistribution.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace pendular {

/// In place of a liquid: a dry scene.
using dry = none;
template <class L>
concept LiquidOrNone = std::is_same_v<L, dry> || requires {
  typename L::capillary_law;
};

namespace detail {
template <class Liquid>
struct bonds_of {
  using type = bonds<Liquid>;
};
template <>
struct bonds_of<dry> {
  using type = no_bonds;
};
}  // namespace detail

/// Everything of a scene that has a row per pair or per grain near a wall: contacts, walls, loads and bridges, and what
/// they do to the grains in a step. Whoever owns the grains, lists the pairs and moves them: this is the same.
template <class Material, class Liquid, class Boundary>
class scene_rows {
 public:
  static constexpr bool wet = !std::is_same_v<Liquid, dry>;
  using bonds_type = typename detail::bonds_of<Liquid>::type;
  using contacts_type = pair_contacts<Material, bonds_type>;
  using wall_contacts_type = typename detail::wall_contacts_of<Material, bonds_type, Boundary>::type;

  scene_rows(const Material& m, const Liquid& l, const Boundary& b) : material_(m), walls_(b), bonds_(l) {
    check_walls();
  }

  const Material& material() const { return material_; }
  Material& material() { return material_; }
  const Boundary& walls() const { return walls_; }
  Boundary& walls() { return walls_; }
  const contacts_type& contacts() const { return contacts_; }
  contacts_type& contacts() { return contacts_; }
  const bonds_type& bridges() const { return bonds_; }
  bonds_type& bridges() { return bonds_; }

  /// The wall's own material, or the grains'.
  template <class Wall>
  const auto& material_of(const Wall& wall) const {
    if constexpr (std::is_same_v<decltype(Wall::material), none>) {
      return material_;
    } else {
      return wall.material;
    }
  }

  /// visit(wall, its contacts) for all walls in the order they were given.
  template <class Visit>
  void for_each_wall(const Visit& visit) {
    for_each_wall_of(*this, visit);
  }
  template <class Visit>
  void for_each_wall(const Visit& visit) const {
    for_each_wall_of(*this, visit);
  }

  /// The listed pairs, and the grains near wettable walls, as liquid and observers see them.
  template <class Grains>
  pair_view view(const Grains& g, const pair_list& list, const vector& up) const {
    pair_view v{list.first(),
                list.second(),
                list.size(),
                g.template get<column::position>(),
                g.template get<column::radius>(),
                g.template get<column::id>(),
                up,
                g.kept()};
    if constexpr (wet) boundary::append_wet_rows(*this, g, v);
    return v;
  }

  /// Masses and materials may have been changed by hand.
  void forget_constants() {
    contacts_.forget_constants();
    for_each_wall([&](const auto&, auto& contacts) { contacts.forget_constants(); });
  }

  /// How the rows of a new list follow from those of the old.
  struct relisting {
    std::span<const std::int32_t> pair_origin;  // of every pair, or -1
    std::span<const std::size_t> came_from;     // of every grain, or one beyond the grains that were
    double range, skin;                         // m
    bool keeps_actions;                         // where nobody evaluates all forces at once
  };

  /// Follows the grains into a new list. A grain that was not there has no row that it came from.
  template <class Grains>
  void relist(const Grains& g, const pair_list& list, const vector& up, const relisting& r) {
    contacts_.carry(r.pair_origin, list.padded_size(), r.keeps_actions);
    std::vector<std::int32_t> bond_origin(r.pair_origin.begin(), r.pair_origin.end());
    bond_origin.resize(list.padded_size(), -1);
    loads_.relist(g.size());
    for_each_wall([&](const auto& wall, auto& contacts) {
      constexpr bool bridged = std::remove_cvref_t<decltype(contacts)>::carries_bridges;
      const auto places = contacts.rebuild(g, wall, bridged ? r.range : r.skin, r.came_from, r.keeps_actions);
      if constexpr (bridged) contacts.take_bond_rows(places, bond_origin);
      loads_.list(contacts);
    });
    if constexpr (wet) {
      bonds_.permute_films(r.came_from);
      bonds_.carry(bond_origin, view(g, list, up));
    }
  }

  /// All forces; what walls feel is told to them.
  template <class Grains, Host H = alone>
  contact_findings evaluate(const Grains& g, const pair_list& list, const contact_clock& clock, const H& host = {}) {
    contact_findings found = contacts_.evaluate(g, list, material_, bonds_, clock);
    for_each_wall(
        [&](auto& wall, auto& contacts) { found |= contacts.evaluate(g, wall, material_of(wall), bonds_, clock); });
    expect_no_trouble(found, g, list, clock, host);
    load_walls(g, clock, host);
    return found;
  }

  /// The forces of rows that are new or whose bridge has changed, as they stand; all others stay to the last bit.
  template <class Grains, Host H = alone>
  contact_findings renew(const Grains& g, const pair_list& list, const contact_clock& clock, const H& host = {}) {
    const std::vector<std::size_t> changed = changed_bridges();
    contact_findings found = contacts_.renew(g, list, material_, bonds_, clock, part(changed, 0, list.padded_size()));
    for_each_wall([&](auto& wall, auto& contacts) {
      const auto here_changed = part(changed, contacts.bond_row(0), contacts.bond_row(contacts.size()));
      found |= contacts.renew(g, wall, material_of(wall), bonds_, clock, here_changed);
    });
    expect_no_trouble(found, g, list, clock, host);
    load_walls(g, clock, host);
    return found;
  }

  /// Takes gaps from where the grains are.
  template <class Grains>
  void canonicalise(const Grains& g, const pair_view& view) {
    contacts_.recall_gaps(view);
    for_each_wall([&](auto& wall, auto& contacts) { contacts.recall_gaps(g, wall); });
  }

  const wall_loads<Material::has_friction>& loads() const { return loads_; }

  /// Nothing is left of the rows, because all grains and what their rows remember are put back by hand.
  void forget_rows(std::size_t grains) {
    contacts_.forget_rows();
    for_each_wall([](auto&, auto& contacts) { contacts.forget_rows(); });
    if constexpr (wet) bonds_.forget_rows(grains);
  }

 private:
  void check_walls() const {
    if constexpr (requires { validate(walls_); }) validate(walls_);
  }
  template <class Grains, Host H>
  void expect_no_trouble(const contact_findings& found, const Grains& g, const pair_list& list,
                         const contact_clock& clock, const H& host) const {
    together(host, [&] {
      if (!found.trouble) return;
      report_pair_trouble(g, list, contacts_, clock.overlap_limit, clock.step);
      std::size_t number = 0;
      for_each_wall([&](const auto&, const auto& contacts) {
        report_wall_trouble(g, contacts, number++, clock.overlap_limit, clock.step);
      });
      report_hidden_trouble(clock.step);
    });
  }

  /// What the grains of all parts of a scene do to the walls, and walls to the grains.
  template <class Grains, Host H>
  void load_walls(const Grains& g, const contact_clock& clock, const H& host) {
    loads_.clear();
    for_each_wall([&](const auto&, auto& contacts) { loads_.add(contacts); });
    const double time_step = clock.moving ? clock.time_step : 0;
    if constexpr (is_distributed<H>) {
      take_joined_loads(g, time_step, host);
    } else {
      for_each_wall([&](auto& wall, auto& contacts) { wall.take(contacts.load(g, wall), time_step); });
    }
  }

  /// The sums of all walls are joined at once.
  template <class Grains, Host H>
  void take_joined_loads(const Grains& g, double time_step, const H& host) {
    std::vector<reproducible_sum> sums;
    for_each_wall([&](const auto& wall, auto& contacts) {
      using load_sum = typename std::remove_cvref_t<decltype(contacts)>::load_sum_type;
      sums.resize(sums.size() + load_sum::width);
      contacts.add_load(g, wall, load_sum(std::span(sums).last(load_sum::width)));
    });
    host.sum(sums);
    std::size_t first = 0;
    for_each_wall([&](auto& wall, auto& contacts) {
      using load_sum = typename std::remove_cvref_t<decltype(contacts)>::load_sum_type;
      wall.take(load_sum(std::span(sums).subspan(first, load_sum::width)).value(), time_step);
      first += load_sum::width;
    });
  }

  std::vector<std::size_t> changed_bridges() {
    if constexpr (wet) {
      return bonds_.changed_rows();
    } else {
      return {};
    }
  }
  /// The rows in [begin, end), counted from its begin.
  static std::vector<std::size_t> part(const std::vector<std::size_t>& rows, std::size_t begin, std::size_t end) {
    std::vector<std::size_t> inside;
    for (const std::size_t p : rows) {
      if (begin <= p && p < end) inside.push_back(p - begin);
    }
    return inside;
  }

  template <class Self, class Visit>
  static void for_each_wall_of(Self& self, const Visit& visit) {
    auto&& walls = self.walls_.parts();
    constexpr auto count = std::tuple_size_v<std::remove_cvref_t<decltype(walls)>>;
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (visit(std::get<I>(walls), std::get<I>(self.wall_contacts_)), ...);
    }
    (std::make_index_sequence<count>{});
  }

  Material material_;
  Boundary walls_;
  contacts_type contacts_;
  wall_contacts_type wall_contacts_;
  wall_loads<Material::has_friction> loads_;
  [[no_unique_address]] bonds_type bonds_;
};

}  // namespace pendular
