// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/contact/clock.hpp>
#include <pendular/contact/energy_book.hpp>
#include <pendular/contact/force.hpp>
#include <pendular/core/parallel.hpp>
#include <pendular/core/scalar_table.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pendular {

/// Work of the dissipative forces of a list of contacts, summed per chunk so that the total does not depend on the
/// threads. An integrator whose forces see a velocity `lag` steps old has moved the grains by that velocity times the
/// step, so the force that did the work is the mean of this and the last one, weighted by the lag: the books then
/// close to second order in the step.
class work_sums {
 public:
  template <class T>
  struct dissipative_force {
    T damping;         // N
    Vec3<T> traction;  // N
  };

  static constexpr std::size_t chunk = 512;

  /// Follows the contacts into a new list.
  void carry(std::span<const std::int32_t> origin, std::size_t rows) {
    last_.carry(origin, rows);
    fold();
    chunks_.assign(chunk_count(rows, chunk), sums{});
  }

  void add(std::size_t row, std::size_t rows, const encounter<block>& e, const contact_force<block>& f,
           const contact_clock& clock) {
    const double time_step = clock.moving ? clock.time_step : 0, lag = clock.velocity_lag;
    const dissipative_force<block> last = last_.load_block(row);
    last_.store_block(row, {f.damping, f.traction});
    const block real = real_lanes(row, rows);
    const block share = (1 - lag) * time_step * real, last_share = lag * time_step * real;
    sums& sum = chunks_[row / chunk];
    sum.damping += (share * f.damping + last_share * last.damping) * e.approaching.closing_speed;
    sum.friction -= share * dot(f.traction, f.slip_rate) + last_share * dot(last.traction, f.slip_rate);
  }

  contact_work total() const {
    contact_work work = folded_;
    for (const sums& c : chunks_) {
      work.damping += sum(c.damping);
      work.friction += sum(c.friction);
    }
    return work;
  }

  /// Moves the chunks into one number; done where a run may be resumed, so that both runs add in the same order.
  void fold() {
    folded_ = total();
    for (sums& c : chunks_) c = sums{};
  }
  void restore(const contact_work& work) { folded_ = work; }

  /// The last forces of a block of rows, and one of them put back.
  using last_block = std::array<dissipative_force<double>, lane_count>;
  last_block last_of(std::size_t first_row) const {
    last_block rows;
    for (std::size_t lane = 0; lane < lane_count; ++lane) rows[lane] = last_.row(first_row + lane);
    return rows;
  }
  void restore_last(std::size_t row, const last_block& rows, std::size_t lane) { last_.set_row(row, rows[lane]); }

  scalar_table<dissipative_force>& last_forces() { return last_; }
  const scalar_table<dissipative_force>& last_forces() const { return last_; }

 private:
  struct sums {
    block damping{0.0};
    block friction{0.0};
  };

  /// 1 for the lanes that hold one of the rows, 0 for padding.
  static block real_lanes(std::size_t row, std::size_t rows) {
    const double left = static_cast<double>(rows) - static_cast<double>(row);
    const block number = block::from([](int lane) { return lane; });
    return select(number < left, block(1.0), block(0.0));
  }

  contact_work folded_;
  std::vector<sums> chunks_;
  scalar_table<dissipative_force> last_;
};

/// In place of work_sums where no energy book is kept.
class no_work_sums {
 public:
  void carry(std::span<const std::int32_t>, std::size_t) {}
  void fold() {}
  contact_work total() const { return {}; }
  void restore(const contact_work&) {}
  struct last_block {};
  last_block last_of(std::size_t) const { return {}; }
  void restore_last(std::size_t, const last_block&, std::size_t) {}
};

template <bool KeepsBook>
using work_sums_if = std::conditional_t<KeepsBook, work_sums, no_work_sums>;

}  // namespace pendular
