// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "forces.hpp"

namespace yardstick {

/// The dry scene without friction by hand: springs and dashpots along the normals, nothing that turns or remembers.
template <class Forces>
class smooth_scene {
 public:
  smooth_scene(const std::vector<pendular::grain>& grains, const vector& size, const parameters& p)
      : p_(p), b_(grains, size, p), before_(b_.size()) {
    relist();
    evaluate();
    for (std::size_t k = 0; k < b_.size(); ++k) forces_.take(b_.pairs, k, whole(before_[k]));
  }

  /// The second half of a step and the first half of the next go over the grains together.
  void run(int steps) {
    bool far = false;
    for (std::size_t k = 0; k < b_.size(); ++k) far |= b_.predict(k, whole(before_[k]));
    for (int s = 1; s <= steps; ++s) {
      if (far) relist();
      evaluate();
      far = s < steps ? advance<true>() : advance<false>();
    }
  }

  const box& room() const { return b_; }

 private:
  template <bool GoesOn>
  bool advance() {
    bool far = false;
    for (std::size_t k = 0; k < b_.size(); ++k) {
      four now;
      forces_.take(b_.pairs, k, now);
      b_.correct(k, now - whole(before_[k]));
      whole(before_[k]) = now;
      if (GoesOn) far |= b_.predict(k, now);
    }
    return far;
  }

  void evaluate() {
    for (std::size_t p = 0; p < b_.pairs.size(); p += pendular::lane_count) evaluate_pairs(p);
    for (std::size_t w = 0; w < wall_count; ++w) evaluate_wall(w);
  }

  PENDULAR_FLATTEN void evaluate_pairs(std::size_t p) {
    const std::int32_t *i = b_.pairs.first.data() + p, *j = b_.pairs.second.data() + p;
    const quad_block from = gather(b_.place.data(), i), to = gather(b_.place.data(), j);
    const lanes3 branch{to.a - from.a, to.b - from.b, to.c - from.c};
    const block touch = from.d + to.d, square = dot(branch, branch);
    if (!any(square - touch * touch < 0)) return forces_.put_nothing(p);
    const block distance = pendular::sqrt(square), gap = distance - from.d - to.d;
    const lanes3 n = block(1 / distance) * branch;
    const quad_block vi = gather(b_.motion.data(), i), vj = gather(b_.motion.data(), j);
    const block closing = dot(lanes3{vi.a - vj.a, vi.b - vj.b, vi.c - vj.c}, n);
    const block resistance = pendular::load(rate_.data() + p) * closing * pendular::unit_step(block(-gap));
    forces_.put(b_.pairs, p, block(-(p_.stiffness * pendular::max(block(-gap), block(0.0)) + resistance)) * n);
  }

  void evaluate_wall(std::size_t w) {
    const std::size_t axis = w / 2;
    const double out = w % 2 == 1 ? 1 : -1, edge = w % 2 == 1 ? b_.edge(axis) : 0;
    for (std::size_t r = 0; r < b_.walls[w].count; ++r) {
      const auto k = static_cast<std::size_t>(b_.walls[w].grain[r]);
      const quad &x = b_.place[k], &v = b_.motion[k];
      const double gap = out * (edge - (&x.a)[axis]) - x.d;
      if (gap < 0) forces_.along(axis, k) -= out * (p_.stiffness * -gap + wall_rate_[w][r] * (out * (&v.a)[axis]));
    }
  }

  /// 2 alpha sqrt(m k), kg/s, is the same as long as the list is.
  void relist() {
    b_.relist(0);
    b_.permute(before_);
    forces_.relist(b_);
    const auto inverse_mass = [&](std::int32_t k) { return b_.motion[static_cast<std::size_t>(k)].d; };
    const auto rate = [&](double mass) { return 2 * p_.damping * std::sqrt(mass * p_.stiffness); };
    rate_.clear();
    for (std::size_t p = 0; p < b_.pairs.size(); ++p)
      rate_.push_back(rate(1 / (inverse_mass(b_.pairs.first[p]) + inverse_mass(b_.pairs.second[p]))));
    for (std::size_t w = 0; w < wall_count; ++w) {
      wall_rate_[w].clear();
      for (const std::int32_t k : b_.walls[w].grain) wall_rate_[w].push_back(rate(1 / inverse_mass(k)));
    }
  }

  parameters p_;
  box b_;
  Forces forces_;
  std::vector<quad> before_;  // force of the last step, N
  std::vector<double> rate_, wall_rate_[wall_count];
};

}  // namespace yardstick
