// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/contact/action_row.hpp>
#include <pendular/contact/bridge_force.hpp>
#include <pendular/contact/clock.hpp>
#include <pendular/contact/findings.hpp>
#include <pendular/contact/force.hpp>
#include <pendular/contact/gap_record.hpp>
#include <pendular/contact/work_sums.hpp>
#include <pendular/core/parallel.hpp>
#include <pendular/core/scalar_table.hpp>
#include <pendular/liquid/bonds.hpp>
#include <pendular/space/grains.hpp>
#include <pendular/space/pair_list.hpp>

#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace pendular {

/// First phase of a step: composed laws over all listed pairs, a block at a time, results stored per pair.
template <class Material, class Bonds>
class pair_contacts {
  static_assert(Material::has_friction || !Bonds::is_viscous,
                "a viscous bridge needs grains with friction, which alone can turn (docs/reference/liquid.md)");

 public:
  static constexpr bool rotates = Material::has_friction;
  static constexpr bool wet = !std::is_same_v<Bonds, no_bonds>;
  template <class T>
  using memory = typename Material::template memory<T>;

  /// Follows the pairs into a new list.
  void carry(std::span<const std::int32_t> origin, std::size_t rows) {
    memory_.carry(origin, rows);
    actions_.assign(rows, {});
    busy_.assign(rows / lane_count, in_contact);
    forget_constants();
    gaps_.carry(origin, rows);
    work_.carry(origin, rows);
    findings_.assign(chunk_count(rows, chunk), {});
  }

  /// To be called when masses or material may have changed.
  void forget_constants() { constants_known_ = false; }

  template <class Grains>
  contact_findings evaluate(const Grains& g, const pair_list& list, const Material& material, const Bonds& bonds,
                            const contact_clock& clock) {
    if (!constants_known_) make_constants(g, list, material);
    gaps_.turn();
    for_chunks(list.padded_size(), chunk, [&](std::size_t begin, std::size_t end, std::size_t c) {
      lane_findings found;
      for (std::size_t p = begin; p < end; p += lane_count) {
        evaluate_block(g, list, material, bonds, clock, p, found);
      }
      findings_[c] = found.folded();
    });
    contact_findings all;
    for (const contact_findings& f : findings_) all |= f;
    return all;
  }

  /// Gaps of the last evaluation, m.
  std::span<const double> gap() const { return gaps_.now(); }
  /// The same with those of the evaluation before, which only bridges that form on closing ask for.
  gap_history gaps() const { return gaps_.history(); }

  void recall_gap(const pair_view& view) {
    for (std::size_t p = 0; p < view.pairs; ++p) gaps_.recall(p, view.gap(p));
  }

  /// Force on the first grain of a pair, N.
  vector force(std::size_t p) const { return vector_of(push_of(actions_[p])); }
  const action_row<rotates>* actions() const { return actions_.data(); }

  scalar_table<memory>& memories() { return memory_; }
  const scalar_table<memory>& memories() const { return memory_; }
  work_sums_if<Material::keeps_energy_book>& work() { return work_; }
  const work_sums_if<Material::keeps_energy_book>& work() const { return work_; }

 private:
  static constexpr std::size_t chunk = work_sums::chunk;
  static constexpr char idle = 0, bridging = 1, in_contact = 2;

