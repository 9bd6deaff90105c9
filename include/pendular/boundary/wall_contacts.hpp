// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/load_sum.hpp>
#include <pendular/boundary/wall.hpp>
#include <pendular/contact/contact_rows.hpp>
#include <pendular/core/by_id.hpp>
#include <pendular/core/certain_sum.hpp>
#include <pendular/space/grains.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

namespace pendular::boundary {

/// A grain in contact with a wall, which plays grain j with infinite radius and mass: the way to look at the grains near
/// one wall.
template <class Grains, class Wall, class Material, bool KnowsSlip>
class wall_way {
 public:
  wall_way(const Grains& g, const Wall& wall, const Material& material, std::span<const std::int32_t> rows,
           std::size_t size, std::size_t first_bond)
      : wall_(wall), material_(material), rows_(rows.data()), size_(size), first_bond_(first_bond),
        places_(g.template rows<grain_row::place>().data()), motions_(g.template rows<grain_row::motion>().data()) {
    if constexpr (Grains::rotate) spins_ = g.template rows<grain_row::spin>().data();
  }

  std::size_t size() const { return size_; }
  const Material& material_of(std::size_t) const { return material_; }
  std::size_t bond_row(std::size_t k) const { return first_bond_ + k; }

  block inverse_mass(std::size_t k) const { return gather(motions_, rows_ + k).d; }

  separation<block> look(std::size_t k) const {
    const quad_block place = gather(places_, rows_ + k);
    const meeting<block> m = wall_.shape.meet(Vec3<block>{place.a, place.b, place.c}, place.d);
    return {m.normal, m.gap, place.d, block(std::numeric_limits<double>::infinity())};
  }

  encounter<block> meet(std::size_t k, const separation<block>& s, const block& mass, double time_step) const {
    const quad_block motion = gather(motions_, rows_ + k);
    encounter<block> e;
    e.normal = s.normal;
    e.velocity = Vec3<block>{motion.a, motion.b, motion.c} - wall_velocity(k, s);
    e.approaching = {s.gap, dot(e.velocity, e.normal), mass, s.radius_i, s.radius_j};
    if constexpr (Grains::rotate && KnowsSlip) {
      const quad_block turn = gather(spins_, rows_ + k);
      const Vec3<block> spin{turn.a, turn.b, turn.c};
      e.rolling = cross(block(s.radius_i + s.gap) * spin, e.normal);
      e.twist = (0.5 * time_step) * dot(spin, e.normal);
      e.tangential_mass = (2.0 / 7.0) * mass;
      e.contacts = block(1);
      if constexpr (Material::counts_contacts) e.contacts = max(turn.d, block(1));
    }
    return e;
  }

  /// N m; the whole of radius and gap is the lever arm.
  Vec3<block> turning(const encounter<block>& e, const Vec3<block>& traction) const {
    return block(e.approaching.radius_i + e.approaching.gap) * cross(e.normal, traction);
  }

 private:
  Vec3<block> wall_velocity(std::size_t k, const separation<block>& s) const {
    if constexpr (HasOneVelocity<decltype(wall_.drive)>) {
      const vector& v = wall_.drive.velocity;
      return {block(v.x), block(v.y), block(v.z)};
    } else {
      const quad_block place = gather(places_, rows_ + k);
      const Vec3<block> centre{place.a, place.b, place.c};
      return wall_.drive.velocity_at(Vec3<block>(centre + block(s.radius_i + s.gap) * s.normal));
    }
  }

  const Wall& wall_;
  const Material& material_;
  const std::int32_t* rows_;
  std::size_t size_, first_bond_;
  const grain_row::place* places_;
  const grain_row::motion* motions_;
  const grain_row::spin* spins_ = nullptr;
};

/// Bridges at a wall, if it is wettable.
template <class Wall, class Bonds>
using bonds_at = std::conditional_t<Wall::is_wettable, Bonds, no_bonds>;

/// The grains near one wall, as contacts. Where the wall is wettable, each of them has a row of the bonds, after those of
/// the pairs.
template <class Wall, class Material, class Bonds = no_bonds, bool Rotates = Material::has_friction,
          bool KeepsBook = Material::keeps_energy_book>
class wall_contacts : public contact_rows<Material, bonds_at<Wall, Bonds>, Rotates, KeepsBook> {
  using rows = contact_rows<Material, bonds_at<Wall, Bonds>, Rotates, KeepsBook>;

