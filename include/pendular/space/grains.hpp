// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/columns.hpp>
#include <pendular/core/expects.hpp>
#include <pendular/core/vec.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <type_traits>

namespace pendular {

/// A sphere as the user gives it.
struct grain {
  vector position;                   // m
  double radius;                     // m
  double density;                    // kg/m3
  vector velocity{0, 0, 0};          // m/s
  vector angular_velocity{0, 0, 0};  // rad/s; ignored without friction
};

namespace column {
struct position {
  using type = vector;
};
struct velocity {
  using type = vector;
};
struct force {
  using type = vector;
};
struct radius {
  using type = double;
};
struct inverse_mass {
  using type = double;
};
struct id {
  using type = std::int64_t;
};
// Only where there is friction:
struct angular_velocity {
  using type = vector;
};
struct torque {
  using type = vector;
};
struct inverse_inertia {
  using type = double;
};
// Only where the friction law counts contacts:
struct contacts {
  using type = double;
};
}  // namespace column

namespace detail {
template <bool Rotates, bool CountsContacts>
struct grain_columns;
template <>
struct grain_columns<false, false> {
  using type =
      columns<column::position, column::velocity, column::force, column::radius, column::inverse_mass, column::id>;
};
template <>
struct grain_columns<true, false> {
  using type = columns<column::position, column::velocity, column::force, column::radius, column::inverse_mass,
                       column::id, column::angular_velocity, column::torque, column::inverse_inertia>;
};
template <>
struct grain_columns<true, true> {
  using type = columns<column::position, column::velocity, column::force, column::radius, column::inverse_mass,
                       column::id, column::angular_velocity, column::torque, column::inverse_inertia, column::contacts>;
};
}  // namespace detail

/// All grains of a scene, one row each in spatial order; the id of a grain never changes. A frictionless scene has no
/// rotational columns.
template <bool Rotates, bool CountsContacts>
class grains : public detail::grain_columns<Rotates, CountsContacts>::type {
 public:
  static constexpr bool rotate = Rotates;
  static constexpr bool count_contacts = CountsContacts;

  /// Errors: radius or density not positive and finite, position, velocity or angular velocity not finite.
  void add(const grain& g) {
    validate(g);
    const std::size_t row = this->size();
    this->resize(row + 1);
    const double mass = 4.0 / 3.0 * std::numbers::pi * g.radius * g.radius * g.radius * g.density;
    this->template get<column::position>()[row] = g.position;
    this->template get<column::velocity>()[row] = g.velocity;
    this->template get<column::force>()[row] = {0, 0, 0};
    this->template get<column::radius>()[row] = g.radius;
    this->template get<column::inverse_mass>()[row] = 1.0 / mass;
    this->template get<column::id>()[row] = static_cast<std::int64_t>(row);
    if constexpr (Rotates) {
      this->template get<column::angular_velocity>()[row] = g.angular_velocity;
      this->template get<column::torque>()[row] = {0, 0, 0};
      this->template get<column::inverse_inertia>()[row] = 2.5 / (mass * g.radius * g.radius);
    }
    if constexpr (CountsContacts) this->template get<column::contacts>()[row] = 0;
  }

  /// Row of every id, so that a grain can be found again after the rows were put in spatial order.
  std::vector<std::size_t> rows_by_id() const {
    std::vector<std::size_t> rows(this->size());
    const auto ids = this->template get<column::id>();
    for (std::size_t row = 0; row < rows.size(); ++row) rows[static_cast<std::size_t>(ids[row])] = row;
    return rows;
  }

  /// The grain of a row as the user would give it again.
  grain operator[](std::size_t row) const {
    const double radius = this->template get<column::radius>()[row];
    const double mass = 1.0 / this->template get<column::inverse_mass>()[row];
    grain g{this->template get<column::position>()[row], radius,
            mass / (4.0 / 3.0 * std::numbers::pi * radius * radius * radius),
            this->template get<column::velocity>()[row]};
    if constexpr (Rotates) g.angular_velocity = this->template get<column::angular_velocity>()[row];
    return g;
  }

 private:
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
};

}  // namespace pendular
