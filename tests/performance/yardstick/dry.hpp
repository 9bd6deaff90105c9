// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "actions.hpp"

namespace yardstick {

/// The dry scene by hand: springs and dashpots along the normals, tangential springs under the Coulomb limit.
template <class Actions>
class dry_scene {
 public:
  static constexpr double tangential_stiffness = 800;  // N/m

  dry_scene(const std::vector<pendular::grain>& grains, const vector& size, const parameters& p)
      : p_(p), b_(grains, size, p), before_(b_.size()) {
    for (const quad& x : b_.place) spin_.push_back({0, 0, 0, 2.5 * b_.motion[spin_.size()].d / (x.d * x.d)});
    relist();
    evaluate();
    for (std::size_t k = 0; k < b_.size(); ++k) {
      four force, torque;
      actions_.take(b_.pairs, b_.place[k], k, force, torque);
      whole(before_[k].force) = force;
      whole(before_[k].torque) = torque;
    }
  }

  /// The second half of a step and the first half of the next go over the grains together.
  void run(int steps) {
    bool far = false;
    for (std::size_t k = 0; k < b_.size(); ++k) far |= predict(k, whole(before_[k].force), whole(before_[k].torque));
    for (int s = 1; s <= steps; ++s) {
      if (far) relist();
      evaluate();
      far = s < steps ? advance<true>() : advance<false>();
    }
  }

  const box& room() const { return b_; }

 private:
  bool predict(std::size_t k, const four& force, const four& torque) {
    const four w = whole(spin_[k]);
    whole(spin_[k]) = w + (p_.time_step * w[3]) * torque;
    return b_.predict(k, force);
  }

  template <bool GoesOn>
  bool advance() {
    bool far = false;
    for (std::size_t k = 0; k < b_.size(); ++k) {
      four force, torque;
      actions_.take(b_.pairs, b_.place[k], k, force, torque);
      b_.correct(k, force - whole(before_[k].force));
      const four w = whole(spin_[k]);
      whole(spin_[k]) = w + (0.5 * p_.time_step * w[3]) * (torque - whole(before_[k].torque));
      whole(before_[k].force) = force;
      whole(before_[k].torque) = torque;
      if (GoesOn) far |= predict(k, force, torque);
    }
    return far;
  }

  void evaluate() {
    for (std::size_t p = 0; p < b_.pairs.size(); p += pendular::lane_count) evaluate_pairs(p);
    for (std::size_t w = 0; w < wall_count; ++w) {
      for (std::size_t r = 0; r < b_.walls[w].size(); r += pendular::lane_count) evaluate_wall(w, r);
    }
  }

  /// What was stored, turned about the normal, laid into the tangent plane and loaded by this step's slip.
  lanes3 loaded(const lanes3& memory, const lanes3& n, const block& twist, const lanes3& slip) const {
    const lanes3 turned = memory + twist * cross(n, memory), laid = pendular::tangential_part(turned, n);
    const block same_length = pendular::sqrt(dot(memory, memory) / pendular::max(dot(laid, laid), block(1e-60)));
    return same_length * laid - block(tangential_stiffness * p_.time_step) * slip;
  }

  struct springs {
    std::vector<double> x, y, z;  // N
    std::vector<double> rate;     // 2 alpha sqrt(m k), kg/s
  };

  /// Force and torque per lever arm; what the springs remember is the traction itself.
  void touch(springs& s, std::size_t p, const lanes3& n, const lanes3& velocity, const lanes3& rolling,
             const block& twist, action_block& acts) const {
    const block closing = dot(velocity, n);
    const block resistance = pendular::load(s.rate.data() + p) * closing * pendular::unit_step(block(-acts.gap));
    const block push = p_.stiffness * pendular::max(block(-acts.gap), block(0.0)) + resistance;
    const lanes3 memory{pendular::load(s.x.data() + p), pendular::load(s.y.data() + p), pendular::load(s.z.data() + p)};
    const lanes3 slip = velocity - closing * n + rolling;
    const lanes3 traction = pendular::shortened_to(loaded(memory, n, twist, slip), block(p_.friction * push));
    pendular::store(s.x.data() + p, traction.x);
    pendular::store(s.y.data() + p, traction.y);
    pendular::store(s.z.data() + p, traction.z);
    acts.force = traction - push * n;
    acts.turn = cross(n, traction);
    acts.touching = block(0.0);
  }

  static void forget(springs& s, std::size_t p) {
    for (auto* column : {&s.x, &s.y, &s.z}) std::fill_n(column->data() + p, pendular::lane_count, 0.0);
  }

