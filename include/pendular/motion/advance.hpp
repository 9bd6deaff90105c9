// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/contact/action_row.hpp>
#include <pendular/contact/wall_loads.hpp>
#include <pendular/core/parallel.hpp>
#include <pendular/motion/mover.hpp>
#include <pendular/motion/sums.hpp>
#include <pendular/space/grains.hpp>
#include <pendular/space/neighbourhood.hpp>
#include <pendular/space/pair_list.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace pendular {

/// What comes after the second half of a step.
enum class followed_by { nothing, next_step };

inline constexpr std::size_t grain_chunk = 512;

namespace detail {
/// The rows of all grains, to be kept in local variables: a compiler must else take them for changed by every write.
template <class Grains, class Integration>
class grain_motion {
 public:
  grain_motion(Grains& g, const Integration& integrator, const listing& listed)
      : place_(g.template rows<grain_row::place>().data()), motion_(g.template rows<grain_row::motion>().data()),
        force_(g.template rows<grain_row::force>().data()), listed_at_(listed.at.data()),
        allowed_(listed.allowed * listed.allowed), move_(integrator) {
    if constexpr (Grains::rotate) {
      spin_ = g.template rows<grain_row::spin>().data();
      torque_ = g.template rows<grain_row::torque>().data();
    }
  }

  double radius(std::size_t k) const { return place_[k].radius; }

  /// First half of a step: position, and velocities extrapolated as the integrator has it. True if the grain is too far
  /// from where it was listed, or nowhere.
  [[gnu::always_inline]] bool predict(std::size_t k) const {
    move_.predict(place_[k], motion_[k], force_[k]);
    if constexpr (Grains::rotate) move_.predict(spin_[k], torque_[k]);
    const four d = load_row(place_[k]) - load_row(listed_at_[k]), square = d * d;  // the radii take each other away
    return !((square[0] + square[1]) + (square[2] + square[3]) < allowed_);
  }

  /// Second half, from the sum of all that acts on the grain. `moving` is false at the start, when forces are only
  /// stored.
  [[gnu::always_inline]] void correct(std::size_t k, const action_row<Grains::rotate>& sum, bool moving) const {
    const four before = load_row(force_[k]), now = load_row(push_of(sum));
    put(force_[k], now);
    if (moving) move_.correct(motion_[k], before, now);
    if constexpr (Grains::rotate) {
      const four old = load_row(torque_[k]), turn = load_row(sum.high);
      put(torque_[k], turn);
      if (moving) move_.correct(spin_[k], torque_[k].inverse_inertia, old, turn);
      if constexpr (Grains::count_contacts) put_fourth(spin_[k], sum.low);
    }
  }

 private:
  grain_row::place* place_;
  grain_row::motion* motion_;
  grain_row::force* force_;
  grain_row::spin* spin_ = nullptr;
  grain_row::torque* torque_ = nullptr;
  const grain_row::place* listed_at_;
  double allowed_;
  mover<Integration> move_;
};

/// body(begin, end) over chunks of grains; true if it was for one of them.
template <class Body>
bool any_of_grains(std::size_t grains, const Body& body) {
  std::vector<char> found(chunk_count(grains, grain_chunk), 0);
  for_chunks(grains, grain_chunk,
             [&](std::size_t begin, std::size_t end, std::size_t c) { found[c] = body(begin, end) ? 1 : 0; });
  return std::find(found.begin(), found.end(), 1) != found.end();
}
}  // namespace detail

namespace detail {
// Flattened: whether a compiler takes an integrator's function for short enough to be inlined depends on what else calls
// it, and a call per grain costs a tenth of a step.
template <class Motion>
PENDULAR_FLATTEN bool predict_range(const Motion move, std::size_t begin, std::size_t end) {
  bool away = false;
  for (std::size_t k = begin; k < end; ++k) away |= move.predict(k);
  return away;
}

template <class Motion, class Actions, class Walls>
PENDULAR_FLATTEN bool correct_range(const Motion move, const pair_list::view pairs, const Actions* actions,
                                    const Walls walls, bool moving, followed_by what, std::size_t begin,
                                    std::size_t end) {
  bool away = false;
  for (std::size_t k = begin; k < end; ++k) {
    move.correct(k, sum_pairs(pairs.of(k), actions, move.radius(k), walls.on(k)), moving);
    if (what == followed_by::next_step) away |= move.predict(k);
  }
  return away;
}
}  // namespace detail

/// First half of a step for all grains that are kept here. True if one of them is too far from where it was listed.
template <class Grains, class Integration>
bool predict(Grains& g, const Integration& integrator, const listing& listed) {
  return detail::any_of_grains(g.kept(), [&](std::size_t begin, std::size_t end) {
    return detail::predict_range(detail::grain_motion(g, integrator, listed), begin, end);
  });
}

/// Second half of a step for all grains that are kept here, and, if asked for, the first half of the next, while they are at hand. True if
/// that took one of them too far from where it was listed.
template <class Grains, class Contacts, class Integration>
bool correct(Grains& g, const pair_list& list, const Contacts& contacts, const wall_loads<Grains::rotate>& loads,
             const Integration& integrator, bool moving, followed_by what, const listing& listed) {
  return detail::any_of_grains(g.kept(), [&](std::size_t begin, std::size_t end) {
    return detail::correct_range(detail::grain_motion(g, integrator, listed), list.by_grain(), contacts.actions(),
                                 loads.by_grain(), moving, what, begin, end);
  });
}

}  // namespace pendular