 public:
  using rows::carries_bridges;
  static_assert(
      !carries_bridges || Bonds::knows_planes,
      "a wettable wall needs capillary, rupture and viscous bridge laws with `planes` in their validity, which "
      "laws on the geometric mean radius cannot have (docs/reference/boundary.md)");

  /// Grains within range of the wall, sorted by id. `came_from[row]` is the row a grain had in the list before, or one
  /// beyond it. Answers the place that each had in the list before, or -1.
  template <class Grains>
  std::vector<std::int32_t> rebuild(const Grains& g, const Wall& w, double range,
                                    std::span<const std::size_t> came_from, bool keeps_actions = false) {
    std::vector<std::int32_t> now = grains_near(g, w, range);
    std::vector<std::int32_t> origin = places_before(now, came_from);
    count_ = now.size();
    if (count_ > 0) now.resize(padded(count_), now.back());
    grain_rows_ = std::move(now);
    rows::carry(origin, grain_rows_.size(), keeps_actions);
    return origin;
  }

  void forget_rows() {
    rows::forget_rows();
    count_ = 0;
    grain_rows_.clear();
  }

  /// Takes the next rows of the bonds, whose origin so far is `bond_origin`; `origin` is what `rebuild` answered.
  void take_bond_rows(std::span<const std::int32_t> origin, std::vector<std::int32_t>& bond_origin) {
    const auto old_first = static_cast<std::int32_t>(first_bond_);
    first_bond_ = bond_origin.size();
    for (const std::int32_t k : origin) bond_origin.push_back(k < 0 ? -1 : old_first + k);
    bond_origin.resize(first_bond_ + grain_rows_.size(), -1);
  }

  template <class Grains>
  contact_findings evaluate(const Grains& g, const Wall& w, const Material& material, const Bonds& bonds,
                            const contact_clock& clock) {
    return rows::evaluate(way_to(g, w, material), own_bonds(bonds), clock);
  }
  template <class Grains>
  contact_findings renew(const Grains& g, const Wall& w, const Material& material, const Bonds& bonds,
                         const contact_clock& clock, std::span<const std::size_t> which) {
    return rows::renew(way_to(g, w, material), own_bonds(bonds), clock, which);
  }

  /// Where the grains are to the wall now, as rows of a pair_view; `place` is that of the wall in the scene.
  template <class Grains>
  void append_rows(const Grains& g, const Wall& w, std::int32_t place, pair_view& view) const {
    view.wet_walls = true;
    view.wall_begins.push_back(view.at_walls.size());
    for (std::size_t k = 0; k < grain_rows_.size(); ++k) {
      const meeting<double> m = meet_one(g, w, k);
      view.at_walls.push_back({grain_rows_[k], k < count_ ? place : -1, m.gap, m.normal});
    }
  }

  std::size_t size() const { return count_; }
  /// Of grain k.
  std::size_t row(std::size_t k) const { return static_cast<std::size_t>(grain_rows_[k]); }
  /// Of grain k, among the bonds; where there are none, behind all of them.
  std::size_t bond_row(std::size_t k) const {
    return carries_bridges ? first_bond_ + k : std::numeric_limits<std::size_t>::max();
  }
  double gap(std::size_t k) const { return rows::gap()[k]; }

  template <class Grains>
  void recall_gaps(const Grains& g, const Wall& w) {
    for (std::size_t k = 0; k < count_; ++k) this->recall_gap(k, meet_one(g, w, k).gap);
  }

  using load_sum_type = load_sum<decltype(Wall::drive)>;

