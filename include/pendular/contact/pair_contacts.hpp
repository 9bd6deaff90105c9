// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/// What a pair does to its grains, in one cache line: the second phase meets the pairs of a grain in no order.
template <bool Rotates>
struct pair_action {
  vector force;  // on the first grain, N
  double gap;    // m
};
template <>
struct alignas(64) pair_action<true> {
  vector force;   // on the first grain, N
  double gap;     // m
  vector torque;  // per lever arm, N; the same for both grains
};

/// First phase of a step: composed laws over all listed pairs, a block at a time, results stored per pair.
template <class Material, class Bonds>
class pair_contacts {
  static_assert(Material::has_friction || !Bonds::is_viscous,
                "a viscous bridge needs grains with friction, which alone can turn (docs/reference/liquid.md)");

 public:
  static constexpr bool wet = !std::is_same_v<Bonds, no_bonds>;
  static constexpr bool turns_across_gaps = Bonds::is_viscous;
  template <class T>
  using memory = typename Material::template memory<T>;

  void carry(std::span<const std::int32_t> origin, std::size_t rows) {
    memory_.carry(origin, rows);
    actions_.assign(rows, {});
    gaps_.carry(origin, rows);
    work_.carry(origin, rows);
    findings_.assign(chunk_count(rows, chunk), {});
  }

  template <class Grains>
  contact_findings evaluate(const Grains& g, const pair_list& list, const Material& material, const Bonds& bonds,
                            const contact_clock& clock) {
    gaps_.turn();
    for_chunks(list.padded_size(), chunk, [&](std::size_t begin, std::size_t end, std::size_t c) {
      contact_findings found;
      for (std::size_t p = begin; p < end; p += lane_count) {
        evaluate_block(g, list, material, bonds, clock, p, found);
      }
      findings_[c] = found;
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

  const pair_action<Material::has_friction>& action(std::size_t p) const { return actions_[p]; }

  /// Force on the first grain of a pair, N.
  const vector& force(std::size_t p) const { return actions_[p].force; }

  scalar_table<memory>& memories() { return memory_; }
  const scalar_table<memory>& memories() const { return memory_; }
  work_sums_if<Material::keeps_energy_book>& work() { return work_; }
  const work_sums_if<Material::keeps_energy_book>& work() const { return work_; }

 private:
  static constexpr std::size_t chunk = work_sums::chunk;

  template <class Grains>
  static encounter<block> meet(const Grains& g, const std::int32_t* i, const std::int32_t* j, double time_step) {
    const auto* position = g.template get<column::position>().data();
    const auto* velocity = g.template get<column::velocity>().data();
    const auto* radius = g.template get<column::radius>().data();
    const auto* inverse_mass = g.template get<column::inverse_mass>().data();
    const Vec3<block> branch = gather(position, j) - gather(position, i);
    const block distance = norm(branch);
    const block radius_i = gather(radius, i), radius_j = gather(radius, j);
    const block inverse_i = gather(inverse_mass, i), inverse_j = gather(inverse_mass, j);
    const block reduced_mass = 1.0 / (inverse_i + inverse_j);
    encounter<block> e;
    e.normal = block(1.0 / distance) * branch;
    e.velocity = gather(velocity, i) - gather(velocity, j);
    const block gap = distance - radius_i - radius_j;
    e.approaching = {gap, dot(e.velocity, e.normal), reduced_mass, radius_i, radius_j};
    if constexpr (Material::has_friction) {
      const auto* spin = g.template get<column::angular_velocity>().data();
      const Vec3<block> spin_i = gather(spin, i), spin_j = gather(spin, j);
      const block lever_i = radius_i + 0.5 * gap, lever_j = radius_j + 0.5 * gap;
      e.rolling = cross(lever_i * spin_i + lever_j * spin_j, e.normal);
      e.twist = (0.5 * time_step) * dot(spin_i + spin_j, e.normal);
      e.tangential_mass = (2.0 / 7.0) * reduced_mass;
      e.contacts = block(1);
      if constexpr (Material::counts_contacts) {
        const auto* contacts = g.template get<column::contacts>().data();
        const block weighted = gather(contacts, i) * inverse_i + gather(contacts, j) * inverse_j;
        e.contacts = max(block(weighted * reduced_mass), block(1));
      }
    }
    return e;
  }

  // Flattened, because a block passed to a function that is not inlined goes through memory.
  template <class Grains>
  PENDULAR_FLATTEN void evaluate_block(const Grains& g, const pair_list& list, const Material& material,
                                       const Bonds& bonds, const contact_clock& clock, std::size_t p,
                                       contact_findings& found) {
    const encounter<block> e = meet(g, list.first().data() + p, list.second().data() + p, clock.time_step);
    const block& gap = e.approaching.gap;
    memory<block> remembered = memory_.load_block(p);
    contact_force<block> f = touch(material, e, remembered, clock.time_step);
    if (clock.moving) memory_.store_block(p, remembered);
    block pull = block::Zero();
    if constexpr (wet) {
      pull = add_bridges(bonds, p, e, f);
      found.liquid_event |= bonds.has_event(p, gap, gaps_.before(p, gap));
    }
    const block push = f.push - pull;
    const Vec3<block> force = f.traction - push * e.normal;
    store_results(p, gap, force, e.normal, f.traction);
    const block smaller = e.approaching.radius_i.min(e.approaching.radius_j);
    found.trouble |= !((gap + clock.overlap_limit * smaller).minCoeff() > 0) ||
                     !std::isfinite((gap + force.x + force.y + force.z).sum());
    if constexpr (Material::keeps_energy_book) work_.add(p, list.size(), e, f, clock);
  }

  void store_results(std::size_t p, const block& gap, const Vec3<block>& force, const Vec3<block>& normal,
                     const Vec3<block>& traction) {
    gaps_.put(p, gap);
    for (int k = 0; k < lane_count; ++k) {
      auto& action = actions_[p + static_cast<std::size_t>(k)];
      action.force = {force.x(k), force.y(k), force.z(k)};
      action.gap = gap(k);
    }
    if constexpr (Material::has_friction) {
      const Vec3<block> torque = cross(normal, traction);
      for (int k = 0; k < lane_count; ++k) {
        actions_[p + static_cast<std::size_t>(k)].torque = {torque.x(k), torque.y(k), torque.z(k)};
      }
    }
  }

  scalar_table<memory> memory_;
  std::vector<pair_action<Material::has_friction>> actions_;
  gap_record<Bonds::forms_on_closing> gaps_;
  work_sums_if<Material::keeps_energy_book> work_;
  std::vector<contact_findings> findings_;
};

}  // namespace pendular
