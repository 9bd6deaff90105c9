// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/contact/action.hpp>
#include <pendular/contact/wall_loads.hpp>
#include <pendular/core/parallel.hpp>
#include <pendular/core/quad.hpp>
#include <pendular/space/grains.hpp>
#include <pendular/space/pair_list.hpp>

#include <algorithm>
#include <span>
#include <vector>

namespace pendular {

inline constexpr std::size_t grain_chunk = 512;

namespace detail {
template <class Integration>
concept TakesRows = requires(const Integration i, four_doubles& changed, const four_doubles& a) {
  i.predict(changed, changed, a);
  i.predict_spin(changed, a);
  i.correct(changed, a, a);
};

/// The first three numbers of one row and the fourth of another. In the register: a number written on its own would make
/// the next reader of the row wait.
inline void join(four_doubles& three, const four_doubles& fourth) {
  three = __builtin_shufflevector(three, fourth, 0, 1, 2, 7);
}

/// Three of the four numbers, as an integrator moves them, and the fourth as it is.
template <class Integration>
class mover {
 public:
  explicit mover(const Integration& integrator) : integrator_(integrator) {
    const vector& g = integrator.gravity;
    read(gravity_, quad{g.x, g.y, g.z, 0});
  }

  void predict(row::place& place, row::motion& motion, const row::force& force) const {
    if constexpr (TakesRows<Integration>) {
      four_doubles x, v, f, none{0, 0, 0, 0};
      read(x, place), read(v, motion), read(f, force);
      const four_doubles place_before = x, motion_before = v;
      join(v, none);
      integrator_.predict(x, v, four_doubles(motion.inverse_mass * f + gravity_));
      join(x, place_before), join(v, motion_before);
      write(x, place), write(v, motion);
    } else {
      integrator_.predict(place.position, motion.velocity, acceleration(motion, force.force));
    }
  }
  void predict(row::spin& spin, const row::torque& torque) const {
    if constexpr (TakesRows<Integration>) {
      four_doubles w, t;
      read(w, spin), read(t, torque);
      const four_doubles before = w;
      integrator_.predict_spin(w, four_doubles(torque.inverse_inertia * t));
      join(w, before);
      write(w, spin);
    } else {
      integrator_.predict_spin(spin.angular_velocity, torque.inverse_inertia * torque.torque);
    }
  }
  void correct(row::motion& motion, const row::force& before, const row::force& now) const {
    if constexpr (TakesRows<Integration>) {
      four_doubles v, f, g;
      read(v, motion), read(f, before), read(g, now);
      const double inverse_mass = motion.inverse_mass;
      const four_doubles motion_before = v;
      integrator_.correct(v, four_doubles(inverse_mass * f + gravity_), four_doubles(inverse_mass * g + gravity_));
      join(v, motion_before);
      write(v, motion);
    } else {
      integrator_.correct(motion.velocity, acceleration(motion, before.force), acceleration(motion, now.force));
    }
  }
  void correct(row::spin& spin, const row::torque& before, const row::torque& now) const {
    if constexpr (TakesRows<Integration>) {
      four_doubles w, t, u;
      read(w, spin), read(t, before), read(u, now);
      const double inverse_inertia = before.inverse_inertia;
      const four_doubles spin_before = w;
      integrator_.correct(w, four_doubles(inverse_inertia * t), four_doubles(inverse_inertia * u));
      join(w, spin_before);
      write(w, spin);
    } else {
      integrator_.correct(spin.angular_velocity, before.inverse_inertia * before.torque,
                          before.inverse_inertia * now.torque);
    }
  }

 private:
  vector acceleration(const row::motion& motion, const vector& force) const {
    return motion.inverse_mass * force + integrator_.gravity;
  }

