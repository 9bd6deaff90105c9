// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/wall.hpp>
#include <pendular/contact/clock.hpp>
#include <pendular/contact/force.hpp>
#include <pendular/contact/work_sums.hpp>
#include <pendular/core/parallel.hpp>
#include <pendular/core/scalar_table.hpp>
#include <pendular/space/grains.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pendular::boundary {

/// The grains near one wall, evaluated a block at a time like pairs; a wall plays grain j with infinite radius.
template <class Wall, class Material>
class wall_contacts {
 public:
  template <class T>
  using memory = typename Material::template memory<T>;

  /// Grains within range of the wall, sorted by id. `came_from[row]` is the row a grain had in the list before.
  template <class Grains>
  void rebuild(const Grains& g, const Wall& w, double range, std::span<const std::size_t> came_from) {
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
    force_.resize(rows_.size());
    torque_.resize(rows_.size());
    gap_.assign(rows_.size(), std::numeric_limits<double>::infinity());
    work_.carry(origin, rows_.size());
  }

  /// True if a grain overlaps the wall beyond the limit or got a force that is not finite.
  template <class Grains>
  bool evaluate(const Grains& g, const Wall& w, const Material& material, const contact_clock& clock) {
    std::vector<char> trouble(chunk_count(rows_.size(), work_sums::chunk), 0);
    for_chunks(rows_.size(), work_sums::chunk, [&](std::size_t begin, std::size_t end, std::size_t c) {
      bool any = false;
      for (std::size_t k = begin; k < end; k += lane_count) any |= evaluate_block(g, w, material, clock, k);
      trouble[c] = any ? 1 : 0;
    });
    return std::find(trouble.begin(), trouble.end(), 1) != trouble.end();
  }

  std::size_t size() const { return count_; }
  std::size_t row(std::size_t k) const { return static_cast<std::size_t>(rows_[k]); }
  const vector& force(std::size_t k) const { return force_[k]; }    // on the grain, N
  const vector& torque(std::size_t k) const { return torque_[k]; }  // on the grain, N m
  double gap(std::size_t k) const { return gap_[k]; }

  vector force_on_wall() const {
    vector sum{0, 0, 0};
    for (std::size_t k = 0; k < count_; ++k) sum -= force_[k];
    return sum;
  }

  scalar_table<memory>& memories() { return memory_; }
  const scalar_table<memory>& memories() const { return memory_; }
  work_sums_of<Material>& work() { return work_; }
  const work_sums_of<Material>& work() const { return work_; }

 private:
  template <class Grains>
  encounter<block> meet(const Grains& g, const Wall& w, const std::int32_t* rows, const vector& wall_velocity,
                        double time_step) const {
    const Vec3<block> centre = gather(g.template get<column::position>().data(), rows);
    const Vec3<block> velocity = gather(g.template get<column::velocity>().data(), rows);
    const block radius = gather(g.template get<column::radius>().data(), rows);
    const block mass = 1.0 / gather(g.template get<column::inverse_mass>().data(), rows);
    const meeting<block> m = w.shape.meet(centre, radius);
    encounter<block> e;
    e.normal = m.normal;
    e.velocity = velocity - Vec3<block>{block(wall_velocity.x), block(wall_velocity.y), block(wall_velocity.z)};
    e.approaching = {m.gap, dot(e.velocity, e.normal), mass, radius, block(std::numeric_limits<double>::infinity())};
    if constexpr (Material::has_friction) {
      const Vec3<block> spin = gather(g.template get<column::angular_velocity>().data(), rows);
      e.rolling = cross(block(radius + m.gap) * spin, e.normal);
      e.twist = (0.5 * time_step) * dot(spin, e.normal);
      e.tangential_mass = (2.0 / 7.0) * mass;
      e.contacts = block(1);
      if constexpr (Material::counts_contacts) {
        e.contacts = max(gather(g.template get<column::contacts>().data(), rows), block(1));
      }
    }
    return e;
  }

  template <class Grains>
  [[nodiscard]] bool evaluate_block(const Grains& g, const Wall& w, const Material& material,
                                    const contact_clock& clock, std::size_t k) {
    const encounter<block> e = meet(g, w, rows_.data() + k, w.drive.velocity, clock.time_step);
    memory<block> remembered = memory_.load_block(k);
    const contact_force<block> f = touch(material, e, remembered, clock.time_step);
    if (clock.moving) memory_.store_block(k, remembered);
    const Vec3<block> force = f.traction - f.push * e.normal;
    const Vec3<block> torque = block(e.approaching.radius_i + e.approaching.gap) * cross(e.normal, f.traction);
    for (int lane = 0; lane < lane_count; ++lane) {
      const std::size_t row = k + static_cast<std::size_t>(lane);
      force_[row] = {force.x(lane), force.y(lane), force.z(lane)};
      torque_[row] = {torque.x(lane), torque.y(lane), torque.z(lane)};
      gap_[row] = e.approaching.gap(lane);
    }
    if constexpr (Material::keeps_energy_book) work_.add(k, count_, e, f, clock);
    const block& gap = e.approaching.gap;
    return !((gap + clock.overlap_limit * e.approaching.radius_i).minCoeff() > 0) ||
           !std::isfinite((gap + force.x + force.y + force.z).sum());
  }

  std::size_t count_ = 0;
  std::vector<std::int32_t> rows_;
  scalar_table<memory> memory_;
  std::vector<vector> force_, torque_;
  std::vector<double> gap_;
  work_sums_of<Material> work_;
};

}  // namespace pendular::boundary
