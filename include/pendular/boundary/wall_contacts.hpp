// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/wall.hpp>
#include <pendular/contact/bridge_force.hpp>
#include <pendular/contact/clock.hpp>
#include <pendular/contact/findings.hpp>
#include <pendular/contact/gap_record.hpp>
#include <pendular/contact/work_sums.hpp>
#include <pendular/core/parallel.hpp>
#include <pendular/core/quad.hpp>
#include <pendular/core/scalar_table.hpp>
#include <pendular/space/grains.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace pendular::boundary {

/// The grains near one wall, evaluated a block at a time like pairs; a wall plays grain j with infinite radius. Where
/// the wall is wettable, each of them has a row of the bonds, after those of the pairs.
template <class Wall, class Material, class Bonds = no_bonds, bool KeepsBook = Material::keeps_energy_book>
class wall_contacts {
 public:
  static constexpr bool carries_bridges = Wall::is_wettable && !std::is_same_v<Bonds, no_bonds>;
  static_assert(
      !carries_bridges || Bonds::knows_planes,
      "a wettable wall needs capillary, rupture and viscous bridge laws with `planes` in their validity, which "
      "laws on the geometric mean radius cannot have (docs/reference/boundary.md)");
  template <class T>
  using memory = typename Material::template memory<T>;

