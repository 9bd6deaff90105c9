// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "actions.hpp"

#include <set>
#include <utility>

namespace yardstick {

/// The wet scene by hand: springs and dashpots along the normals, Eq. 12 in its stable form, bridges by Eqs. 4-11 that
/// break by Eq. 6.
template <class Actions>
class wet_scene {
 public:
  static constexpr double viscosity = 1.0, kappa = 0.4, decay = 0.9;  // eta_t in kg/s; f_0 / R in N/m; of the length

  /// V_b = alpha R^3 for the given pairs of ids.
  wet_scene(const std::vector<pendular::grain>& grains, const vector& size, const parameters& p, double alpha,
            const std::set<std::pair<std::int64_t, std::int64_t>>& bridges)
      : p_(p), b_(grains, size, p), reach_(std::cbrt(alpha) * b_.largest_radius()), spin_(b_.size()),
        before_(b_.size()) {
    for (std::size_t k = 0; k < b_.size(); ++k)
      inverse_inertia_.push_back(2.5 * b_.motion[k].d / (b_.place[k].d * b_.place[k].d));
    relist();
    for (std::size_t q = 0; q < b_.pairs.count; ++q) {
      const auto i = static_cast<std::size_t>(b_.pairs.first[q]), j = static_cast<std::size_t>(b_.pairs.second[q]);
      if (bridges.contains({b_.id[i], b_.id[j]})) make_bridge(q, alpha, b_.place[i].d, b_.place[j].d);
    }
    evaluate();
    for (std::size_t k = 0; k < b_.size(); ++k) take(k, before_[k]);
  }

  /// The second half of a step and the first half of the next go over the grains together.
  void run(int steps) {
    bool far = false;
    for (std::size_t k = 0; k < b_.size(); ++k) far |= predict(k, before_[k]);
    for (int s = 1; s <= steps; ++s) {
      if (far) relist();
      evaluate();
      far = s < steps ? advance<true>() : advance<false>();
    }
  }

  const box& room() const { return b_; }
  std::size_t bridges() const {
    const auto end = of_pairs_.rupture.begin() + static_cast<std::ptrdiff_t>(b_.pairs.count);
    return static_cast<std::size_t>(std::count_if(of_pairs_.rupture.begin(), end, [](double r) { return r > 0; }));
  }

 private:
  static constexpr char idle = 0, bridging = 1, in_contact = 2;

  /// Columns of a list of contacts.
  struct contacts {
    std::vector<double> x, y, z;                    // what Eq. 12 remembers, N
    std::vector<double> mass, rate;                 // reduced mass, kg; 2 alpha sqrt(m k), kg/s
    std::vector<double> amplitude, decay, rupture;  // of the bridges, N, 1/m, m; rupture below 0 for none
  };

  void make_bridge(std::size_t p, double alpha, double ri, double rj) {
    const double mean = std::sqrt(ri * rj), volume = alpha * mean * mean * mean;
    const double ratio = std::max(ri, rj) / std::min(ri, rj);
    of_pairs_.amplitude[p] = kappa * mean;
    of_pairs_.decay[p] = 1 / (decay * std::sqrt(0.5 * volume / ratio * (1 / ri + 1 / rj)));
    of_pairs_.rupture[p] = std::cbrt(volume);
  }

  // -- grains ---------------------------------------------------------------------------------------------------------

  /// The sum of what acts on a grain, whose spin learns the number of contacts.
  void take(std::size_t k, action& sum) {
    four force, torque;
    actions_.take(b_.pairs, b_.place[k], k, force, torque);
    spin_[k].d = torque[3];
    torque[3] = 0;
    whole(sum.force) = force;
    whole(sum.torque) = torque;
  }

  bool predict(std::size_t k, const action& sum) {
    whole(spin_[k]) += (p_.time_step * inverse_inertia_[k]) * whole(sum.torque);
    return b_.predict(k, whole(sum.force));
  }

  template <bool GoesOn>
  bool advance() {
    bool far = false;
    for (std::size_t k = 0; k < b_.size(); ++k) {
      action now;
      take(k, now);
      b_.correct(k, whole(now.force) - whole(before_[k].force));
      const four change = whole(now.torque) - whole(before_[k].torque);
      whole(spin_[k]) += (0.5 * p_.time_step * inverse_inertia_[k]) * change;
      before_[k] = now;
      if (GoesOn) far |= predict(k, now);
    }
    return far;
  }