  PENDULAR_FLATTEN void evaluate_pairs(std::size_t p) {
    const std::int32_t *i = b_.pairs.first.data() + p, *j = b_.pairs.second.data() + p;
    const quad_block from = gather(b_.place.data(), i), to = gather(b_.place.data(), j);
    const lanes3 branch{to.a - from.a, to.b - from.b, to.c - from.c};
    const block sum = from.d + to.d, square = dot(branch, branch);
    char& busy = busy_[p / pendular::lane_count];
    if (!any(square - sum * sum < 0)) {
      if (busy != 0) forget(of_pairs_, p), actions_.put_nothing(p);
      busy = 0;
      return;
    }
    busy = 1;
    const block distance = pendular::sqrt(square), gap = distance - from.d - to.d;
    const lanes3 n = block(1 / distance) * branch;
    const quad_block vi = gather(b_.motion.data(), i), vj = gather(b_.motion.data(), j);
    const quad_block wi = gather(spin_.data(), i), wj = gather(spin_.data(), j);
    const lanes3 si{wi.a, wi.b, wi.c}, sj{wj.a, wj.b, wj.c};
    const block half = 0.5 * gap;
    action_block acts{{}, {}, gap, from.d, to.d, {}};
    touch(of_pairs_, p, n, {vi.a - vj.a, vi.b - vj.b, vi.c - vj.c},
          cross(block(from.d + half) * si + block(to.d + half) * sj, n), 0.5 * p_.time_step * dot(si + sj, n), acts);
    actions_.put(b_.pairs, p, acts);
  }

  PENDULAR_FLATTEN void evaluate_wall(std::size_t w, std::size_t r) {
    const std::int32_t* near = b_.walls[w].grain.data() + r;
    const quad_block x = gather(b_.place.data(), near);
    const std::size_t axis = w / 2;
    const block& along = axis == 0 ? x.a : axis == 1 ? x.b : x.c;
    const block gap = (w % 2 == 1 ? block(b_.edge(axis) - along) : along) - x.d;
    if (!any(gap < 0)) return forget(of_walls_[w], r);
    const quad_block v = gather(b_.motion.data(), near), s = gather(spin_.data(), near);
    const block one = block(w % 2 == 1 ? 1 : -1), zero = block(0.0);
    const lanes3 n{axis == 0 ? one : zero, axis == 1 ? one : zero, axis == 2 ? one : zero}, spin{s.a, s.b, s.c};
    action_block acts{{}, {}, gap, x.d, {}, {}};
    touch(of_walls_[w], r, n, {v.a, v.b, v.c}, cross(block(x.d + gap) * spin, n), 0.5 * p_.time_step * dot(spin, n),
          acts);
    actions_.put_wall(b_.walls[w], r, acts);
  }

  void relist() {
    const pair_rows pairs = b_.pairs;
    const std::vector<wall_rows> walls(b_.walls, b_.walls + wall_count);
    b_.relist(0);
    b_.permute(spin_), b_.permute(before_);
    actions_.relist(b_);
    busy_.assign(b_.pairs.size() / pendular::lane_count, 1);
    const auto inverse_mass = [&](std::int32_t k) { return b_.motion[static_cast<std::size_t>(k)].d; };
    follow(of_pairs_, b_.origin_of_pairs(pairs), b_.pairs.size(),
           [&](std::size_t p) { return 1 / (inverse_mass(b_.pairs.first[p]) + inverse_mass(b_.pairs.second[p])); });
    for (std::size_t w = 0; w < wall_count; ++w)
      follow(of_walls_[w], b_.origin_of_wall_rows(w, walls[w]), b_.walls[w].size(),
             [&](std::size_t r) { return 1 / inverse_mass(b_.walls[w].grain[r]); });
  }

  template <class Mass>
  void follow(springs& s, const rows& origin, std::size_t size, const Mass& mass) const {
    for (auto* column : {&s.x, &s.y, &s.z}) carry(*column, origin, size, 0.0);
    s.rate.clear();
    for (std::size_t p = 0; p < size; ++p) s.rate.push_back(2 * p_.damping * std::sqrt(mass(p) * p_.stiffness));
  }

  parameters p_;
  box b_;
  Actions actions_;
  std::vector<quad> spin_;      // angular velocity, rad/s, and inverse moment of inertia, 1/(kg m2)
  std::vector<action> before_;  // of the last step
  springs of_pairs_, of_walls_[wall_count];
  std::vector<char> busy_;
};

}  // namespace yardstick
