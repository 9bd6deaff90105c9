// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/contact/contact_rows.hpp>
#include <pendular/space/grains.hpp>
#include <pendular/space/pair_list.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace pendular {

/// Two grains in contact: the way to look at the pairs of a list.
template <class Grains, class Material>
class pair_way {
 public:
  pair_way(const Grains& g, const pair_list& list, const Material& material)
      : first_(list.first().data()), second_(list.second().data()), size_(list.size()), material_(material),
        places_(g.template rows<grain_row::place>().data()), motions_(g.template rows<grain_row::motion>().data()),
        held_(g.held()) {
    if constexpr (Grains::rotate) spins_ = g.template rows<grain_row::spin>().data();
  }

  std::size_t size() const { return size_; }
  const Material& material_of(std::size_t) const { return material_; }
  std::size_t bond_row(std::size_t p) const { return p; }

  /// Of both together; a grain that is held has none, unless both are.
  block inverse_mass(std::size_t p) const {
    const block of_first = gather(motions_, first_ + p).d, of_second = gather(motions_, second_ + p).d;
    const block both = of_first + of_second;
    if (held_.empty()) return both;
    const block free = of_first * is_free(first_ + p) + of_second * is_free(second_ + p);
    return select(free > 0, free, both);
  }

  separation<block> look(std::size_t p) const {
    return between_spheres(gather(places_, first_ + p), gather(places_, second_ + p));
  }

  encounter<block> meet(std::size_t p, const separation<block>& s, const block& reduced_mass, double time_step) const {
    const quad_block motion_i = gather(motions_, first_ + p), motion_j = gather(motions_, second_ + p);
    encounter<block> e;
    e.normal = s.normal;
    e.velocity = {motion_i.a - motion_j.a, motion_i.b - motion_j.b, motion_i.c - motion_j.c};
    e.approaching = {s.gap, dot(e.velocity, e.normal), reduced_mass, s.radius_i, s.radius_j};
    if constexpr (Grains::rotate) {
      const quad_block turn_i = gather(spins_, first_ + p), turn_j = gather(spins_, second_ + p);
      const Vec3<block> spin_i{turn_i.a, turn_i.b, turn_i.c}, spin_j{turn_j.a, turn_j.b, turn_j.c};
      const block lever_i = s.radius_i + 0.5 * s.gap, lever_j = s.radius_j + 0.5 * s.gap;
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

  /// Per lever arm, N, which is another for each of the two.
  Vec3<block> turning(const encounter<block>& e, const Vec3<block>& traction) const {
    return cross(e.normal, traction);
  }

 private:
  block is_free(const std::int32_t* rows) const {
    return block::from([&](int lane) { return held_[static_cast<std::size_t>(rows[lane])] != 0 ? 0.0 : 1.0; });
  }

  const std::int32_t *first_, *second_;
  std::size_t size_;
  const Material& material_;
  const grain_row::place* places_;
  const grain_row::motion* motions_;
  const grain_row::spin* spins_ = nullptr;
  std::span<const char> held_;
};

/// The contacts of all listed pairs.
template <class Material, class Bonds>
class pair_contacts : public contact_rows<Material, Bonds, Material::has_friction, Material::keeps_energy_book> {
  static_assert(Material::has_friction || !Bonds::is_viscous,
                "a viscous bridge needs grains with friction, which alone can turn (docs/reference/liquid.md)");
  using rows = contact_rows<Material, Bonds, Material::has_friction, Material::keeps_energy_book>;

 public:
  static constexpr bool wet = rows::carries_bridges;

  template <class Grains>
  contact_findings evaluate(const Grains& g, const pair_list& list, const Material& material, const Bonds& bonds,
                            const contact_clock& clock) {
    return rows::evaluate(pair_way(g, list, material), bonds, clock);
  }
  template <class Grains>
  contact_findings renew(const Grains& g, const pair_list& list, const Material& material, const Bonds& bonds,
                         const contact_clock& clock, std::span<const std::size_t> which) {
    return rows::renew(pair_way(g, list, material), bonds, clock, which);
  }

  void recall_gaps(const pair_view& view) {
    for (std::size_t p = 0; p < view.pairs; ++p) this->recall_gap(p, view.gap(p));
  }
};

}  // namespace pendular