  template <class Grains>
  void make_constants(const Grains& g, const pair_list& list, const Material& material) {
    const grain_row::motion* motions = g.template rows<grain_row::motion>().data();
    constants_.resize(list.padded_size());
    for_chunks(list.padded_size(), chunk, [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t p = begin; p < end; p += lane_count) {
        const quad_block i = gather(motions, list.first().data() + p), j = gather(motions, list.second().data() + p);
        constants_.store_block(p, constants_of(material, block(1.0 / (i.d + j.d))));
      }
    });
    constants_known_ = true;
  }

  struct closeness {
    Vec3<block> normal;
    block gap, radius_i, radius_j;
  };

  template <class Grains>
  static closeness look(const Grains& g, const std::int32_t* i, const std::int32_t* j) {
    const grain_row::place* places = g.template rows<grain_row::place>().data();
    const quad_block from = gather(places, i), to = gather(places, j);
    const Vec3<block> branch{to.a - from.a, to.b - from.b, to.c - from.c};
    const block distance = norm(branch);
    return {block(1.0 / distance) * branch, distance - from.d - to.d, from.d, to.d};
  }

  template <class Grains>
  static encounter<block> meet(const Grains& g, const std::int32_t* i, const std::int32_t* j, const closeness& c,
                               const block& reduced_mass, double time_step) {
    const grain_row::motion* motions = g.template rows<grain_row::motion>().data();
    const quad_block motion_i = gather(motions, i), motion_j = gather(motions, j);
    encounter<block> e;
    e.normal = c.normal;
    e.velocity = {motion_i.a - motion_j.a, motion_i.b - motion_j.b, motion_i.c - motion_j.c};
    e.approaching = {c.gap, dot(e.velocity, e.normal), reduced_mass, c.radius_i, c.radius_j};
    if constexpr (rotates) {
      const grain_row::spin* spins = g.template rows<grain_row::spin>().data();
      const quad_block turn_i = gather(spins, i), turn_j = gather(spins, j);
      const Vec3<block> spin_i{turn_i.a, turn_i.b, turn_i.c}, spin_j{turn_j.a, turn_j.b, turn_j.c};
      const block lever_i = c.radius_i + 0.5 * c.gap, lever_j = c.radius_j + 0.5 * c.gap;
      e.rolling = cross(lever_i * spin_i + lever_j * spin_j, e.normal);
      e.twist = (0.5 * time_step) * dot(spin_i + spin_j, e.normal);
      e.tangential_mass = (2.0 / 7.0) * reduced_mass;
      e.contacts = block(1);
      if constexpr (Material::counts_contacts) {
        const block weighted = turn_i.d * motion_i.d + turn_j.d * motion_j.d;
        e.contacts = max(block(weighted * reduced_mass), block(1));
      }
    }
    return e;
  }

  // Flattened, because a block passed to a function that is not inlined goes through memory.
  template <class Grains>
  PENDULAR_FLATTEN void evaluate_block(const Grains& g, const pair_list& list, const Material& material,
                                       const Bonds& bonds, const contact_clock& clock, std::size_t p,
                                       lane_findings& found) {
    const std::int32_t *i = list.first().data() + p, *j = list.second().data() + p;
    const closeness c = look(g, i, j);
    bool bonded = false;
    if constexpr (wet) {
      bonded = bonds.any_bonded(p);
      found.event = max(found.event, bonds.event(p, c.gap, gaps_.before(p, c.gap)));
    }
    gaps_.put(p, c.gap);
    char& busy = busy_[p / lane_count];
    const bool touching = any(!(c.gap >= 0));  // also if it is no number
    const bool dragging = touching || (Bonds::is_viscous && bonded);
    if (dragging || busy == in_contact) {
      busy = dragging || !clock.moving ? in_contact : bridging;  // once more, so that what contacts remember is cleared
      const contact_constants<block> made = constants_.load_block(p);
      evaluate_contacts(meet(g, i, j, c, made.reduced_mass, clock.time_step), made, list, material, bonds, clock, p,
                        found);
    } else {
      found.demand_finite(c.gap);
      if (bonded || busy != idle) evaluate_bridges(c, bonds, p, bonded, found);
      busy = bonded ? bridging : idle;
    }
  }

  /// Nobody touches and nobody did in the last step: what is left is the pull of bridges, if any.
  void evaluate_bridges(const closeness& c, const Bonds& bonds, std::size_t p, bool bonded, lane_findings& found) {
    block pull = block(0.0);
    if constexpr (wet) {
      if (bonded) pull = bonds.attraction(p, c.gap);
    }
    const Vec3<block> force = pull * c.normal;
    store_action(p, c.gap, force, {block(0.0), block(0.0), block(0.0)});
    found.demand_finite(force.x + force.y + force.z);
  }

  void evaluate_contacts(const encounter<block>& e, const contact_constants<block>& made, const pair_list& list,
                         const Material& material, const Bonds& bonds, const contact_clock& clock, std::size_t p,
                         lane_findings& found) {
    const block& gap = e.approaching.gap;
    memory<block> remembered = memory_.load_block(p);
    contact_force<block> f = touch(material, e, made.damping, remembered, clock.time_step);
    if (clock.moving) memory_.store_block(p, remembered);
    block pull = block(0.0);
    if constexpr (wet) pull = add_bridges(bonds, p, e, f);
    const block push = f.push - pull;
    const Vec3<block> force = f.traction - push * e.normal;
    Vec3<block> torque;
    if constexpr (rotates) torque = cross(e.normal, f.traction);
    store_action(p, gap, force, torque);
    const block smaller = min(e.approaching.radius_i, e.approaching.radius_j);
    found.room = min(found.room, gap + clock.overlap_limit * smaller);
    found.demand_finite(gap + force.x + force.y + force.z);
    if constexpr (Material::keeps_energy_book) work_.add(p, list.size(), e, f, clock);
  }

  void store_action(std::size_t p, const block& gap, const Vec3<block>& force, const Vec3<block>& torque) {
    const quad_block push{force.x, force.y, force.z, unit_step(block(-gap))};
    if constexpr (rotates) {
      store(actions_.data() + p, push, {torque.x, torque.y, torque.z, gap});
    } else {
      store(actions_.data() + p, push);
    }
  }

  scalar_table<memory> memory_;
  scalar_table<contact_constants> constants_;
  bool constants_known_ = false;
  std::vector<action_row<rotates>> actions_;
  std::vector<char> busy_;  // per block: the most that one of its pairs did in the last step
  gap_record<Bonds::forms_on_closing> gaps_;
  work_sums_if<Material::keeps_energy_book> work_;
  std::vector<contact_findings> findings_;
};

}  // namespace pendular
