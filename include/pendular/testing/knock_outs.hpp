// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/concepts.hpp>

#include <boost/hana/tuple.hpp>
#include <boost/hana/type.hpp>

namespace pendular::testing::knock_out {

// Each of these breaks one clause of a concept and keeps all the others, so that the concept must refuse it.

struct uncopyable {
  uncopyable() = default;
  uncopyable(uncopyable&&) = default;
  uncopyable& operator=(uncopyable&&) = default;
};

namespace normal {
struct not_copyable : uncopyable {
  double repulsion(const approach<double>& a) const { return -a.gap; }
};
struct without_repulsion {
  double attraction(const approach<double>& a) const { return -a.gap; }
};
struct not_const {
  double repulsion(const approach<double>& a) { return -a.gap; }
};
struct of_a_bridge {
  double repulsion(const bridge<double>& b) const { return -b.gap; }
};
struct returns_nothing {
  void repulsion(const approach<double>&) const {}
};
struct memory_not_declared {
  double repulsion(const approach<double>& a, double& deepest) const { return deepest - a.gap; }
};
struct memory_not_taken {
  template <class T>
  struct contact_memory {
    T deepest;
  };
  double repulsion(const approach<double>& a) const { return -a.gap; }
};
}  // namespace normal

namespace damping {
struct not_copyable : uncopyable {
  double resistance(const approach<double>& a, double k) const { return k * a.closing_speed; }
};
struct without_resistance {
  double damping(const approach<double>& a, double k) const { return k * a.closing_speed; }
};
struct not_const {
  double resistance(const approach<double>& a, double k) { return k * a.closing_speed; }
};
struct without_stiffness {
  double resistance(const approach<double>& a) const { return a.closing_speed; }
};
struct returns_nothing {
  void resistance(const approach<double>&, double) const {}
};
struct returns_nothing_beside_spring {
  void resistance(const approach<double>&, const elastic<double>&) const {}
};
struct not_const_beside_spring {
  double resistance(const approach<double>& a, const elastic<double>& e) { return e.push * a.closing_speed; }
};
struct memory_not_declared {
  double resistance(const approach<double>& a, double, double& fastest) const { return fastest * a.closing_speed; }
};
struct memory_not_taken {
  template <class T>
  struct contact_memory {
    T fastest;
  };
  double resistance(const approach<double>& a, double k) const { return k * a.closing_speed; }
};
}  // namespace damping

namespace friction {
struct not_copyable : uncopyable {
  Vec3<double> traction(const slip<double>& s, double) const { return -s.velocity; }
};
struct without_traction {
  Vec3<double> resistance(const slip<double>& s, double) const { return -s.velocity; }
};
struct not_const {
  Vec3<double> traction(const slip<double>& s, double) { return -s.velocity; }
};
struct without_normal_force {
  Vec3<double> traction(const slip<double>& s) const { return -s.velocity; }
};
struct returns_a_length {
  double traction(const slip<double>& s, double) const { return -norm(s.velocity); }
};
struct memory_not_declared {
  struct history {
    Vec3<double> force;
  };
  Vec3<double> traction(const slip<double>&, double, history& memory) const { return memory.force; }
};
struct memory_of_any_type {
  template <class Memory>
  Vec3<double> traction(const slip<double>& s, double, Memory&) const {
    return -s.velocity;
  }
};
struct memory_not_a_template {
  struct contact_memory {
    Vec3<double> force;
  };
  Vec3<double> traction(const slip<double>&, double, contact_memory& memory) const { return memory.force; }
};
struct memory_of_another_type {
  template <class T>
  struct contact_memory {
    Vec3<T> force;
  };
  Vec3<double> traction(const slip<double>&, double, Vec3<double>& force) const { return force; }
};
}  // namespace friction

namespace capillary {
struct not_copyable : uncopyable {
  double attraction(const bridge<double>& b, const fluid&) const { return b.radius_i; }
};
struct without_attraction {
  double repulsion(const bridge<double>& b, const fluid&) const { return b.radius_i; }
};
struct not_const {
  double attraction(const bridge<double>& b, const fluid&) { return b.radius_i; }
};
struct without_fluid {
  double attraction(const bridge<double>& b) const { return b.radius_i; }
};
struct returns_nothing {
  void attraction(const bridge<double>&, const fluid&) const {}
};
struct prepared_not_copyable : uncopyable {
  template <class T>
  using coefficients = T;
  double prepare(const bridge<double>& b, const fluid&) const { return b.radius_i; }
  double attraction(double, double c) const { return c; }
};
struct without_coefficients {
  double prepare(const bridge<double>& b, const fluid&) const { return b.radius_i; }
  double attraction(double, double c) const { return c; }
};
struct prepares_another_type {
  template <class T>
  using coefficients = Vec3<T>;
  double prepare(const bridge<double>& b, const fluid&) const { return b.radius_i; }
  double attraction(double, double c) const { return c; }
};
struct prepares_in_vain {
  template <class T>
  using coefficients = Vec3<T>;
  Vec3<double> prepare(const bridge<double>&, const fluid&) const { return {}; }
  double attraction(double gap) const { return gap; }
};
struct prepare_not_const {
  template <class T>
  using coefficients = T;
  double prepare(const bridge<double>& b, const fluid&) { return b.radius_i; }
  double attraction(double, double c) const { return c; }
};
struct prepared_returns_nothing {
  template <class T>
  using coefficients = T;
  double prepare(const bridge<double>& b, const fluid&) const { return b.radius_i; }
  void attraction(double, double) const {}
};
}  // namespace capillary

namespace rupture {
struct not_copyable : uncopyable {
  double distance(const bridge<double>& b, const fluid&) const { return b.radius_i; }
};
struct without_distance {
  double length(const bridge<double>& b, const fluid&) const { return b.radius_i; }
};
struct not_const {
  double distance(const bridge<double>& b, const fluid&) { return b.radius_i; }
};
struct without_fluid {
  double distance(const bridge<double>& b) const { return b.radius_i; }
};
struct returns_nothing {
  void distance(const bridge<double>&, const fluid&) const {}
};
}  // namespace rupture

namespace mean_radius {
struct not_copyable : uncopyable {
  double of(const bridge<double>& b) const { return b.radius_i; }
};
struct without_of {
  double radius(const bridge<double>& b) const { return b.radius_i; }
};
struct not_const {
  double of(const bridge<double>& b) { return b.radius_i; }
};
struct of_two_numbers {
  double of(double radius_i, double) const { return radius_i; }
};
struct returns_nothing {
  void of(const bridge<double>&) const {}
};
}  // namespace mean_radius

namespace viscous {
struct not_copyable : uncopyable {
  bridge_resistance<double> resistance(const bridge<double>&, const fluid&) const { return {}; }
};
struct without_resistance {
  bridge_resistance<double> drag(const bridge<double>&, const fluid&) const { return {}; }
};
struct not_const {
  bridge_resistance<double> resistance(const bridge<double>&, const fluid&) { return {}; }
};
struct without_fluid {
  bridge_resistance<double> resistance(const bridge<double>&) const { return {}; }
};
struct returns_one_number {
  double resistance(const bridge<double>&, const fluid&) const { return 0; }
};
}  // namespace viscous

namespace energy {
struct of_no_law {
  double energy(const bridge<double>&, const fluid&, double) const { return 0; }
};
struct without_energy {
  double attraction(const bridge<double>& b, const fluid&) const { return b.radius_i; }
};
struct without_rupture_distance : without_energy {
  double energy(const bridge<double>&, const fluid&) const { return 0; }
};
struct not_const : without_energy {
  double energy(const bridge<double>&, const fluid&, double) { return 0; }
};
struct returns_nothing : without_energy {
  void energy(const bridge<double>&, const fluid&, double) const {}
};
}  // namespace energy

inline constexpr auto normal_laws =
    boost::hana::tuple_t<normal::not_copyable, normal::without_repulsion, normal::not_const, normal::of_a_bridge,
                         normal::returns_nothing, normal::memory_not_declared, normal::memory_not_taken>;
inline constexpr auto damping_laws =
    boost::hana::tuple_t<damping::not_copyable, damping::without_resistance, damping::not_const,
                         damping::without_stiffness, damping::returns_nothing, damping::returns_nothing_beside_spring,
                         damping::not_const_beside_spring, damping::memory_not_declared, damping::memory_not_taken>;
inline constexpr auto friction_laws =
    boost::hana::tuple_t<friction::not_copyable, friction::without_traction, friction::not_const,
                         friction::without_normal_force, friction::returns_a_length, friction::memory_not_declared,
                         friction::memory_of_any_type, friction::memory_not_a_template,
                         friction::memory_of_another_type>;
inline constexpr auto capillary_laws =
    boost::hana::tuple_t<capillary::not_copyable, capillary::without_attraction, capillary::not_const,
                         capillary::without_fluid, capillary::returns_nothing, capillary::prepared_not_copyable,
                         capillary::without_coefficients, capillary::prepares_another_type, capillary::prepares_in_vain,
                         capillary::prepare_not_const, capillary::prepared_returns_nothing>;
inline constexpr auto rupture_laws =
    boost::hana::tuple_t<rupture::not_copyable, rupture::without_distance, rupture::not_const, rupture::without_fluid,
                         rupture::returns_nothing>;
inline constexpr auto mean_radii =
    boost::hana::tuple_t<mean_radius::not_copyable, mean_radius::without_of, mean_radius::not_const,
                         mean_radius::of_two_numbers, mean_radius::returns_nothing>;
inline constexpr auto viscous_bridge_laws =
    boost::hana::tuple_t<viscous::not_copyable, viscous::without_resistance, viscous::not_const, viscous::without_fluid,
                         viscous::returns_one_number>;
inline constexpr auto capillary_energies =
    boost::hana::tuple_t<energy::of_no_law, energy::without_energy, energy::without_rupture_distance, energy::not_const,
                         energy::returns_nothing>;

}  // namespace pendular::testing::knock_out
