// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/by_id.hpp>
#include <pendular/core/columns.hpp>
#include <pendular/core/expects.hpp>
#include <pendular/core/strided.hpp>
#include <pendular/core/vec.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>
#include <string>
#include <string_view>
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

/// What every grain has: the type of its value, a label and a unit, under which checkpoints and files for ParaView keep it.
/// A value is a double, a std::int64_t or a vector.
template <class T>
concept GrainTag = requires {
  typename T::type;
  { T::label } -> std::convertible_to<std::string_view>;
  { T::unit } -> std::convertible_to<std::string_view>;
  requires std::is_same_v<typename T::type, double> || std::is_same_v<typename T::type, std::int64_t> ||
      std::is_same_v<typename T::type, vector>;
};

/// Tags of one's own for the grains of a system.
template <GrainTag... Tags>
struct tags {};

namespace column {
template <class Row, auto Member>
struct member_of {
  using row = Row;
  using type = std::remove_cvref_t<decltype(std::declval<Row>().*Member)>;
  static auto& in(auto& r) { return r.*Member; }
};
struct position : member_of<grain_row::place, &grain_row::place::position> {
  static constexpr std::string_view label = "position", unit = "m";
};
struct radius : member_of<grain_row::place, &grain_row::place::radius> {
  static constexpr std::string_view label = "radius", unit = "m";
};
struct velocity : member_of<grain_row::motion, &grain_row::motion::velocity> {
  static constexpr std::string_view label = "velocity", unit = "m/s";
};
struct inverse_mass : member_of<grain_row::motion, &grain_row::motion::inverse_mass> {
  static constexpr std::string_view label = "inverse_mass", unit = "1/kg";
};
struct force : member_of<grain_row::force, &grain_row::force::force> {
  static constexpr std::string_view label = "force", unit = "N";
};
struct id {
  using type = std::int64_t;
  static constexpr std::string_view label = "id", unit = "1";
};
// Only where there is friction:
struct angular_velocity : member_of<grain_row::spin, &grain_row::spin::angular_velocity> {
  static constexpr std::string_view label = "angular_velocity", unit = "rad/s";
};
struct torque : member_of<grain_row::torque, &grain_row::torque::torque> {
  static constexpr std::string_view label = "torque", unit = "N m";
};
struct inverse_inertia : member_of<grain_row::torque, &grain_row::torque::inverse_inertia> {
  static constexpr std::string_view label = "inverse_inertia", unit = "1/(kg m2)";
};
// Only where the friction law counts contacts:
struct contacts : member_of<grain_row::spin, &grain_row::spin::contacts> {
  static constexpr std::string_view label = "contacts", unit = "1";
};
}  // namespace column

namespace detail {
template <class Row>
struct rows_of {
  using type = Row;
};
template <bool Rotates, class... Tags>
struct grain_table {
  using type =
      columns<column::id, rows_of<grain_row::place>, rows_of<grain_row::motion>, rows_of<grain_row::force>, Tags...>;
};
template <class... Tags>
struct grain_table<true, Tags...> {
  using type = columns<column::id, rows_of<grain_row::place>, rows_of<grain_row::motion>, rows_of<grain_row::force>,
                       rows_of<grain_row::spin>, rows_of<grain_row::torque>, Tags...>;
};

/// A column that is a part of a row of four numbers.
template <class Column>
concept PartOfRow = requires {
  typename Column::row;
};
}  // namespace detail

/// All grains of a scene, one row each in spatial order; the id of a grain never changes and is not given twice. A
/// frictionless scene has no rotational columns. Tags of one's own are columns as all others, 0 for a new grain.
template <bool Rotates, bool CountsContacts, GrainTag... Tags>
class grains {
  using table = typename detail::grain_table<Rotates, Tags...>::type;

 public:
  static constexpr bool rotate = Rotates;
  static constexpr bool count_contacts = CountsContacts;
  static constexpr std::size_t bytes_per_grain = table::bytes_per_row;

  template <class Column>
  static constexpr bool has = [] {
    if constexpr (std::is_same_v<Column, column::contacts>) {
      return CountsContacts;
    } else if constexpr (detail::PartOfRow<Column>) {
      return table::template has<detail::rows_of<typename Column::row>>;
    } else {
      return table::template has<Column>;
    }
  }();

