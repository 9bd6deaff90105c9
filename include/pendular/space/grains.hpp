// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/columns.hpp>
#include <pendular/core/expects.hpp>
#include <pendular/core/strided.hpp>
#include <pendular/core/vec.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace pendular {

/// A sphere as the user gives it.
struct grain {
  vector position;                   // m
  double radius;                     // m
  double density;                    // kg/m3
  vector velocity{0, 0, 0};          // m/s
  vector angular_velocity{0, 0, 0};  // rad/s; ignored without friction
};

// Four numbers that are read and written together lie together, as pairs and integrators take them.
namespace grain_row {
struct alignas(32) place {
  vector position;  // m
  double radius;    // m
};
struct alignas(32) motion {
  vector velocity;      // m/s
  double inverse_mass;  // 1/kg
};
struct alignas(32) force {
  vector force;  // N
  double nothing;
};
struct alignas(32) spin {
  vector angular_velocity;  // rad/s
  double contacts;
};
struct alignas(32) torque {
  vector torque;           // N m
  double inverse_inertia;  // 1/(kg m2)
};
}  // namespace grain_row

namespace column {
template <class Row, auto Member>
struct member_of {
  using row = Row;
  static auto& in(auto& r) { return r.*Member; }
};
struct position : member_of<grain_row::place, &grain_row::place::position> {};
struct radius : member_of<grain_row::place, &grain_row::place::radius> {};
struct velocity : member_of<grain_row::motion, &grain_row::motion::velocity> {};
struct inverse_mass : member_of<grain_row::motion, &grain_row::motion::inverse_mass> {};
struct force : member_of<grain_row::force, &grain_row::force::force> {};
struct id {
  using type = std::int64_t;
};
// Only where there is friction:
struct angular_velocity : member_of<grain_row::spin, &grain_row::spin::angular_velocity> {};
struct torque : member_of<grain_row::torque, &grain_row::torque::torque> {};
struct inverse_inertia : member_of<grain_row::torque, &grain_row::torque::inverse_inertia> {};
// Only where the friction law counts contacts:
struct contacts : member_of<grain_row::spin, &grain_row::spin::contacts> {};
}  // namespace column

namespace detail {
template <class Row>
struct rows_of {
  using type = Row;
};
template <class... Rows>
using grain_table = columns<column::id, rows_of<Rows>...>;

template <bool Rotates>
struct grain_rows_of {
  using type = grain_table<grain_row::place, grain_row::motion, grain_row::force>;
};
template <>
struct grain_rows_of<true> {
  using type = grain_table<grain_row::place, grain_row::motion, grain_row::force, grain_row::spin, grain_row::torque>;
};
}  // namespace detail

/// All grains of a scene, one row each in spatial order; the id of a grain never changes. A frictionless scene has no
/// rotational columns.
template <bool Rotates, bool CountsContacts>
class grains {
  using table = typename detail::grain_rows_of<Rotates>::type;

 public:
  static constexpr bool rotate = Rotates;
  static constexpr bool count_contacts = CountsContacts;

  template <class Column>
  static constexpr bool has = [] {
    if constexpr (std::is_same_v<Column, column::id>) {
      return true;
    } else if constexpr (std::is_same_v<Column, column::contacts>) {
      return CountsContacts;
    } else {
      return table::template has<detail::rows_of<typename Column::row>>;
    }
  }();

  std::size_t size() const { return table_.size(); }

  /// A number or vector of all grains.
  template <class Column>
    requires(has<Column>)
  auto get() { return seen_as_column<Column>(table_); }
  template <class Column>
    requires(has<Column>)
  auto get() const { return seen_as_column<Column>(table_); }

  /// All grains in rows of four numbers.
  template <class Row>
  std::span<Row> rows() {
    return table_.template get<detail::rows_of<Row>>();
  }
  template <class Row>
  std::span<const Row> rows() const {
    return table_.template get<detail::rows_of<Row>>();
  }

  /// New rows are zero and must be written as a whole.
  void resize(std::size_t size) { table_.resize(size); }

  /// Row k becomes what was row order[k]; order must be a permutation of 0 .. size() - 1.
  void permute(std::span<const std::size_t> order) { table_.permute(order); }

  /// Errors: radius or density not positive and finite, position, velocity or angular velocity not finite.
  void add(const grain& g) {
    validate(g);
    const std::size_t k = size();
    table_.resize(k + 1);
    const double mass = 4.0 / 3.0 * std::numbers::pi * g.radius * g.radius * g.radius * g.density;
    rows<grain_row::place>()[k] = {g.position, g.radius};
    rows<grain_row::motion>()[k] = {g.velocity, 1.0 / mass};
    rows<grain_row::force>()[k] = {{0, 0, 0}, 0};
    get<column::id>()[k] = static_cast<std::int64_t>(k);
    if constexpr (Rotates) {
      rows<grain_row::spin>()[k] = {g.angular_velocity, 0};
      rows<grain_row::torque>()[k] = {{0, 0, 0}, 2.5 / (mass * g.radius * g.radius)};
    }
  }

  /// Row of every id, so that a grain can be found again after the rows were put in spatial order.
  std::vector<std::size_t> rows_by_id() const {
    std::vector<std::size_t> found(size());
    const auto ids = get<column::id>();
    for (std::size_t k = 0; k < found.size(); ++k) found[static_cast<std::size_t>(ids[k])] = k;
    return found;
  }

  /// The grain of a row as the user would give it again.
  grain operator[](std::size_t k) const {
    const auto& place = rows<grain_row::place>()[k];
    const auto& motion = rows<grain_row::motion>()[k];
    const double r = place.radius;
    grain g{place.position, r, 1.0 / motion.inverse_mass / (4.0 / 3.0 * std::numbers::pi * r * r * r), motion.velocity};
    if constexpr (Rotates) g.angular_velocity = get<column::angular_velocity>()[k];
    return g;
  }

 private:
  template <class Column, class Table>
  static auto seen_as_column(Table& t) {
    if constexpr (std::is_same_v<Column, column::id>) {
      return t.template get<column::id>();
    } else {
      const auto all = t.template get<detail::rows_of<typename Column::row>>();
      using value = std::remove_reference_t<decltype(Column::in(all[0]))>;
      return strided<value>(all.empty() ? nullptr : &Column::in(all[0]), all.size(), sizeof(typename Column::row));
    }
  }

  static void validate(const grain& g) {
    constexpr auto page = "docs/reference/grains.md";
    expects(g.radius > 0 && std::isfinite(g.radius), "the radius of a grain (m)", g.radius, "positive and finite",
            page);
    expects(g.density > 0 && std::isfinite(g.density), "the density of a grain (kg/m3)", g.density,
            "positive and finite", page);
    const double motion = dot(g.position, g.position) + dot(g.velocity, g.velocity);
    expects(std::isfinite(motion), "position or velocity of a grain", motion, "finite", page);
    const double turning = dot(g.angular_velocity, g.angular_velocity);
    expects(std::isfinite(turning), "the angular velocity of a grain (rad/s)", turning, "finite", page);
  }

  table table_;
};

/// Smallest and largest, m.
template <class Grains>
std::pair<double, double> extreme_radii(const Grains& g) {
  const auto r = g.template get<column::radius>();
  const auto [small, large] = std::minmax_element(r.begin(), r.end());
  return {*small, *large};
}

}  // namespace pendular