  /// Grains within range of the wall, sorted by id. `came_from[row]` is the row a grain had in the list before. Answers
  /// the place that each had in the list before, or -1.
  template <class Grains>
  std::vector<std::int32_t> rebuild(const Grains& g, const Wall& w, double range,
                                    std::span<const std::size_t> came_from) {
    const auto position = g.template get<column::position>();
    const auto radius = g.template get<column::radius>();
    const auto id = g.template get<column::id>();
    std::vector<std::int32_t> old_place(g.size(), -1);
    for (std::size_t k = 0; k < count_; ++k)
      old_place[static_cast<std::size_t>(rows_[k])] = static_cast<std::int32_t>(k);
    std::vector<std::int32_t> rows;
    for (std::size_t row = 0; row < g.size(); ++row) {
      if (w.shape.meet(position[row], radius[row]).gap < range) rows.push_back(static_cast<std::int32_t>(row));
    }
    std::sort(rows.begin(), rows.end(), [&](std::int32_t a, std::int32_t b) {
      return id[static_cast<std::size_t>(a)] < id[static_cast<std::size_t>(b)];
    });
    std::vector<std::int32_t> origin(rows.size(), -1);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const std::size_t row = came_from[static_cast<std::size_t>(rows[k])];
      if (row < old_place.size()) origin[k] = old_place[row];
    }
    count_ = rows.size();
    if (count_ > 0) rows.resize(padded(count_), rows.back());
    rows_ = std::move(rows);
    memory_.carry(origin, rows_.size());
    forget_constants();
    busy_.assign(rows_.size() / lane_count, 1);
    force_.resize(rows_.size());
    torque_.resize(rows_.size());
    gaps_.carry(origin, rows_.size());
    work_.carry(origin, rows_.size());
    findings_.assign(chunk_count(rows_.size(), work_sums::chunk), {});
    return origin;
  }

  /// To be called when masses or material may have changed.
  void forget_constants() { constants_known_ = false; }

  /// Takes the next rows of the bonds, whose origin so far is `bond_origin`; `origin` is what `rebuild` answered.
  void take_bond_rows(std::span<const std::int32_t> origin, std::vector<std::int32_t>& bond_origin) {
    const auto old_first = static_cast<std::int32_t>(first_bond_);
    first_bond_ = bond_origin.size();
    for (const std::int32_t k : origin) bond_origin.push_back(k < 0 ? -1 : old_first + k);
    bond_origin.resize(first_bond_ + rows_.size(), -1);
  }

  template <class Grains>
  contact_findings evaluate(const Grains& g, const Wall& w, const Material& material, const Bonds& bonds,
                            const contact_clock& clock) {
    if (!constants_known_) make_constants(g, material);
    gaps_.turn();
    for_chunks(rows_.size(), work_sums::chunk, [&](std::size_t begin, std::size_t end, std::size_t c) {
      lane_findings found;
      for (std::size_t k = begin; k < end; k += lane_count) evaluate_block(g, w, material, bonds, clock, k, found);
      findings_[c] = found.folded();
    });
    contact_findings all;
    for (const contact_findings& f : findings_) all |= f;
    return all;
  }

  /// Where the grains are to the wall now, as rows of a pair_view; `place` is that of the wall in the scene.
  template <class Grains>
  void append_rows(const Grains& g, const Wall& w, std::int32_t place, pair_view& view) const {
    view.wet_walls = true;
    view.wall_begins.push_back(view.at_walls.size());
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const meeting<double> m = meet_one(g, w, k);
      view.at_walls.push_back({rows_[k], k < count_ ? place : -1, m.gap, m.normal});
    }
  }

  std::size_t size() const { return count_; }
  std::size_t row(std::size_t k) const { return static_cast<std::size_t>(rows_[k]); }
  const vector& force(std::size_t k) const { return force_[k]; }    // on the grain, N
  const vector& torque(std::size_t k) const { return torque_[k]; }  // on the grain, N m
  double gap(std::size_t k) const { return gaps_.now()[k]; }
  gap_history gaps() const { return gaps_.history(); }
  /// Of grain k, among the bonds.
  std::size_t bond_row(std::size_t k) const { return first_bond_ + k; }

  template <class Grains>
  void recall_gap(const Grains& g, const Wall& w) {
    for (std::size_t k = 0; k < rows_.size(); ++k) gaps_.recall(k, meet_one(g, w, k).gap);
  }

  vector force_on_wall() const {
    vector sum{0, 0, 0};
    for (std::size_t k = 0; k < count_; ++k) sum -= force_[k];
    return sum;
  }

  scalar_table<memory>& memories() { return memory_; }
  const scalar_table<memory>& memories() const { return memory_; }
  work_sums_if<KeepsBook>& work() { return work_; }
  const work_sums_if<KeepsBook>& work() const { return work_; }

 private:
  template <class Grains>
  void make_constants(const Grains& g, const Material& material) {
    constants_.resize(rows_.size());
    for (std::size_t k = 0; k < rows_.size(); k += lane_count) {
      const quad_block motion = gather(g.template rows<grain_row::motion>().data(), rows_.data() + k);
      constants_.store_block(k, constants_of(material, block(1.0 / motion.d)));
    }
    constants_known_ = true;
  }

  template <class Grains>
  meeting<double> meet_one(const Grains& g, const Wall& w, std::size_t k) const {
    return w.shape.meet(g.template get<column::position>()[row(k)], g.template get<column::radius>()[row(k)]);
  }

  template <class Grains>
  encounter<block> meet(const Grains& g, const meeting<block>& m, const block& radius, const block& mass,
                        const std::int32_t* rows, const vector& wall_velocity, double time_step) const {
    const quad_block motion = gather(g.template rows<grain_row::motion>().data(), rows);
    const Vec3<block> velocity{motion.a, motion.b, motion.c};
    encounter<block> e;
    e.normal = m.normal;
    e.velocity = velocity - Vec3<block>{block(wall_velocity.x), block(wall_velocity.y), block(wall_velocity.z)};
    e.approaching = {m.gap, dot(e.velocity, e.normal), mass, radius, block(std::numeric_limits<double>::infinity())};
    if constexpr (Grains::rotate && (Material::has_friction || (carries_bridges && Bonds::is_viscous))) {
      const quad_block turn = gather(g.template rows<grain_row::spin>().data(), rows);
      const Vec3<block> spin{turn.a, turn.b, turn.c};
      e.rolling = cross(block(radius + m.gap) * spin, e.normal);
      e.twist = (0.5 * time_step) * dot(spin, e.normal);
      e.tangential_mass = (2.0 / 7.0) * mass;
      e.contacts = block(1);
      if constexpr (Material::counts_contacts) {
        e.contacts = max(turn.d, block(1));
      }
    }
    return e;
  }

  // Flattened, because a block passed to a function that is not inlined goes through memory.
  template <class Grains>
  PENDULAR_FLATTEN void evaluate_block(const Grains& g, const Wall& w, const Material& material, const Bonds& bonds,
                                       const contact_clock& clock, std::size_t k, lane_findings& found) {
    const quad_block place = gather(g.template rows<grain_row::place>().data(), rows_.data() + k);
    const block& radius = place.d;
    const meeting<block> m = w.shape.meet(Vec3<block>{place.a, place.b, place.c}, radius);
    const block& gap = m.gap;
    gaps_.put(k, gap);
    char& busy = busy_[k / lane_count];
    const bool touching = carries_bridges || any(!(gap >= 0));
    if (!touching && busy == 0) return found.demand_finite(gap);
    busy = touching || !clock.moving ? 1 : 0;  // once more after parting, so that memory and forces are cleared
    const contact_constants<block> made = constants_.load_block(k);
    const encounter<block> e =
        meet(g, m, radius, made.reduced_mass, rows_.data() + k, w.drive.velocity, clock.time_step);
    memory<block> remembered = memory_.load_block(k);
    contact_force<block> f = touch(material, e, made.damping, remembered, clock.time_step);
    if (clock.moving) memory_.store_block(k, remembered);
    block pull = block(0.0);
    if constexpr (carries_bridges) {
      pull = add_bridges(bonds, bond_row(k), e, f);
      found.event = max(found.event, bonds.event(bond_row(k), gap, gaps_.before(k, gap)));
    }
    const Vec3<block> force = f.traction - block(f.push - pull) * e.normal;
    const Vec3<block> torque = block(e.approaching.radius_i + e.approaching.gap) * cross(e.normal, f.traction);
    put_rows(force_.data() + k, force);
    put_rows(torque_.data() + k, torque);
    if constexpr (KeepsBook) work_.add(k, count_, e, f, clock);
    found.room = min(found.room, gap + clock.overlap_limit * radius);
    found.demand_finite(gap + force.x + force.y + force.z);
  }

  static void put_rows(vector* rows, const Vec3<block>& v) {
    quad four[lane_count];
    store(four, {v.x, v.y, v.z, block(0.0)});
    for (int lane = 0; lane < lane_count; ++lane) rows[lane] = {four[lane].a, four[lane].b, four[lane].c};
  }

  std::size_t count_ = 0;
  std::vector<std::int32_t> rows_;
  scalar_table<memory> memory_;
  scalar_table<contact_constants> constants_;
  bool constants_known_ = false;
  std::vector<char> busy_;  // per block: whether one of its grains touched in the last step
  std::vector<vector> force_, torque_;
  gap_record<carries_bridges && Bonds::forms_on_closing> gaps_;
  work_sums_if<KeepsBook> work_;
  std::vector<contact_findings> findings_;
  std::size_t first_bond_ = 0;
};

}  // namespace pendular::boundary
