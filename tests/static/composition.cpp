// SPDX-License-Identifier: BSD-3-Clause
// What a scene does not choose does not exist: composed types, their columns, memories and sizes.
#include <pendular/boundary/rimmed_cylinder.hpp>
#include <pendular/boundary/servo_stress.hpp>
#include <pendular/boundary/turning.hpp>
#include <pendular/law/all.hpp>
#include <pendular/liquid/protocol/all.hpp>
#include <pendular/liquid/source/all.hpp>
#include <pendular/system.hpp>
#include <pendular/testing/archetypes.hpp>

#include <boost/hana/unpack.hpp>

#include <type_traits>
#include <utility>

using namespace pendular;

namespace {

using spring = normal::linear;
using dashpot = damping::viscous;
using floor_only = boundary::walls<boundary::wall<boundary::plane>>;
template <class Material, class... Liquid>
using scene = pendular::system<Material, Liquid..., floor_only, velocity_verlet>;

using frictionless = material<spring, dashpot>;
using viscous = material<spring, dashpot, friction::viscous_coulomb>;
using cundall = material<spring, dashpot, friction::coulomb_spring>;
using published = material<spring, dashpot, friction::viscous_coulomb_explicit>;
using booked = material<spring, dashpot, energy_book>;
using water_and_laws = liquid<fluid, capillary::richefeu, rupture::lian>;

// A dry scene has no bridge, no volume, no film.
using dry_scene = scene<frictionless, dry>;
using wet_scene = scene<frictionless, water_and_laws>;
static_assert(!dry_scene::wet && wet_scene::wet);
static_assert(std::is_same_v<dry_scene::bonds_type, no_bonds> && std::is_empty_v<no_bonds> && std::is_empty_v<dry>);
static_assert(std::is_same_v<wet_scene::bonds_type, bonds<water_and_laws>>);
static_assert(!dry_scene::contacts_type::wet && wet_scene::contacts_type::wet);
static_assert(sizeof(dry_scene) < sizeof(wet_scene));

// A copy is deduced as one, not as arguments out of order.
static_assert(std::is_same_v<decltype(pendular::system{std::declval<const dry_scene&>()}), dry_scene>);
static_assert(std::is_same_v<decltype(pendular::system(std::declval<wet_scene&>())), wet_scene>);
template <class System>
concept Wettable = requires(System s) {
  s.distribute_liquid(1e-9);
};
static_assert(Wettable<wet_scene> && !Wettable<dry_scene>);

// Leaving the liquid out and saying none{} are one.
template <class... Parts>
using deduced = decltype(pendular::system(std::declval<Parts>()...));
static_assert(std::is_same_v<deduced<frictionless, none, floor_only, velocity_verlet>, dry_scene>);
static_assert(std::is_same_v<deduced<frictionless, none, floor_only, velocity_verlet, run_options>, dry_scene>);
static_assert(std::is_same_v<deduced<frictionless, none, floor_only, velocity_verlet, tags<>>, dry_scene>);
static_assert(std::is_same_v<deduced<frictionless, floor_only, velocity_verlet, run_options>, dry_scene>);
static_assert(std::is_same_v<deduced<frictionless, water_and_laws, floor_only, velocity_verlet>, wet_scene>);

// A frictionless scene does not rotate.
template <class System, class Column>
inline constexpr bool has = System::grains_type::template has<Column>;
using rolling_scene = scene<cundall, dry>;
static_assert(!has<dry_scene, column::angular_velocity> && !has<dry_scene, column::torque> &&
              !has<dry_scene, column::inverse_inertia> && !has<dry_scene, column::contacts>);
static_assert(has<rolling_scene, column::angular_velocity> && has<rolling_scene, column::torque> &&
              has<rolling_scene, column::inverse_inertia>);
static_assert(has<dry_scene, column::position> && has<dry_scene, column::id> && has<dry_scene, column::force>);
static_assert(!dry_scene::grains_type::rotate && rolling_scene::grains_type::rotate);
static_assert(sizeof(dry_scene::grains_type) < sizeof(rolling_scene::grains_type));

// Contacts are counted for the law that asks, and for no other.
static_assert(has<scene<viscous, dry>, column::contacts> && scene<viscous, dry>::grains_type::count_contacts);
static_assert(!has<scene<cundall, dry>, column::contacts> && !has<scene<published, dry>, column::contacts>);
static_assert(viscous::counts_contacts && !cundall::counts_contacts && !published::counts_contacts &&
              !frictionless::counts_contacts);

// A pair remembers what its friction law remembers: three numbers for a spring, else none.
template <class Material>
inline constexpr std::size_t numbers_per_pair = scalar_table<Material::template memory>::width;
static_assert(numbers_per_pair<cundall> == 3 && numbers_per_pair<viscous> == 3);
static_assert(numbers_per_pair<published> == 0 && numbers_per_pair<frictionless> == 0);
static_assert(cundall::has_memory && viscous::has_memory && !published::has_memory && !frictionless::has_memory);
static_assert(std::is_empty_v<frictionless::memory<block>>);
static_assert(numbers_per_pair<material<testing::archetype::friction_law_with_memory, spring>> == 3);

// A contact keeps of what does not change what its laws ask for: the mass for friction and for damping that is not prepared,
// the dashpot where it is.
template <class Material>
inline constexpr std::size_t constants_per_pair =
    scalar_table<scene<Material, dry>::contacts_type::template constants>::width;
template <class Material>
inline constexpr bool keeps_dashpot =
    !std::is_same_v<std::remove_const_t<decltype(contact_constants<double, Material>::damping)>, none>;
static_assert(constants_per_pair<material<spring>> == 0 && constants_per_pair<material<normal::hertz>> == 0);
static_assert(constants_per_pair<material<spring, friction::coulomb_spring>> == 1);
static_assert(constants_per_pair<material<normal::hertz, dashpot>> == 1);
static_assert(constants_per_pair<material<normal::hertz, dashpot, friction::coulomb_spring>> == 1);
static_assert(constants_per_pair<frictionless> == 1 && constants_per_pair<cundall> == 2);
static_assert(keeps_dashpot<frictionless> && keeps_dashpot<cundall> && !keeps_dashpot<material<spring>> &&
              !keeps_dashpot<material<spring, friction::coulomb_spring>> &&
              !keeps_dashpot<material<normal::hertz, dashpot>>);

// A bond keeps its coefficients, and those of a law without any are its volume and radii.
template <class Law>
inline constexpr std::size_t numbers_per_bond =
    scalar_table<bonds<liquid<fluid, Law, rupture::lian>>::template coefficients>::width;
static_assert(numbers_per_bond<capillary::richefeu> == 2 && numbers_per_bond<testing::archetype::capillary_law> == 3 &&
              numbers_per_bond<testing::archetype::prepared_capillary_law> == 1);
static_assert(numbers_per_bond<capillary::richefeu_with<testing::archetype::mean_radius>> == 2);

// Sums of work are kept where they are asked for.
static_assert(booked::keeps_energy_book && !frictionless::keeps_energy_book);
static_assert(std::is_same_v<work_sums_if<booked::keeps_energy_book>, work_sums> &&
              std::is_empty_v<work_sums_if<false>>);
static_assert(sizeof(scene<frictionless, dry>) < sizeof(scene<booked, dry>));
static_assert(std::is_same_v<booked::normal_law, spring> && !booked::has_friction);

// A bundle takes its policies in any order, and `none` is nobody.
static_assert(std::is_same_v<material<dashpot, friction::coulomb_spring, spring>::normal_law, spring>);
static_assert(std::is_same_v<material<dashpot, friction::coulomb_spring, spring>::damping_law, dashpot>);
static_assert(
    std::is_same_v<material<friction::coulomb_spring, spring, dashpot>::friction_law, friction::coulomb_spring>);
static_assert(std::is_same_v<material<none, spring, none>::friction_law, none> && !material<none, spring>::has_damping);
static_assert(numbers_per_pair<material<none, friction::coulomb_spring, none, spring>> == 3);

using any_order = liquid<protocol::gravity, rupture::willett, none, formation::within_rupture_distance, fluid,
                         capillary::richefeu_harmonic>;
static_assert(std::is_same_v<any_order::capillary_law, capillary::richefeu_harmonic>);
static_assert(std::is_same_v<any_order::rupture_law, rupture::willett>);
static_assert(std::is_same_v<any_order::protocol_type, protocol::gravity>);
static_assert(std::is_same_v<any_order::formation_rule, formation::within_rupture_distance>);

// What a liquid does not say.
static_assert(std::is_same_v<water_and_laws::protocol_type, protocol::none>);
static_assert(std::is_same_v<water_and_laws::formation_rule, formation::at_contact>);
template <class... More>
using with = liquid<fluid, capillary::richefeu, rupture::lian, More...>;
static_assert(!water_and_laws::is_viscous && with<pendular::viscous::lubrication>::is_viscous);
static_assert(std::is_same_v<with<protocol::homogeneous>::formation_rule, formation::within_rupture_distance>);
static_assert(
    std::is_same_v<with<protocol::homogeneous, formation::at_contact>::formation_rule, formation::at_contact>);
static_assert(std::is_same_v<with<protocol::grain_films>::formation_rule, formation::at_contact>);
static_assert(with<protocol::gravity>::needs_gravity && !with<protocol::neighbours>::needs_gravity &&
              !water_and_laws::needs_gravity);

// Every protocol is local, global or none.
template <class P>
inline constexpr bool is_protocol_or_none = Protocol<P> != std::is_same_v<P, none>;
static_assert(boost::hana::unpack(protocol::all,
                                  [](auto... p) { return (is_protocol_or_none<typename decltype(p)::type> && ...); }));
static_assert(LocalProtocol<protocol::neighbours> && LocalProtocol<protocol::grain_films> &&
              LocalProtocol<protocol::gravity>);
static_assert(GlobalProtocol<protocol::homogeneous> && !LocalProtocol<protocol::homogeneous>);
static_assert(!LocalProtocol<protocol::none> && !GlobalProtocol<protocol::none>);

// One type says nobody in every role, as often and wherever it is written.
static_assert(std::is_same_v<damping::none, none> && std::is_same_v<friction::none, none>);
static_assert(std::is_same_v<protocol::none, none> && std::is_same_v<null_observer, none>);
static_assert(std::is_same_v<material<friction::none, spring, damping::none>::damping_law, none>);
static_assert(std::is_same_v<with<none, protocol::none>::protocol_type, none>);
static_assert(std::is_same_v<with<protocol::none, protocol::gravity, none>::protocol_type, protocol::gravity>);
static_assert(std::is_same_v<with<protocol::none>::formation_rule, formation::at_contact> &&
              !with<protocol::none>::redistributes_locally && !with<protocol::none>::redistributes_globally);
static_assert(with<protocol::homogeneous>::redistributes_globally &&
              !with<protocol::homogeneous>::redistributes_locally);
static_assert(with<protocol::gravity>::redistributes_locally && !with<protocol::gravity>::redistributes_globally);
static_assert(!water_and_laws::redistributes_locally && !water_and_laws::redistributes_globally);

// The least a protocol is, and every clause knocked out.
struct local_twin {
  double offer(const bond_side&) const { return 1; }
  double merge(double a, double b) const { return a + b; }
  double settle(double offers, double film) const { return film / offers; }
  double pull(const bond_side&, double grant) const { return grant; }
};
struct no_offer {
  double merge(double a, double b) const { return a + b; }
  double settle(double offers, double film) const { return film / offers; }
  double pull(const bond_side&, double grant) const { return grant; }
};
struct no_merge {
  double offer(const bond_side&) const { return 1; }
  double settle(double offers, double film) const { return film / offers; }
  double pull(const bond_side&, double grant) const { return grant; }
};
struct no_settle {
  double offer(const bond_side&) const { return 1; }
  double merge(double a, double b) const { return a + b; }
  double pull(const bond_side&, double grant) const { return grant; }
};
struct no_pull {
  double offer(const bond_side&) const { return 1; }
  double merge(double a, double b) const { return a + b; }
  double settle(double offers, double film) const { return film / offers; }
};
struct pull_without_volume : no_pull {
  bond_side pull(const bond_side& b, double) const { return b; }
};
struct forgetful_pull : no_pull {
  double pull(const bond_side&, double grant) { return grant; }  // not const
};
struct fixed_protocol : local_twin {
  fixed_protocol& operator=(const fixed_protocol&) = delete;
};
struct wordy_period {
  const char* period = "often";
};
static_assert(LocalProtocol<local_twin> && Protocol<local_twin>);
static_assert(!Protocol<no_offer> && !Protocol<no_merge> && !Protocol<no_settle> && !Protocol<no_pull>);
static_assert(!Protocol<pull_without_volume> && !Protocol<forgetful_pull> && !Protocol<fixed_protocol>);
static_assert(!Protocol<wordy_period> && !Protocol<none> && !Protocol<int>);
struct only_a_period {
  std::int64_t period = 10;
};
struct global_twin : only_a_period {
  void redistribute(auto& door) const { door.break_bridge(0); }
};
struct changing_global : only_a_period {
  void redistribute(auto& door) { door.break_bridge(0); }
};
struct global_source : only_a_period {
  void redistribute(auto& door) const requires requires {
    door.wet_grain(0, 1.0);
  }  // a protocol creates no liquid: its door has no outside
  {}
};
static_assert(GlobalProtocol<global_twin> && !Protocol<only_a_period> && !Protocol<changing_global>);
static_assert(!Protocol<global_source>);

// The least a source is, and every clause knocked out.
struct source_twin {
  int period = 10;
  const char* account = "well";
  void act(auto& door) const { door.wet_grain(0, 1e-12 * door.time_span()); }
};
struct source_without_period {
  const char* account = "well";
  void act(auto&) const {}
};
struct source_without_account {
  int period = 10;
  void act(auto&) const {}
};
struct source_without_act {
  int period = 10;
  const char* account = "well";
};
struct changing_source : source_without_act {
  void act(auto&) {}
};
struct fixed_source : source_twin {
  fixed_source& operator=(const fixed_source&) = delete;
};
static_assert(Source<source_twin> && Source<source::evaporation> && Source<source::wetting<>>);
static_assert(!Source<source_without_period> && !Source<source_without_account> && !Source<source_without_act> &&
              !Source<changing_source> && !Source<fixed_source> && !Source<none> && !Source<protocol::homogeneous>);
static_assert(with<source_twin, source::evaporation>::has_sources && !water_and_laws::has_sources);
static_assert(boost::hana::unpack(source::all, [](auto... s) { return (Source<typename decltype(s)::type> && ...); }));

// An observer looks at steps, is told of events, or both.
struct looks {
  void operator()(const wet_scene&) {}
};
struct listens {
  void notice(const bridge_event&) {}
};
struct meddles {
  void operator()(wet_scene&) {}
};
static_assert(Observer<null_observer, wet_scene> && Observer<looks, wet_scene> && Observer<listens, wet_scene>);
static_assert(!Observer<meddles, wet_scene> && !Observer<looks, dry_scene> && !Observer<double, wet_scene>);

// A drive has one velocity or a field of them, and moves its shape.
struct drive_twin {
  vector velocity;
  void move(boundary::plane&, const vector&, double) {}
};
struct field_twin {
  template <class T>
  Vec3<T> velocity_at(const Vec3<T>& p) const {
    return p;
  }
  vector pivot() const { return {}; }
  double approach_speed() const { return 0; }
  void move(boundary::plane&, const boundary::wall_load&, double) {}
};
struct drive_without_velocity {
  void move(boundary::plane&, const vector&, double) {}
};
struct drive_without_move {
  vector velocity;
};
struct field_without_pivot : drive_without_velocity {
  Vec3<double> velocity_at(const Vec3<double>& p) const { return p; }
  double approach_speed() const { return 0; }
};
struct field_without_speed : drive_without_velocity {
  Vec3<double> velocity_at(const Vec3<double>& p) const { return p; }
  vector pivot() const { return {}; }
};
template <class D>
inline constexpr bool drives_plane = boundary::Drive<D, boundary::plane>;
static_assert(drives_plane<drive_twin> && drives_plane<field_twin> && drives_plane<boundary::fixed> &&
              drives_plane<boundary::constant_velocity> && drives_plane<boundary::turning> &&
              drives_plane<boundary::servo_stress>);
static_assert(!drives_plane<drive_without_velocity> && !drives_plane<drive_without_move> &&
              !drives_plane<field_without_pivot> && !drives_plane<field_without_speed> && !drives_plane<none>);
static_assert(!boundary::Drive<drive_twin, boundary::cylinder> &&
              !boundary::Drive<boundary::servo_stress, boundary::cylinder> &&
              boundary::Drive<boundary::turning, boundary::cylinder> &&
              boundary::Drive<boundary::turning, boundary::rimmed_cylinder>);

struct rule_twin {
  int minimum_volume;
  float reach(double) const { return 0; }
};
struct rule_without_minimum {
  double reach(double) const { return 0; }
};
struct rule_without_reach {
  double minimum_volume;
};
struct rule_of_nothing {
  double minimum_volume;
  void reach(double) const {}
};
struct changing_rule {
  double minimum_volume;
  double reach(double) { return 0; }
};
static_assert(FormationRule<rule_twin> && FormationRule<formation::at_contact> &&
              FormationRule<formation::within_rupture_distance>);
static_assert(!FormationRule<rule_without_minimum> && !FormationRule<rule_without_reach> &&
              !FormationRule<rule_of_nothing> && !FormationRule<changing_rule> && !FormationRule<none>);

struct sphere_hole {
  boundary::meeting<double> meet(const vector&, double) const { return {}; }
};
struct hole_without_normal {
  double meet(const vector&, double) const { return 0; }
};
struct hole_without_radius {
  boundary::meeting<double> meet(const vector&) const { return {}; }
};
struct changing_hole {
  boundary::meeting<double> meet(const vector&, double) { return {}; }
};
static_assert(boundary::Geometry<sphere_hole> && boundary::Geometry<boundary::plane> &&
              boundary::Geometry<boundary::cylinder>);
static_assert(!boundary::Geometry<hole_without_normal> && !boundary::Geometry<hole_without_radius> &&
              !boundary::Geometry<changing_hole> && !boundary::Geometry<none>);

struct integrator_twin {
  static constexpr int velocity_lag = 0;
  float time_step;
  vector gravity;
  void predict(vector&, vector&, const vector&) const {}
  void predict_spin(vector&, const vector&) const {}
  void correct(vector&, const vector&, const vector&) const {}
  static double stable_step(double, double) { return 1; }
};
static_assert(Integrator<integrator_twin> && Integrator<velocity_verlet> && Integrator<half_step_velocity_verlet>);
static_assert(!Integrator<none> && !Integrator<boundary::fixed> && !Integrator<double>);

struct wordy_step : integrator_twin {
  const char* time_step;
};
struct flat_gravity : integrator_twin {
  double gravity;
};
struct position_only : integrator_twin {
  void predict(vector&, const vector&) const {}
};
struct no_spin : integrator_twin {
  void predict_spin() const {}
};
struct correct_in_one : integrator_twin {
  void correct(vector&, const vector&) const {}
};
struct limit_of_one : integrator_twin {
  static double stable_step(double) { return 1; }
};
struct limit_of_an_object : integrator_twin {
  double stable_step(double, double) const { return 1; }
};
struct vague_lag : integrator_twin {
  static constexpr const char* velocity_lag = "half";
};
struct stateful : integrator_twin {
  void correct(vector&, const vector&, const vector&) {}
};
static_assert(!Integrator<wordy_step> && !Integrator<flat_gravity> && !Integrator<position_only> &&
              !Integrator<no_spin>);
static_assert(!Integrator<correct_in_one> && !Integrator<limit_of_one> && !Integrator<limit_of_an_object>);
static_assert(!Integrator<vague_lag> && !Integrator<stateful>);

}  // namespace