  /// What the grains do to the wall, the same to the last bit as from a load_sum.
  template <class Grains>
  wall_load load(const Grains& g, const Wall& w) const {
    if constexpr (HasOneVelocity<decltype(w.drive)>) {
      const vector force = certain_force();
      if (force.x == force.x && force.y == force.y && force.z == force.z) return {force};
    }
    std::array<reproducible_sum, load_sum_type::width> sums;
    add_load(g, w, load_sum_type(sums));
    return load_sum_type(sums).value();
  }

  /// Adds it to a sum over all parts of a scene, with the drive's turning point as the centre of the torque.
  template <class Grains>
  void add_load(const Grains& g, const Wall& w, load_sum_type sum) const {
    for (std::size_t k = 0; k < count_; ++k) {
      const vector force = -1.0 * this->force(k);
      if (force.x == 0 && force.y == 0 && force.z == 0) continue;
      sum.add(force);
      if constexpr (!HasOneVelocity<decltype(w.drive)>) {
        const vector point = contact_point(g, w, k);
        sum.add_turn(cross(point - w.drive.pivot(), force), -dot(force, w.drive.velocity_at(point)));
      }
    }
  }

 private:
  /// With no number for what is not certain.
  vector certain_force() const {
    certain_sum sum;
    for (std::size_t k = 0; k < count_; ++k) sum.add(pendular::detail::load_row(push_of(this->actions()[k])));
    return {0 - sum.value(0), 0 - sum.value(1), 0 - sum.value(2)};  // nothing is 0, not -0
  }

  const Bonds& own_bonds(const Bonds& bonds) const requires(carries_bridges) { return bonds; }
  no_bonds own_bonds(const Bonds&) const requires(!carries_bridges) { return {}; }

  template <class Grains>
  using way = wall_way<Grains, Wall, Material, Material::has_friction || bonds_at<Wall, Bonds>::is_viscous>;

  template <class Grains>
  way<Grains> way_to(const Grains& g, const Wall& w, const Material& material) const {
    return {g, w, material, grain_rows_, count_, first_bond_};
  }

  template <class Grains>
  static std::vector<std::int32_t> grains_near(const Grains& g, const Wall& w, double range) {
    const auto position = g.template get<column::position>();
    const auto radius = g.template get<column::radius>();
    std::vector<std::int32_t> within;
    for (std::size_t row = 0; row < g.kept(); ++row) {
      if (w.shape.meet(position[row], radius[row]).gap < range) within.push_back(static_cast<std::int32_t>(row));
    }
    sort_by_id(within, g.template get<column::id>());
    return within;
  }

  std::vector<std::int32_t> places_before(std::span<const std::int32_t> now,
                                          std::span<const std::size_t> came_from) const {
    std::size_t rows_before = 0;
    for (std::size_t k = 0; k < count_; ++k) rows_before = std::max(rows_before, row(k) + 1);
    std::vector<std::int32_t> place(rows_before, -1);
    for (std::size_t k = 0; k < count_; ++k) place[row(k)] = static_cast<std::int32_t>(k);
    std::vector<std::int32_t> origin(now.size(), -1);
    for (std::size_t k = 0; k < now.size(); ++k) {
      const std::size_t before = came_from[static_cast<std::size_t>(now[k])];
      if (before < place.size()) origin[k] = place[before];
    }
    return origin;
  }

  template <class Grains>
  meeting<double> meet_one(const Grains& g, const Wall& w, std::size_t k) const {
    return w.shape.meet(g.template get<column::position>()[row(k)], g.template get<column::radius>()[row(k)]);
  }
  template <class Grains>
  vector contact_point(const Grains& g, const Wall& w, std::size_t k) const {
    const meeting<double> m = meet_one(g, w, k);
    return g.template get<column::position>()[row(k)] + (g.template get<column::radius>()[row(k)] + m.gap) * m.normal;
  }

  std::size_t count_ = 0;
  std::vector<std::int32_t> grain_rows_;  // padded
  std::size_t first_bond_ = 0;
};

}  // namespace pendular::boundary