  // -- forces ---------------------------------------------------------------------------------------------------------

  void evaluate() {
    for (std::size_t p = 0; p < b_.pairs.size(); p += pendular::lane_count) evaluate_pairs(p);
    for (std::size_t w = 0; w < wall_count; ++w) {
      for (std::size_t r = 0; r < b_.walls[w].size(); r += pendular::lane_count) evaluate_wall(w, r);
    }
  }

  static lanes3 followed(const lanes3& memory, const lanes3& n, const block& twist) {
    const lanes3 turned = memory + twist * cross(n, memory), laid = pendular::tangential_part(turned, n);
    return pendular::sqrt(dot(memory, memory) / pendular::max(dot(laid, laid), block(1e-60))) * laid;
  }

  /// Eq. 12 in its stable form; the memory is that of the contact.
  lanes3 traction(const lanes3& slip, const block& mass, const block& count, const block& push, lanes3& memory) const {
    const block mass_rate = mass / (count * p_.time_step), resistance = 0.5625 * mass_rate;
    const block limit = p_.friction * pendular::max(push, block(0.0));
    const lanes3 trial = block(viscosity / (viscosity + resistance)) * (memory - resistance * slip);
    const lanes3 elastic = slip + block(1 / viscosity) * trial;
    memory = pendular::shortened_to(lanes3(memory - block(0.0625 * mass_rate) * elastic), limit);
    return pendular::shortened_to(trial, limit);
  }

  /// How two grains meet, or a grain and a wall.
  struct meeting {
    lanes3 n, velocity, rolling;
    block twist, count, pull;
  };

  void touch(contacts& c, std::size_t p, const meeting& m, action_block& acts) const {
    const block closing = dot(m.velocity, m.n);
    acts.touching = pendular::unit_step(block(-acts.gap));
    const block push = p_.stiffness * pendular::max(block(-acts.gap), block(0.0)) +
                       pendular::load(c.rate.data() + p) * closing * acts.touching;
    lanes3 memory{pendular::load(c.x.data() + p), pendular::load(c.y.data() + p), pendular::load(c.z.data() + p)};
    memory = followed(memory, m.n, m.twist);
    const block mass = 2.0 / 7 * pendular::load(c.mass.data() + p);
    const lanes3 t = traction(m.velocity - closing * m.n + m.rolling, mass, m.count, push, memory);
    pendular::store(c.x.data() + p, memory.x);
    pendular::store(c.y.data() + p, memory.y);
    pendular::store(c.z.data() + p, memory.z);
    acts.force = t - block(push - m.pull) * m.n;
    acts.turn = cross(m.n, t);
  }

  static void forget(contacts& c, std::size_t p) {
    for (auto* column : {&c.x, &c.y, &c.z}) std::fill_n(column->data() + p, pendular::lane_count, 0.0);
  }

  block pull(std::size_t p, const block& gap) {
    const block rupture = pendular::load(of_pairs_.rupture.data() + p);
    const block alive = pendular::unit_step(block(rupture - gap));
    if (any(gap > rupture && rupture > 0)) break_bridges(p, gap);
    const block decayed = pendular::exp(-pendular::max(gap, block(0.0)) * pendular::load(of_pairs_.decay.data() + p));
    return alive * pendular::load(of_pairs_.amplitude.data() + p) * decayed;
  }

  void break_bridges(std::size_t p, const block& gap) {
    for (int lane = 0; lane < pendular::lane_count; ++lane) {
      double& rupture = of_pairs_.rupture[p + static_cast<std::size_t>(lane)];
      if (gap[lane] > rupture) rupture = -1;
    }
  }

