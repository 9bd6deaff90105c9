// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/concepts.hpp>
#include <pendular/testing/knock_outs.hpp>
#include <pendular/testing/role_archetypes.hpp>

#include <boost/hana/tuple.hpp>
#include <boost/hana/type.hpp>

#include <cstdint>
#include <string_view>
#include <tuple>

namespace pendular::testing::knock_out {

// As knock_outs.hpp, for roles that are no laws: each breaks one clause of its concept and keeps all the others.

namespace integrator {
struct whole {
  static constexpr double velocity_lag = 0;
  static double stable_step(double, double) { return 1; }
  double time_step;
  vector gravity;
  void predict(vector&, vector&, const vector&) const {}
  void predict_spin(vector&, const vector&) const {}
  void correct(vector&, const vector&, const vector&) const {}
};
struct not_copyable : whole, uncopyable {};
struct without_time_step : whole {
  void time_step();
};
struct without_gravity : whole {
  void gravity();
};
struct without_predict : whole {
  void predict(double);
};
struct predict_not_const : whole {
  void predict(vector&, vector&, const vector&) {}
};
struct without_predict_spin : whole {
  void predict_spin(double);
};
struct without_correct : whole {
  void correct(double);
};
struct correct_not_const : whole {
  void correct(vector&, const vector&, const vector&) {}
};
struct without_stable_step : whole {
  static double stable_step(double) { return 1; }
};
struct stable_step_of_an_object : whole {
  double stable_step(double, double) const { return 1; }
};
struct without_lag : whole {
  void velocity_lag();
};
}  // namespace integrator

namespace geometry {
struct not_copyable : uncopyable {
  boundary::meeting<double> meet(const vector&, double) const { return {}; }
};
struct without_meet {
  double gap(const vector&, double) const { return 0; }
};
struct not_const {
  boundary::meeting<double> meet(const vector&, double) { return {}; }
};
struct without_radius {
  boundary::meeting<double> meet(const vector&) const { return {}; }
};
struct returns_a_gap {
  double meet(const vector&, double) const { return 0; }
};
}  // namespace geometry

namespace drive {
struct whole {
  vector velocity;
  void move(boundary::plane&, const vector&, double) {}
};
struct not_copyable : whole, uncopyable {};
struct without_velocity {
  void move(boundary::plane&, const vector&, double) {}
};
struct without_move {
  vector velocity;
};
struct moves_another_shape {
  vector velocity;
  void move(double&, const vector&, double) {}
};
struct of_points {
  vector velocity_at(const vector& p) const { return p; }
  vector pivot() const { return {0, 0, 0}; }
  double approach_speed() const { return 0; }
  void move(boundary::plane&, const boundary::wall_load&, double) {}
};
struct without_velocity_at : of_points {
  void velocity_at(double);
};
struct without_pivot : of_points {
  void pivot(double);
};
struct without_approach_speed : of_points {
  void approach_speed(double);
};
}  // namespace drive

namespace wall {
struct whole {
  static constexpr bool is_wettable = false;
  boundary::plane shape;
  boundary::fixed drive;
  none material;
  vector force;
  double work;
  double approach_speed() const { return 0; }
  void move(double) {}
  void take(const boundary::wall_load&, double) {}
};
struct not_copyable : whole, uncopyable {};
struct without_shape : whole {
  double shape;
};
struct without_drive : whole {
  double drive;
};
struct without_material : whole {
  double material;
};
struct without_wetting : whole {
  void is_wettable();
};
struct without_force : whole {
  double force;
};
struct without_work : whole {
  vector work;
};
struct without_approach_speed : whole {
  void approach_speed(double);
};
struct without_move : whole {
  void move();
};
struct without_take : whole {
  void take(double);
};
}  // namespace wall

namespace boundary_of {
using part = knock_out::wall::whole;
struct whole {
  part floor, lid;
  auto parts() { return std::tie(floor, lid); }
  auto parts() const { return std::tie(floor, lid); }
};
struct not_copyable : whole, uncopyable {};
struct without_parts {
  part floor;
};
struct without_const_parts {
  part floor;
  auto parts() { return std::tie(floor); }
};
struct parts_of_no_tuple {
  part floor;
  part& parts() { return floor; }
  const part& parts() const { return floor; }
};
struct copies {
  part floor;
  auto parts() { return std::tuple(floor); }
  auto parts() const { return std::tuple(floor); }
};
struct const_parts_only {
  part floor;
  auto parts() const { return std::tie(floor); }
};
struct other_parts {
  part floor;
  auto parts() { return std::tie(floor); }
  auto parts() const { return std::tie(floor, floor); }
};
struct parts_that_are_no_walls {
  boundary::plane floor;
  auto parts() { return std::tie(floor); }
  auto parts() const { return std::tie(floor); }
};
}  // namespace boundary_of

namespace formation {
struct not_copyable : uncopyable {
  double minimum_volume;
  double reach(double) const { return 0; }
};
struct without_reach {
  double minimum_volume;
};
struct not_const {
  double minimum_volume;
  double reach(double) { return 0; }
};
struct without_minimum_volume {
  double reach(double) const { return 0; }
};
}  // namespace formation

namespace local_protocol {
struct whole {
  double offer(const bond_side&) const { return 1; }
  double merge(double a, double b) const { return a + b; }
  double settle(double bonds, double film) const { return film / bonds; }
  double pull(const bond_side&, double grant) const { return grant; }
};
struct not_copyable : whole, uncopyable {};
struct without_offer : whole {
  void offer();
};
struct without_merge : whole {
  void merge();
};
struct without_settle : whole {
  void settle();
};
struct without_pull : whole {
  void pull();
};
struct pull_returns_nothing : whole {
  void pull(const bond_side&, double) const {}
};
struct offer_not_const : whole {
  double offer(const bond_side&) { return 1; }
};
}  // namespace local_protocol

namespace global_protocol {
struct whole {
  std::int64_t period;
  template <class Door>
  void redistribute(Door&) const {}
};
struct not_copyable : whole, uncopyable {};
struct without_period : whole {
  void period();
};
struct without_redistribute {
  std::int64_t period;
};
struct not_const {
  std::int64_t period;
  template <class Door>
  void redistribute(Door&) {}
};
}  // namespace global_protocol

namespace source {
struct whole {
  static constexpr std::string_view account = "outside";
  std::int64_t period;
  template <class Door>
  void act(Door&) const {}
};
struct not_copyable : whole, uncopyable {};
struct without_period : whole {
  void period();
};
struct without_account : whole {
  void account();
};
struct without_act : whole {
  void act();
};
struct not_const : whole {
  template <class Door>
  void act(Door&) {}
};
}  // namespace source

namespace grain_tag {
struct whole {
  using type = double;
  static constexpr std::string_view label = "temperature", unit = "K";
};
struct without_type {
  static constexpr std::string_view label = "temperature", unit = "K";
};
struct of_another_type : whole {
  using type = float;
};
struct without_label : whole {
  void label();
};
struct without_unit : whole {
  void unit();
};
}  // namespace grain_tag

inline constexpr auto integrators =
    boost::hana::tuple_t<integrator::not_copyable, integrator::without_time_step, integrator::without_gravity,
                         integrator::without_predict, integrator::predict_not_const, integrator::without_predict_spin,
                         integrator::without_correct, integrator::correct_not_const, integrator::without_stable_step,
                         integrator::stable_step_of_an_object, integrator::without_lag>;
inline constexpr auto geometries =
    boost::hana::tuple_t<geometry::not_copyable, geometry::without_meet, geometry::not_const, geometry::without_radius,
                         geometry::returns_a_gap>;
inline constexpr auto drives =
    boost::hana::tuple_t<drive::not_copyable, drive::without_velocity, drive::without_move, drive::moves_another_shape,
                         drive::without_velocity_at, drive::without_pivot, drive::without_approach_speed>;
inline constexpr auto walls =
    boost::hana::tuple_t<wall::not_copyable, wall::without_shape, wall::without_drive, wall::without_material,
                         wall::without_wetting, wall::without_force, wall::without_work, wall::without_approach_speed,
                         wall::without_move, wall::without_take>;
inline constexpr auto boundaries =
    boost::hana::tuple_t<boundary_of::not_copyable, boundary_of::without_parts, boundary_of::without_const_parts,
                         boundary_of::parts_of_no_tuple, boundary_of::copies, boundary_of::const_parts_only,
                         boundary_of::other_parts, boundary_of::parts_that_are_no_walls>;
inline constexpr auto formation_rules = boost::hana::tuple_t<formation::not_copyable, formation::without_reach,
                                                             formation::not_const, formation::without_minimum_volume>;
inline constexpr auto local_protocols =
    boost::hana::tuple_t<local_protocol::not_copyable, local_protocol::without_offer, local_protocol::without_merge,
                         local_protocol::without_settle, local_protocol::without_pull,
                         local_protocol::pull_returns_nothing, local_protocol::offer_not_const>;
inline constexpr auto global_protocols =
    boost::hana::tuple_t<global_protocol::not_copyable, global_protocol::without_period,
                         global_protocol::without_redistribute, global_protocol::not_const>;
inline constexpr auto sources = boost::hana::tuple_t<source::not_copyable, source::without_period,
                                                     source::without_account, source::without_act, source::not_const>;
inline constexpr auto grain_tags = boost::hana::tuple_t<grain_tag::without_type, grain_tag::of_another_type,
                                                        grain_tag::without_label, grain_tag::without_unit>;

}  // namespace pendular::testing::knock_out
