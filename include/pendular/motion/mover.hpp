// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/quad.hpp>
#include <pendular/space/grains.hpp>

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

/// Three of the four numbers, as an integrator moves them, and the fourth as it is.
template <class Integration>
class mover {
 public:
  explicit mover(const Integration& integrator) : integrator_(integrator) {
    const vector& g = integrator.gravity;
    read(gravity_, quad{g.x, g.y, g.z, 0});
  }

  void predict(grain_row::place& place, grain_row::motion& motion, const grain_row::force& force) const {
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
  void predict(grain_row::spin& spin, const grain_row::torque& torque) const {
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
  void correct(grain_row::motion& motion, const grain_row::force& before, const grain_row::force& now) const {
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
  void correct(grain_row::spin& spin, const grain_row::torque& before, const grain_row::torque& now) const {
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
  vector acceleration(const grain_row::motion& motion, const vector& force) const {
    return motion.inverse_mass * force + integrator_.gravity;
  }

  Integration integrator_;
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
}  // namespace detail

}  // namespace pendular
