// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/motion/advance.hpp>
#include <pendular/space/grains.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pendular {

/// A grain whose motion is prescribed.
struct driven_grain {
  std::int64_t id;
  vector velocity;          // m/s
  vector angular_velocity;  // rad/s; ignored without friction
};

/// The grains of a scene whose motion is prescribed, and the work that prescribing it does. In contacts they are infinitely
/// heavy, as walls are.
class driven_grains {
 public:
  const std::vector<driven_grain>& all() const { return all_; }
  bool empty() const { return all_.empty(); }
  double work() const { return work_; }  // on the grains since the start, J
  double fastest() const {               // m/s
    double speed = 0;
    for (const driven_grain& d : all_) speed = std::max(speed, norm(d.velocity));
    return speed;
  }

  /// Errors: a grain that is driven already, a velocity that is not finite.
  void add(const driven_grain& d) {
    constexpr auto page = "docs/reference/grains.md";
    if (is_driven(d.id)) {
      throw input_error("grain " + std::to_string(d.id) + " is driven already: release it first (see " + page + ")");
    }
    const double motion = dot(d.velocity, d.velocity) + dot(d.angular_velocity, d.angular_velocity);
    expects(std::isfinite(motion), "the velocity of a driven grain", motion, "finite", page);
    all_.push_back(d);
    std::sort(all_.begin(), all_.end(), [](const driven_grain& a, const driven_grain& b) { return a.id < b.id; });
  }
  /// Errors: a grain that is not driven.
  void remove(std::int64_t id) {
    if (!is_driven(id)) {
      throw input_error("grain " + std::to_string(id) +
                        " is released, but is not driven (see docs/reference/grains.md)");
    }
    std::erase_if(all_, [&](const driven_grain& d) { return d.id == id; });
  }
  bool is_driven(std::int64_t id) const {
    return std::any_of(all_.begin(), all_.end(), [&](const driven_grain& d) { return d.id == id; });
  }
  void restore(std::vector<driven_grain> all, double work) {
    all_ = std::move(all);
    work_ = work;
  }

  /// Finds their rows again, after grains have changed theirs.
  template <class Grains>
  void find(Grains& g) {
    here_.clear();
    g.release_all();
    for (std::size_t k = 0; k < all_.size(); ++k) {
      if (!g.has_id(all_[k].id)) continue;  // on another part of the scene
      here_.push_back({k, g.row_of(all_[k].id)});
      g.hold(here_.back().row);
    }
  }

  /// Gives one of them its velocity at once.
  template <class Grains>
  void set_off(Grains& g, const driven_grain& d) const {
    if (!g.has_id(d.id)) return;
    const std::size_t row = g.row_of(d.id);
    g.template rows<grain_row::motion>()[row].velocity = d.velocity;
    if constexpr (Grains::rotate) g.template rows<grain_row::spin>()[row].angular_velocity = d.angular_velocity;
    if constexpr (Grains::count_contacts) g.template rows<grain_row::spin>()[row].contacts = 0;
  }

  /// Before grains are moved.
  template <class Grains>
  void remember(const Grains& g) {
    before_.clear();
    for (const auto& [which, row] : here_) {
      before_.push_back(
          {g.template rows<grain_row::place>()[row].position, g.template rows<grain_row::force>()[row].force});
    }
  }

  /// After the second half of a step, the first half of the next, or both. True if one of them is too far from where it was
  /// listed.
  template <class Grains>
  bool impose(Grains& g, const vector& gravity, double time_step, bool corrected, bool predicted,
              const listing& listed) {
    bool away = false;
    for (std::size_t k = 0; k < here_.size(); ++k) {
      const std::size_t row = here_[k].row;
      const driven_grain& d = all_[here_[k].which];
      auto& place = g.template rows<grain_row::place>()[row];
      place.position = before_[k].position;
      if (predicted) place.position += time_step * d.velocity;
      g.template rows<grain_row::motion>()[row].velocity = d.velocity;
      if constexpr (Grains::rotate) g.template rows<grain_row::spin>()[row].angular_velocity = d.angular_velocity;
      // Contacts are weighted by inverse masses, and this is infinitely heavy.
      if constexpr (Grains::count_contacts) g.template rows<grain_row::spin>()[row].contacts = 0;
      if (corrected && row < g.kept()) add_work(g, k, gravity, time_step);
      away |= !(norm(place.position - listed.at[row].position) < listed.allowed);
    }
    return away;
  }

 private:
  struct state {
    vector position, force;
  };

  /// By what its motion takes from the forces on it; the trapezoidal rule, as for walls.
  template <class Grains>
  void add_work(const Grains& g, std::size_t k, const vector& gravity, double time_step) {
    const std::size_t row = here_[k].row;
    const driven_grain& d = all_[here_[k].which];
    const vector weight = (1 / g.template rows<grain_row::motion>()[row].inverse_mass) * gravity;
    const vector force = 0.5 * (before_[k].force + g.template rows<grain_row::force>()[row].force) + weight;
    work_ -= time_step * dot(force, d.velocity);
    if constexpr (Grains::rotate) {
      work_ -= time_step * dot(g.template rows<grain_row::torque>()[row].torque, d.angular_velocity);
    }
  }

  std::vector<driven_grain> all_;  // by id
  struct found_row {
    std::size_t which, row;
  };
  std::vector<found_row> here_;  // of those that are on this part of the scene
  std::vector<state> before_;
  double work_ = 0;
};

}  // namespace pendular