  const Integration& integrator_;
  four_doubles gravity_;
};

/// Writes the first three numbers and keeps the fourth.
template <class Row>
void put(Row& row, const quad& three) {
  four_doubles now, before;
  read(now, three), read(before, row);
  join(now, before);
  write(now, row);
}

/// Writes the fourth number and keeps the first three.
template <class Row>
void put_fourth(Row& row, const quad& fourth) {
  four_doubles now, all;
  read(all, row), read(now, fourth);
  join(all, now);
  write(all, row);
}

/// First half of a step for one grain: position, and velocities extrapolated as the integrator has it. True if it has
/// moved farther than the square root of `allowed` from where it was listed, or is nowhere.
template <class Grains, class Mover>
bool predict(Grains& g, std::size_t k, const Mover& move, const vector& listed_at, double allowed) {
  row::place& place = g.template rows<row::place>()[k];
  move.predict(place, g.template rows<row::motion>()[k], g.template rows<row::force>()[k]);
  if constexpr (Grains::rotate) move.predict(g.template rows<row::spin>()[k], g.template rows<row::torque>()[k]);
  const vector d = place.position - listed_at;
  return !(dot(d, d) < allowed);
}
}  // namespace detail

/// How far grains may go before the list must be made anew.
struct listing {
  std::span<const vector> at;  // where they were listed, m
  double allowed;              // m
};

/// First half of a step for all grains. True if one of them is too far from where it was listed.
template <class Grains, class Integration>
bool predict(Grains& g, const Integration& integrator, const listing& listed) {
  std::vector<char> far(chunk_count(g.size(), grain_chunk), 0);
  const detail::mover move(integrator);
  for_chunks(g.size(), grain_chunk, [&](std::size_t begin, std::size_t end, std::size_t c) {
    bool any_far = false;
    for (std::size_t k = begin; k < end; ++k) {
      any_far |= detail::predict(g, k, move, listed.at[k], listed.allowed * listed.allowed);
    }
    far[c] = any_far ? 1 : 0;
  });
  return std::find(far.begin(), far.end(), 1) != far.end();
}

namespace detail {
// Force and contacts of a pair as its first and as its second grain feel them.
inline constexpr quad sides[2]{{1, 1, 1, 1}, {-1, -1, -1, 1}};

/// Sum over the pairs of a grain, in the order of the partners' ids, added to what walls do. A pair that does not act adds
/// zeros. Vectors are put together in memory: g++ 12 takes some that are listed number by number from wrong places
/// (AVX-512, -O2).
inline quad sum_pairs(const pair_list& list, const quad* actions, std::size_t row, double /*radius*/,
                      const quad& walls) {
  four_doubles sum, side, push;
  read(sum, walls);
  for (const auto& incidence : list.pairs_of(row)) {
    read(side, sides[incidence.is_second]);
    read(push, actions[incidence.pair]);
    sum += side * push;
  }
  quad all;
  write(sum, all);
  return all;
}

/// The same with torques, which take the lever arm of the grain; what stands in their fourth place means nothing. On its
/// own, so that the loop has the registers to itself.
[[gnu::noinline]] inline octet sum_pairs(const pair_list& list, const octet* actions, std::size_t row, double radius,
                                         const octet& walls) {
  four_doubles force, torque, side, push, turn;
  read(force, walls.low);
  read(torque, walls.high);
  for (const auto& incidence : list.pairs_of(row)) {
    const octet& pair = actions[incidence.pair];
    read(side, sides[incidence.is_second]);
    read(push, pair.low);
    read(turn, pair.high);
    force += side * push;
    torque += (radius + 0.5 * pair.high.d) * turn;
  }
  octet all;
  write(force, all.low);
  write(torque, all.high);
  return all;
}
}  // namespace detail

namespace detail {
/// Second half of a step for one grain: the sum of all that acts on it, and the corrected velocities. `moving` is false
/// at the start, when forces are only stored.
template <class Grains, class Mover>
void correct(Grains& g, std::size_t k, const Mover& move, const action<Grains::rotate>& sum, bool moving) {
  row::force& force = g.template rows<row::force>()[k];
  const row::force before = force;
  put(force, push_of(sum));
  if (moving) move.correct(g.template rows<row::motion>()[k], before, force);
  if constexpr (Grains::rotate) {
    row::spin& spin = g.template rows<row::spin>()[k];
    row::torque& torque = g.template rows<row::torque>()[k];
    const row::torque old = torque;
    put(torque, sum.high);
    if (moving) move.correct(spin, old, torque);
    if constexpr (Grains::count_contacts) put_fourth(spin, sum.low);
  }
}
}  // namespace detail

/// What comes after the second half of a step.
enum class then { nothing, next_step };

/// Second half of a step for all grains, and, if asked for, the first half of the next, while they are at hand. True if
/// that took one of them too far from where it was listed.
template <class Grains, class Contacts, class Integration>
bool correct(Grains& g, const pair_list& list, const Contacts& contacts, const wall_loads<Grains>& loads,
             const Integration& integrator, bool moving, then what, const listing& listed) {
  std::vector<char> far(chunk_count(g.size(), grain_chunk), 0);
  const detail::mover move(integrator);
  for_chunks(g.size(), grain_chunk, [&](std::size_t begin, std::size_t end, std::size_t c) {
    bool any_far = false;
    for (std::size_t k = begin; k < end; ++k) {
      const double radius = g.template rows<row::place>()[k].radius;
      detail::correct(g, k, move, detail::sum_pairs(list, contacts.actions(), k, radius, loads.on(k)), moving);
      if (what == then::next_step) {
        any_far |= detail::predict(g, k, move, listed.at[k], listed.allowed * listed.allowed);
      }
    }
    far[c] = any_far ? 1 : 0;
  });
  return std::find(far.begin(), far.end(), 1) != far.end();
}

}  // namespace pendular
