// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/core/vec.hpp>
#include <pendular/law/inputs.hpp>
#include <pendular/liquid/bond_size.hpp>
#include <pendular/testing/report.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pendular::testing {

/// A few grains in a row with a wall at its end, their films and bridges: all that a global protocol or a source sees of a
/// scene, and what of it can go wrong. Grain k of the scene is in row `places[k]`, the pairs are stored in any order.
class small_door {
 public:
  struct neighbours {
    std::size_t i, j;  // rows of the grains; j beyond all of them at the wall
    double gap;        // m
    double volume;     // of its bridge, m3, 0 without
  };

  /// Every other pair has a bridge of `volume` (m3), every other grain a film of as much.
  small_door(double volume, double span, bool shuffled) : span_(span) {
    constexpr std::size_t count = 6;
    place_.resize(count);
    for (std::size_t k = 0; k < count; ++k) place_[k] = shuffled ? (5 * k + 3) % count : k;
    grains_.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
      const double radius = 5e-4 * (1 + 0.1 * static_cast<double>(k));
      grains_[place_[k]] = {
          static_cast<std::int64_t>(k), {1.1e-3 * static_cast<double>(k), 0, 1e-4}, radius, k % 2 == 0 ? volume : 0};
    }
    for (std::size_t k = 0; k + 1 < count; ++k) {
      pairs_.push_back({place_[k], place_[k + 1], 1e-6 * static_cast<double>(k), k % 2 == 0 ? volume : 0});
    }
    pairs_.push_back({place_[count - 1], count, 1e-6, volume});
    if (shuffled) std::reverse(pairs_.begin(), pairs_.end());
    introduced_ = here();
  }

  // What is there.
  std::size_t grains() const { return grains_.size(); }
  std::int64_t id(std::size_t grain) const { return grains_.at(grain).id; }
  const vector& position(std::size_t grain) const { return grains_.at(grain).position; }
  double radius(std::size_t grain) const { return grains_.at(grain).radius; }
  double film(std::size_t grain) const { return grains_.at(grain).film; }
  const fluid& substance() const { return water_; }
  bool is_bridged(std::size_t p) const { return pairs_.at(p).volume > 0; }
  bool is_at_wall(std::size_t p) const { return pairs_.at(p).j >= grains_.size(); }
  std::pair<std::int64_t, std::int64_t> ids(std::size_t p) const {
    return {id(pairs_.at(p).i), is_at_wall(p) ? -1 : id(pairs_.at(p).j)};
  }
  std::size_t first_grain(std::size_t p) const { return pairs_.at(p).i; }
  std::size_t second_grain(std::size_t p) const {
    if (is_at_wall(p)) trouble_ = "it asks for the second grain of a pair that is at a wall";
    return is_at_wall(p) ? pairs_[p].i : pairs_[p].j;
  }
  bridge<double> bridge_at(std::size_t p) const {
    const double own = radius(pairs_.at(p).i);
    return {pairs_[p].gap, pairs_[p].volume, own, is_at_wall(p) ? wall_radius(own) : radius(pairs_[p].j)};
  }
  template <class Visit>
  void for_each_pair(const Visit& visit) const {
    for (const std::size_t p : in_order()) visit(p);
  }
  template <class Visit>
  void for_each_bridge(const Visit& visit) const {
    for (const std::size_t p : in_order()) {
      if (is_bridged(p)) visit(p);
    }
  }
  template <class Visit>
  void for_each_grain(const Visit& visit) const {
    for (const std::size_t row : place_) visit(row);
  }
  template <class Number>
  double sum_over_grains(const Number& number) const {
    double sum = 0;
    for_each_grain([&](std::size_t grain) { sum += number(grain); });
    return sum;
  }
  template <class Number>
  double sum_over_bridges(const Number& number) const {
    double sum = 0;
    for_each_bridge([&](std::size_t p) { sum += number(p); });
    return sum;
  }
  double time_span() const { return span_; }

  // Moves within the scene.
  void from_film_to_film(std::size_t from, std::size_t to, double volume) {
    move(grains_.at(from).film, grains_.at(to).film, volume);
  }
  bool from_film_to_bridge(std::size_t grain, std::size_t p, double volume) {
    return fill(grains_.at(grain).film, p, volume);
  }
  void from_bridge_to_film(std::size_t p, std::size_t grain, double volume) {
    move(pairs_.at(p).volume, grains_.at(grain).film, volume);
  }
  void break_bridge(std::size_t p) {
    const double half = is_at_wall(p) ? pairs_[p].volume : 0.5 * pairs_[p].volume;
    move(pairs_[p].volume, grains_[pairs_[p].i].film, half);
    if (!is_at_wall(p)) move(pairs_[p].volume, grains_[pairs_[p].j].film, pairs_[p].volume);
  }
  void share_homogeneously() {
    double all = here(), sizes = 0;
    for_each_pair([&](std::size_t p) { sizes += bond_size(bridge_at(p)); });
    for (auto& g : grains_) g.film = 0;
    for (auto& p : pairs_) p.volume = 0;
    for (std::size_t p = 0; p < pairs_.size(); ++p) pairs_[p].volume = all * bond_size(bridge_at(p)) / sizes;
  }
  double homogeneous_reach() const { return 1e-5; }

  // Moves between the scene and the account of a source.
  void wet_grain(std::size_t grain, double volume) { give(grains_.at(grain).film, volume); }
  void dry_grain(std::size_t grain, double volume) { move(grains_.at(grain).film, outside_, volume); }
  bool fill_bridge(std::size_t p, double volume) {
    if (!can_hold(p, volume)) return false;
    give(pairs_.at(p).volume, volume);
    return true;
  }
  void drain_bridge(std::size_t p, double volume) { move(pairs_.at(p).volume, outside_, volume); }

  // What the kits ask.
  double here() const {
    double sum = 0;
    for (const std::size_t row : place_) sum += grains_[row].film;
    for (const std::size_t p : in_order()) sum += pairs_[p].volume;
    return sum;
  }
  double outside() const { return outside_; }        // m3, negative if it gave
  double introduced() const { return introduced_; }  // m3
  const std::string& trouble() const { return trouble_; }
  /// Films and bridges in the order of ids.
  std::vector<double> volumes() const {
    std::vector<double> all;
    for_each_grain([&](std::size_t row) { all.push_back(film(row)); });
    for_each_pair([&](std::size_t p) { all.push_back(pairs_[p].volume); });
    return all;
  }

 private:
  struct wet_sphere {
    std::int64_t id;
    vector position;  // m
    double radius;    // m
    double film;      // m3
  };

  std::vector<std::size_t> in_order() const {
    std::vector<std::size_t> order(pairs_.size());
    for (std::size_t p = 0; p < order.size(); ++p) order[p] = p;
    std::sort(order.begin(), order.end(), [&](std::size_t p, std::size_t q) { return ids(p) < ids(q); });
    return order;
  }
  bool can_hold(std::size_t p, double volume) const {
    return volume > 0 && (is_bridged(p) || volume >= 1e-6 * bond_size(bridge_at(p)));
  }
  bool fill(double& from, std::size_t p, double volume) {
    if (!can_hold(p, volume)) return false;
    move(from, pairs_.at(p).volume, volume);
    return true;
  }
  void move(double& from, double& to, double volume) {
    if (!(volume >= 0 && volume <= from)) {
      trouble_ = "it takes " + pendular::detail::number(volume) + " m3 of " + pendular::detail::number(from);
      return;
    }
    from -= volume;
    to += volume;
  }
  void give(double& to, double volume) {
    if (!(volume >= 0 && std::isfinite(volume))) {
      trouble_ = "it gives " + pendular::detail::number(volume) + " m3";
      return;
    }
    to += volume;
    outside_ -= volume;
  }

  fluid water_ = fluid::water();
  std::vector<wet_sphere> grains_;
  std::vector<neighbours> pairs_;
  std::vector<std::size_t> place_;  // by id
  double outside_ = 0, introduced_ = 0, span_;
  mutable std::string trouble_;
};

