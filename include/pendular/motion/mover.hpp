// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/quad.hpp>
#include <pendular/space/grains.hpp>

#include <type_traits>

namespace pendular {

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

/// The first three numbers of a row, as the integrator takes them.
template <class Row>
void take(four_doubles& three, const Row& row) {
  read(three, row);
}
inline void take(vector& v, const grain_row::place& row) { v = row.position; }
inline void take(vector& v, const grain_row::motion& row) { v = row.velocity; }
inline void take(vector& v, const grain_row::force& row) { v = row.force; }
inline void take(vector& v, const grain_row::spin& row) { v = row.angular_velocity; }
inline void take(vector& v, const grain_row::torque& row) { v = row.torque; }

/// Writes the first three numbers and keeps the fourth.
template <class Row>
void put(Row& row, const four_doubles& three) {
  four_doubles all = three, before;
  read(before, row);
  join(all, before);
  write(all, row);
}
template <class Row>
void put(Row& row, const quad& three) {
  four_doubles all;
  read(all, three);
  put(row, all);
}
template <class Row>
void put(Row& row, const vector& three) {
  put(row, quad{three.x, three.y, three.z, 0});
}

/// Moves grains as the integrator has it: in rows if it takes them, else in vectors.
template <class Integration>
class mover {
  using three = std::conditional_t<TakesRows<Integration>, four_doubles, vector>;

 public:
  explicit mover(const Integration& integrator) : integrator_(integrator) {
    const vector& g = integrator.gravity;
    take(gravity_, grain_row::force{g, 0});
  }

  void predict(grain_row::place& place, grain_row::motion& motion, const grain_row::force& force) const {
    three x, v, f;
    take(x, place), take(v, motion), take(f, force);
    integrator_.predict(x, v, three(motion.inverse_mass * f + gravity_));
    put(place, x), put(motion, v);
  }
  void predict(grain_row::spin& spin, const grain_row::torque& torque) const {
    three w, t;
    take(w, spin), take(t, torque);
    integrator_.predict_spin(w, three(torque.inverse_inertia * t));
    put(spin, w);
  }
  void correct(grain_row::motion& motion, const grain_row::force& before, const grain_row::force& now) const {
    three v, f, g;
    take(v, motion), take(f, before), take(g, now);
    const double inverse_mass = motion.inverse_mass;
    integrator_.correct(v, three(inverse_mass * f + gravity_), three(inverse_mass * g + gravity_));
    put(motion, v);
  }
  void correct(grain_row::spin& spin, const grain_row::torque& before, const grain_row::torque& now) const {
    three w, t, u;
    take(w, spin), take(t, before), take(u, now);
    const double inverse_inertia = before.inverse_inertia;
    integrator_.correct(w, three(inverse_inertia * t), three(inverse_inertia * u));
    put(spin, w);
  }

 private:
  Integration integrator_;
  three gravity_;
};

/// Writes the fourth number and keeps the first three.
template <class Row>
void put_fourth(Row& row, const quad& fourth) {
  four_doubles now, all;
  read(all, row), read(now, fourth);
  join(all, now);
  write(all, row);
}
}  // namespace detail

}  // namespace pendular
