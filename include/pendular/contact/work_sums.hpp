// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/contact/clock.hpp>
#include <pendular/contact/energy_book.hpp>
#include <pendular/contact/force.hpp>
#include <pendular/core/reproducible_sum.hpp>
#include <pendular/core/scalar_table.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace pendular {

/// Work of the dissipative forces of a list of contacts, kept by each of them, so that the total depends neither on threads
/// nor on the list. An integrator whose forces see a velocity `lag` steps old has moved the grains by that velocity times
/// the step, so the force that did the work is the mean of this and the last one, weighted by the lag: the books then
/// close to second order in the step.
class work_sums {
 public:
  /// Of a contact: work since it was listed, J, and the forces of the last step, N.
  template <class T>
  struct account {
    T damping_work;
    T friction_work;
    T damping;
    Vec3<T> traction;
  };

  /// Follows the contacts into a new list. What those have done that are in it no more is kept.
  void carry(std::span<const std::int32_t> origin, std::size_t rows) {
    std::vector<char> stays(size_, 0);
    for (const std::int32_t old : origin) {
      if (old >= 0) stays[static_cast<std::size_t>(old)] = 1;
    }
    for (std::size_t row = 0; row < size_; ++row) {
      if (!stays[row]) settle(accounts_.row(row));
    }
    accounts_.carry(origin, rows);
    size_ = origin.size();
  }
  /// Of a contact that is listed no more, and counts here.
  void settle(const account<double>& a) {
    settled_damping_.add(a.damping_work);
    settled_friction_.add(a.friction_work);
  }

  void add(std::size_t row, const encounter<block>& e, const contact_force<block>& f, const contact_clock& clock) {
    const double time_step = clock.moving ? clock.time_step : 0, lag = clock.velocity_lag;
    account<block> a = accounts_.load_block(row);
    const double share = (1 - lag) * time_step, last_share = lag * time_step;
    a.damping_work += (share * f.damping + last_share * a.damping) * e.approaching.closing_speed;
    a.friction_work -= share * dot(f.traction, f.slip_rate) + last_share * dot(a.traction, f.slip_rate);
    a.damping = f.damping;
    a.traction = f.traction;
    accounts_.store_block(row, a);
  }

  /// Of the contacts that `counts` says and of those that are no more.
  template <class Counts>
  contact_work total(const Counts& counts) const {
    reproducible_sum damping = settled_damping_, friction = settled_friction_;
    for (std::size_t row = 0; row < size_; ++row) {
      if (!counts(row)) continue;
      damping.add(accounts_.column(0)[row]);
      friction.add(accounts_.column(1)[row]);
    }
    return {damping.value(), friction.value()};
  }
  contact_work total() const {
    return total([](std::size_t) { return true; });
  }

  struct settled {
    reproducible_sum damping, friction;
  };
  settled keep() const { return {settled_damping_, settled_friction_}; }
  void restore(const settled& s) {
    settled_damping_ = s.damping;
    settled_friction_ = s.friction;
  }
  /// Nothing is left of the contacts, because they are put back by hand.
  void forget_rows() { size_ = 0; }

  account<double> row(std::size_t p) const { return accounts_.row(p); }
  void set_row(std::size_t p, const account<double>& a) { accounts_.set_row(p, a); }

 private:
  scalar_table<account> accounts_;
  std::size_t size_ = 0;  // without padding
  reproducible_sum settled_damping_, settled_friction_;
};

/// In place of work_sums where no energy book is kept.
class no_work_sums {
 public:
  template <class T>
  struct account {};
  void carry(std::span<const std::int32_t>, std::size_t) {}
  void forget_rows() {}
  contact_work total() const { return {}; }
  account<double> row(std::size_t) const { return {}; }
  void set_row(std::size_t, const account<double>&) {}
};

template <bool KeepsBook>
using work_sums_if = std::conditional_t<KeepsBook, work_sums, no_work_sums>;

}  // namespace pendular
