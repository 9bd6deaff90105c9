// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/lanes.hpp>

#include <cstddef>
#include <vector>

namespace pendular {

/// Policy of a material: add up the work done by dashpots and friction.
struct energy_book {};

/// Work taken out of the motion since the start, J.
struct contact_work {
  double damping = 0;
  double friction = 0;  // includes what friction springs store
};

/// Running sums per chunk of pairs, so that the total does not depend on the threads.
class contact_work_sums {
 public:
  struct chunk {
    block damping = block::Zero();
    block friction = block::Zero();
  };

  void resize(std::size_t chunks) {
    fold();
    chunks_.assign(chunks, chunk{});
  }
  chunk& operator[](std::size_t index) { return chunks_[index]; }

  contact_work total() const {
    contact_work sum = folded_;
    for (const chunk& c : chunks_) {
      sum.damping += c.damping.sum();
      sum.friction += c.friction.sum();
    }
    return sum;
  }

  /// Moves the chunks into one number; done where a run may be resumed, so that both runs add in the same order.
  void fold() {
    folded_ = total();
    for (chunk& c : chunks_) c = chunk{};
  }
  void restart_from(const contact_work& work) { folded_ = work; }

 private:
  contact_work folded_;
  std::vector<chunk> chunks_;
};

}  // namespace pendular