namespace detail {
/// What `act(door)` does to the small scene: wet and dry, stored in two orders, once and again.
template <class Act>
void demand_sound_acts(report& broken, const Act& act) {
  for (const double volume : {0.0, 1e-15, 1e-12}) {
    small_door plain(volume, 1e-3, false), shuffled(volume, 1e-3, true);
    for (int time = 0; time < 3; ++time) act(plain), act(shuffled);
    constexpr std::string_view property = "it must not ask for what is not there, or for what has no meaning";
    const auto known = [&](const std::string& line) { return line.starts_with(property); };
    if (std::none_of(broken.begin(), broken.end(), known)) {
      demand(broken, plain.trouble().empty(), std::string(property) + " (" + plain.trouble() + ")",
             {{"volume of a bridge or film", volume}});
    }
    const double sum = plain.here() + plain.outside();
    demand(broken, agree(sum, plain.introduced(), 1e-12, 1e-12 * plain.here() + 1e-30),
           "here and outside must be what was introduced",
           {{"here", plain.here()}, {"outside", plain.outside()}, {"introduced", plain.introduced()}});
    const std::vector<double> one = plain.volumes(), other = shuffled.volumes();
    for (std::size_t k = 0; k < one.size(); ++k) {
      demand(broken, std::isfinite(one[k]) && one[k] >= 0, "no film and no bridge may be less than nothing",
             {{"volume", one[k]}});
      demand(broken, agree(one[k], other[k], 1e-9, 1e-30), "what it does must not depend on how grains are stored",
             {{"volume", one[k]}, {"stored otherwise", other[k]}});
    }
  }
}
}  // namespace detail

}  // namespace pendular::testing
