// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/quad.hpp>
#include <pendular/space/grains.hpp>

#include <type_traits>

namespace pendular {

namespace detail {
template <class Integration>
concept TakesRows = requires(const Integration i, four& changed, const four& a) {
  i.predict(changed, changed, a);
  i.predict_spin(changed, a);
  i.correct(changed, a, a);
};

/// The first three numbers of a row, as the integrator takes them.
inline void take(four& three, const four& row) { three = row; }
inline void take(vector& v, const four& row) { v = {row[0], row[1], row[2]}; }

/// Writes the first three numbers and keeps the fourth.
template <class Row>
void put(Row& row, const four& three) {
  store_row(row, four(simd::three_and_fourth(three.parts, load_row(row).parts)));
}
template <class Row>
void put(Row& row, const vector& three) {
  put(row, load_row(quad{three.x, three.y, three.z, 0}));
}

/// Moves grains as the integrator has it: in rows if it takes them, else in vectors.
template <class Integration>
class mover {
  using three = std::conditional_t<TakesRows<Integration>, four, vector>;

 public:
  explicit mover(const Integration& integrator) : integrator_(integrator) {
    const vector& g = integrator.gravity;
    gravity_ = taken(load_row(quad{g.x, g.y, g.z, 0}));
  }

  void predict(grain_row::place& place, grain_row::motion& motion, const grain_row::force& force) const {
    three x = of(place), v = of(motion);
    integrator_.predict(x, v, three(motion.inverse_mass * of(force) + gravity_));
    put(place, x), put(motion, v);
  }
  void predict(grain_row::spin& spin, const grain_row::torque& torque) const {
    three w = of(spin);
    integrator_.predict_spin(w, three(torque.inverse_inertia * of(torque)));
    put(spin, w);
  }
  /// With the force before and now, N.
  void correct(grain_row::motion& motion, const four& before, const four& now) const {
    three v = of(motion);
    const double inverse_mass = motion.inverse_mass;
    integrator_.correct(v, three(inverse_mass * taken(before) + gravity_), three(inverse_mass * taken(now) + gravity_));
    put(motion, v);
  }
  /// With the torque before and now, N m.
  void correct(grain_row::spin& spin, double inverse_inertia, const four& before, const four& now) const {
    three w = of(spin);
    integrator_.correct(w, three(inverse_inertia * taken(before)), three(inverse_inertia * taken(now)));
    put(spin, w);
  }

 private:
  static three taken(const four& row) {
    three t;
    take(t, row);
    return t;
  }
  template <class Row>
  static three of(const Row& row) {
    return taken(load_row(row));
  }

  Integration integrator_;
  three gravity_;
};

/// Writes the fourth number and keeps the first three.
template <class Row>
void put_fourth(Row& row, const quad& fourth) {
  store_row(row, four(simd::three_and_fourth(load_row(row).parts, load_row(fourth).parts)));
}
}  // namespace detail

}  // namespace pendular