  PENDULAR_FLATTEN void evaluate_pairs(std::size_t p) {
    const std::int32_t *i = b_.pairs.first.data() + p, *j = b_.pairs.second.data() + p;
    const quad_block from = gather(b_.place.data(), i), to = gather(b_.place.data(), j);
    const lanes3 branch{to.a - from.a, to.b - from.b, to.c - from.c};
    const block sum = from.d + to.d, square = dot(branch, branch);
    const bool touching = any(square - sum * sum < 0);
    const bool bonded = any(pendular::load(of_pairs_.rupture.data() + p) > 0);
    char& busy = busy_[p / pendular::lane_count];
    if (!touching && busy == in_contact) forget(of_pairs_, p);
    if (!touching && (busy == in_contact || (busy == bridging && !bonded))) actions_.put_nothing(p);
    busy = touching ? in_contact : bonded ? bridging : idle;
    if (busy == idle) return;
    const block distance = pendular::sqrt(square), gap = distance - from.d - to.d;
    meeting m;
    m.n = block(1 / distance) * branch;
    m.pull = bonded ? pull(p, gap) : block(0.0);
    if (!touching) return actions_.put_force(b_.pairs, p, m.pull * m.n);
    action_block acts{{}, {}, gap, from.d, to.d, {}};
    meet(i, j, acts, m);
    touch(of_pairs_, p, m, acts);
    actions_.put(b_.pairs, p, acts);
  }

  void meet(const std::int32_t* i, const std::int32_t* j, const action_block& acts, meeting& m) const {
    const quad_block vi = gather(b_.motion.data(), i), vj = gather(b_.motion.data(), j);
    const quad_block wi = gather(spin_.data(), i), wj = gather(spin_.data(), j);
    const lanes3 si{wi.a, wi.b, wi.c}, sj{wj.a, wj.b, wj.c};
    const block half = 0.5 * acts.gap;
    m.velocity = {vi.a - vj.a, vi.b - vj.b, vi.c - vj.c};
    m.rolling = cross(block(acts.radius_i + half) * si + block(acts.radius_j + half) * sj, m.n);
    m.twist = 0.5 * p_.time_step * dot(si + sj, m.n);
    m.count = pendular::max((wi.d * vi.d + wj.d * vj.d) / (vi.d + vj.d), block(1.0));
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
    touch(of_walls_[w], r,
          {n,
           {v.a, v.b, v.c},
           cross(block(x.d + gap) * spin, n),
           0.5 * p_.time_step * dot(spin, n),
           pendular::max(s.d, block(1.0)),
           zero},
          acts);
    actions_.put_wall(b_.walls[w], r, acts);
  }

  // -- lists ----------------------------------------------------------------------------------------------------------

  void relist() {
    const pair_rows pairs = b_.pairs;
    const std::vector<wall_rows> walls(b_.walls, b_.walls + wall_count);
    b_.relist(reach_);
    b_.permute(spin_), b_.permute(before_), b_.permute(inverse_inertia_);
    actions_.relist(b_);
    busy_.assign(b_.pairs.size() / pendular::lane_count, in_contact);
    const auto inverse_mass = [&](std::int32_t k) { return b_.motion[static_cast<std::size_t>(k)].d; };
    const rows origin = b_.origin_of_pairs(pairs);
    follow(of_pairs_, origin, b_.pairs.size(),
           [&](std::size_t p) { return 1 / (inverse_mass(b_.pairs.first[p]) + inverse_mass(b_.pairs.second[p])); });
    carry(of_pairs_.amplitude, origin, b_.pairs.size(), 0.0);
    carry(of_pairs_.decay, origin, b_.pairs.size(), 0.0);
    carry(of_pairs_.rupture, origin, b_.pairs.size(), -1.0);
    for (std::size_t w = 0; w < wall_count; ++w)
      follow(of_walls_[w], b_.origin_of_wall_rows(w, walls[w]), b_.walls[w].size(),
             [&](std::size_t r) { return 1 / inverse_mass(b_.walls[w].grain[r]); });
  }

  template <class Mass>
  void follow(contacts& c, const rows& origin, std::size_t size, const Mass& mass) const {
    for (auto* column : {&c.x, &c.y, &c.z}) carry(*column, origin, size, 0.0);
    c.mass.clear(), c.rate.clear();
    for (std::size_t p = 0; p < size; ++p) {
      c.mass.push_back(mass(p));
      c.rate.push_back(2 * p_.damping * std::sqrt(c.mass[p] * p_.stiffness));
    }
  }

  parameters p_;
  box b_;
  Actions actions_;
  double reach_;
  std::vector<quad> spin_;  // angular velocity, rad/s, and number of contacts
  std::vector<double> inverse_inertia_;
  std::vector<action> before_;  // of the last step
  contacts of_pairs_, of_walls_[wall_count];
  std::vector<char> busy_;  // per block: the most that one of its pairs did in the last step
};

}  // namespace yardstick
