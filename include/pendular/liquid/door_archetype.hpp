// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/vec.hpp>
#include <pendular/law/inputs.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace pendular {

/// What concepts try protocols on: the members of liquid_door. Never run.
struct liquid_door_archetype {
  std::size_t grains() const;
  std::int64_t id(std::size_t grain) const;
  const vector& position(std::size_t grain) const;
  double radius(std::size_t grain) const;
  double film(std::size_t grain) const;
  const fluid& substance() const;
  bool is_bridged(std::size_t pair) const;
  bool is_at_wall(std::size_t pair) const;
  std::pair<std::int64_t, std::int64_t> ids(std::size_t pair) const;
  std::size_t first_grain(std::size_t pair) const;
  std::size_t second_grain(std::size_t pair) const;
  bridge<double> bridge_at(std::size_t pair) const;
  template <class Visit>
  void for_each_pair(const Visit& visit) const {
    visit(std::size_t{0});
  }
  template <class Visit>
  void for_each_bridge(const Visit& visit) const {
    visit(std::size_t{0});
  }
  template <class Visit>
  void for_each_grain(const Visit& visit) const {
    visit(std::size_t{0});
  }
  template <class Number>
  double sum_over_grains(const Number& number) const {
    return number(std::size_t{0});
  }
  template <class Number>
  double sum_over_bridges(const Number& number) const {
    return number(std::size_t{0});
  }
  void from_film_to_film(std::size_t from, std::size_t to, double volume);
  bool from_film_to_bridge(std::size_t grain, std::size_t pair, double volume);
  void from_bridge_to_film(std::size_t pair, std::size_t grain, double volume);
  void break_bridge(std::size_t pair);
  void share_homogeneously();
  double homogeneous_reach() const;
};

/// What concepts try sources on: the members of outside_door.
struct outside_door_archetype : liquid_door_archetype {
  double time_span() const;
  void wet_grain(std::size_t grain, double volume);
  void dry_grain(std::size_t grain, double volume);
  bool fill_bridge(std::size_t pair, double volume);
  void drain_bridge(std::size_t pair, double volume);
};

}  // namespace pendular