  /// visit(column) for every column but the id: what makes up the state of a grain.
  template <class Visit>
  static void for_each_column(const Visit& visit) {
    visit(column::position{}), visit(column::velocity{}), visit(column::force{});
    visit(column::radius{}), visit(column::inverse_mass{});
    if constexpr (Rotates) visit(column::angular_velocity{}), visit(column::torque{}), visit(column::inverse_inertia{});
    if constexpr (CountsContacts) visit(column::contacts{});
    (visit(Tags{}), ...);
  }

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

  /// New rows are zero and must be written as a whole, with the ids that they have.
  void restore(std::span<const std::int64_t> ids, std::int64_t next_id) {
    table_ = {};
    table_.resize(ids.size());
    std::copy(ids.begin(), ids.end(), get<column::id>().begin());
    next_id_ = next_id;
  }
  /// The id that the next grain will have.
  std::int64_t next_id() const { return next_id_; }

  /// Row k becomes what was row order[k], without repetitions; rows that are not in it are no more.
  void permute(std::span<const std::size_t> order) { table_.permute(order); }

  /// Rows before this one are kept here, those from it on are copies of grains that another part of the scene keeps, or
  /// grains that were added since, of which nobody has asked yet who keeps them.
  std::size_t kept() const { return std::min(kept_, size()); }
  std::size_t copies() const { return size() - kept(); }
  void mark_copies(std::size_t copies) { kept_ = size() - copies; }

  /// Grains that nothing moves but what drives them, by row; empty if there are none.
  std::span<const char> held() const { return held_; }
  void hold(std::size_t row) {
    held_.resize(size(), 0);
    held_[row] = 1;
  }
  void release_all() { held_.clear(); }

  /// Errors: radius or density not positive and finite, position, velocity or angular velocity not finite.
  void add(const grain& g) {
    validate(g);
    const std::size_t k = size();
    table_.resize(k + 1);
    const double mass = 4.0 / 3.0 * std::numbers::pi * g.radius * g.radius * g.radius * g.density;
    rows<grain_row::place>()[k] = {g.position, g.radius};
    rows<grain_row::motion>()[k] = {g.velocity, 1.0 / mass};
    rows<grain_row::force>()[k] = {{0, 0, 0}, 0};
    get<column::id>()[k] = next_id_++;
    if constexpr (Rotates) {
      rows<grain_row::spin>()[k] = {g.angular_velocity, 0};
      rows<grain_row::torque>()[k] = {{0, 0, 0}, 2.5 / (mass * g.radius * g.radius)};
    }
  }

  /// Rows in the order of the ids: as long as no grain was taken out, entry k is that of id k.
  std::vector<std::size_t> rows_by_id() const {
    const auto ids = get<column::id>();
    std::vector<std::size_t> found(size(), size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      const auto id = static_cast<std::size_t>(ids[k]);
      if (id >= found.size()) return sorted_by_id();
      found[id] = k;
    }
    return found;
  }

  bool has_id(std::int64_t id) const {
    const auto ids = get<column::id>();
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  }

  /// 1 for the rows of those of these grains that are here.
  std::vector<char> marked(std::span<const std::int64_t> ids) const {
    std::vector<char> marks(size(), 0);
    for (const std::int64_t id : ids) {
      if (has_id(id)) marks[row_of(id)] = 1;
    }
    return marks;
  }

  /// Row of one grain. Errors: input_error if there is none of this id.
  std::size_t row_of(std::int64_t id) const {
    const auto ids = get<column::id>();
    const auto found = std::find(ids.begin(), ids.end(), id);
    if (found == ids.end()) {
      throw input_error("grain " + std::to_string(id) +
                        " is asked for, but there is none of this id: it was taken out or "
                        "never added (see docs/reference/grains.md)");
    }
    return static_cast<std::size_t>(found - ids.begin());
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
  std::vector<std::size_t> sorted_by_id() const {
    std::vector<std::size_t> rows(size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    sort_by_id(rows, get<column::id>());
    return rows;
  }

  template <class Column, class Table>
  static auto seen_as_column(Table& t) {
    if constexpr (!detail::PartOfRow<Column>) {
      return t.template get<Column>();
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
  std::int64_t next_id_ = 0;
  std::vector<char> held_;
  std::size_t kept_ = std::numeric_limits<std::size_t>::max();  // all, in a scene in one piece
};

/// Smallest and largest, m.
template <class Grains>
std::pair<double, double> extreme_radii(const Grains& g) {
  const auto r = g.template get<column::radius>();
  const auto [smallest, largest] = std::minmax_element(r.begin(), r.end());
  return {*smallest, *largest};
}

}  // namespace pendular
