// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/wall.hpp>
#include <pendular/boundary/wall_contacts_of.hpp>
#include <pendular/boundary/wet_rows.hpp>
#include <pendular/contact/pair_contacts.hpp>
#include <pendular/liquid/redistribution.hpp>
#include <pendular/motion/admissible_time_step.hpp>
#include <pendular/motion/advance.hpp>
#include <pendular/motion/scene_check.hpp>
#include <pendular/motion/skin.hpp>
#include <pendular/motion/trouble.hpp>
#include <pendular/motion/velocity_verlet.hpp>
#include <pendular/space/grains.hpp>
#include <pendular/space/pair_list.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace pendular {

/// In place of a liquid in a dry scene.
struct dry {};

/// Numbers that are not physics.
struct run_options {
  std::optional<double> skin = {};  // of the Verlet list, in units of the smallest radius; empty: the cheapest
  double overlap_limit = 0.1;       // a larger overlap, in units of the smaller radius, stops the run
  double domain_margin = 10;        // a grain this many sizes of the first packing away from it is lost
  bool force = false;               // run even if the scene breaks a limit
};

namespace detail {
template <class Liquid>
struct bonds_of {
  using type = bonds<Liquid>;
};
template <>
struct bonds_of<dry> {
  using type = no_bonds;
};
}  // namespace detail

/// A DEM scene: material and liquid of the grains, walls, integrator. What is not chosen is not there: no bridge,
/// volume or film without a liquid, no rotation without friction.
template <class Material, class Liquid, class Boundary, class Integration>
class system {
  static_assert(Integrator<Integration>,
                "a system needs an integrator as its last policy, such as velocity_verlet{1e-6} "
                "(docs/reference/integrators.md)");

 public:
  using material_type = Material;
  using liquid_type = Liquid;
  using bonds_type = typename detail::bonds_of<Liquid>::type;
  using grains_type = grains<Material::has_friction, Material::counts_contacts>;
  using contacts_type = pair_contacts<Material, bonds_type>;
  static constexpr bool wet = !std::is_same_v<Liquid, dry>;

  system(const Material& m, const Liquid& l, const Boundary& b, const Integration& i,
         run_options options = {}) requires(!std::is_same_v<Liquid, dry>)
      : material_(m), bonds_(l), walls_(b), integrator_(i), options_(options) {
    check_arguments();
  }
  system(const Material& m, const Boundary& b, const Integration& i,
         run_options options = {}) requires(std::is_same_v<Liquid, dry>)
      : material_(m), walls_(b), integrator_(i), options_(options) {
    check_arguments();
  }

  /// Errors: as grains::add.
  void add(const grain& g) {
    grains_.add(g);
    if constexpr (wet) bonds_.book().resize_films(grains_.size());
    started_ = false;
  }

  /// Lists the pairs and evaluates the forces, so that the state can be looked at before the first step.
  void start() {
    if (started_) return;
    expect_grains();
    domain_ = around(bounding_box(grains_.template get<column::position>()));
    rebuild();
    evaluate(false);
    expect_limits();
    started_ = true;
  }

  /// What the scene must keep below a bound, as it stands: time step, damping, stiffness. Errors: no grains.
  std::vector<scene_limit> limits() const {
    expect_grains();
    auto rigidities = detail::rigidities(grains_, list_, material_);
    const double near = 0.2 * extreme_radii(grains_).first;  // whatever the skin
    for_each_wall(
        [&](const auto& wall, const auto&) { detail::add_wall(rigidities, grains_, wall, material_of(wall), near); });
    std::vector<scene_limit> all{
        contact_step_limit(integrator_, grains_, rigidities),
        viscosity_step_limit(integrator_, grains_, rigidities, material_), damping_limit(grains_, material_),
        pressure_limit(grains_, material_, weight_pressure(grains_, integrator_.gravity) + lid_stress(*this))};
    if constexpr (wet) {
      const pair_view now = view();
      all.push_back(capillary_step_limit(integrator_, grains_, now, bonds_));
      if constexpr (Liquid::is_viscous) all.push_back(bridge_viscosity_step_limit(integrator_, grains_, now, bonds_));
      all.push_back(bridge_softness_limit(material_, now, bonds_));
    }
    return all;
  }

  /// Done at the start and whenever liquid is put in. Errors: input_error with value and bound of every limit broken,
  /// unless run_options::force is set.
  void expect_limits() const {
    if (options_.force) return;
    if (const std::string broken = violations(limits()); !broken.empty()) throw input_error(broken);
  }

  /// Puts liquid of the given volume, m3, between all eligible pairs (Richefeu et al. 2007, Eqs. 13-14).
  void distribute_liquid(double volume, bond_selection selection = {}) requires(!std::is_same_v<Liquid, dry>) {
    validate(selection);
    start();
    bonds_.book().introduce(volume);
    bonds_.select(selection);
    redistribute();
    events_ = {};
    evaluate(false);
    expect_limits();
  }

  /// Errors: run_error, naming grain, step and cause.
  void run(std::int64_t steps) {
    start();
    forget_constants();
    if (steps > 0) stale_ |= predict(grains_, integrator_, listing{listed_at_, 0.5 * skin_});
    for (std::int64_t k = 1; k <= steps; ++k) step(k < steps ? followed_by::next_step : followed_by::nothing);
  }

  const grains_type& particles() const { return grains_; }
  grains_type& particles() { return grains_; }
  const pair_list& pairs() const { return list_; }
  const contacts_type& contacts() const { return contacts_; }
  contacts_type& contacts() { return contacts_; }
  const bonds_type& bridges() const { return bonds_; }
  bonds_type& bridges() { return bonds_; }
  const Material& contact_material() const { return material_; }
  Material& contact_material() { return material_; }
  const Integration& integrator() const { return integrator_; }
  const Boundary& walls() const { return walls_; }
  Boundary& walls() { return walls_; }

  std::int64_t step_count() const { return steps_; }
  std::int64_t rebuild_count() const { return rebuilds_; }
  double time() const { return static_cast<double>(steps_) * integrator_.time_step; }
  const bond_events& events() const { return events_; }
  const bond_selection& selection() const requires(!std::is_same_v<Liquid, dry>) { return bonds_.selection(); }
  /// Whether bridges lost their pair to a jump and their liquid waits for the next step.
  bool has_torn_bonds() const { return torn_; }

  /// The listed pairs as the observers see them, and as the liquid does the grains near wettable walls.
  pair_view view() const {
    const double g = norm(integrator_.gravity);
    const vector up = g > 0 ? (-1.0 / g) * integrator_.gravity : vector{0, 0, 0};
    pair_view v{list_.first(),
                list_.second(),
                list_.size(),
                grains_.template get<column::position>(),
                grains_.template get<column::radius>(),
                grains_.template get<column::id>(),
                up};
    if constexpr (wet) boundary::append_wet_rows(*this, v);
    return v;
  }

  /// The wall's own material, or the grains'.
  template <class Wall>
  const auto& material_of(const Wall& wall) const {
    if constexpr (std::is_same_v<decltype(Wall::material), none>) {
      return material_;
    } else {
      return wall.material;
    }
  }

  /// visit(wall, its contacts) for all walls in the order they were given.
  template <class Visit>
  void for_each_wall(const Visit& visit) {
    for_each_wall_of(*this, visit);
  }
  template <class Visit>
  void for_each_wall(const Visit& visit) const {
    for_each_wall_of(*this, visit);
  }

  /// Makes neighbour list and running sums anew. Done where a checkpoint is written and where it is read, so that both
  /// runs go on with the same bits.
  /// `reach` is how far the new list must see at least, m. Errors: no grains.
  void canonicalise(double reach = 0) {
    expect_grains();
    wanted_reach_ = reach;
    rebuild();
    wanted_reach_ = 0;
    contacts_.recall_gap(view());
    contacts_.work().fold();
    for_each_wall([&](auto& wall, auto& contacts) {
      contacts.recall_gap(grains_, wall);
      contacts.work().fold();
    });
  }

  /// Sets the clock of a run whose grains, walls and bridges a checkpoint has just put back.
  /// `torn` is what `has_torn_bonds` said of it.
  void resume_at(std::int64_t steps, const bond_selection& selection, const bond_events& events, bool torn) {
    steps_ = steps;
    if constexpr (wet) bonds_.select(selection);
    events_ = events;
    torn_ = torn;
    domain_ = around(bounding_box(grains_.template get<column::position>()));
    started_ = true;
  }

 private:
  template <class Self, class Visit>
  static void for_each_wall_of(Self& self, const Visit& visit) {
    constexpr auto count = std::tuple_size_v<std::remove_cvref_t<decltype(self.walls_.all)>>;
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (visit(std::get<I>(self.walls_.all), std::get<I>(self.wall_contacts_)), ...);
    }
    (std::make_index_sequence<count>{});
  }

  void expect_grains() const {
    expects(grains_.size() > 0, "the number of grains", 0, "at least 1", "docs/reference/system.md");
  }

  void check_arguments() const {
    constexpr auto page = "docs/reference/system.md";
    validate(integrator_);
    const double skin = options_.skin.value_or(1);
    expects(skin > 0 && skin < 10, "the skin in units of the smallest radius", skin, "in (0, 10)", page);
    expects(options_.overlap_limit > 0 && options_.overlap_limit < 1, "the overlap limit in units of the radius",
            options_.overlap_limit, "in (0, 1)", page);
    if constexpr (wet) {
      if constexpr (Liquid::needs_gravity) {
        expects(norm(integrator_.gravity) > 0, "the gravity of a scene with protocol::gravity (m/s2)", 0.0,
                "different from 0", "docs/reference/liquid.md");
      }
    }
  }

  box around(const box& b) const {
    const vector size = b.upper - b.lower;
    const double margin = options_.domain_margin * (size.x + size.y + size.z + 100 * extreme_radii(grains_).second);
    const vector all_around{margin, margin, margin};
    return {b.lower - all_around, b.upper + all_around};
  }

  /// Masses and materials may have been changed by hand.
  void forget_constants() {
    contacts_.forget_constants();
    for_each_wall([&](const auto&, auto& contacts) { contacts.forget_constants(); });
  }

  /// From the first half of this step on, to the first half of the next if there is one.
  void step(followed_by what) {
    for_each_wall([&](auto& wall, auto&) {
      wall.move(integrator_.time_step);
      wall_travel_ += norm(wall.drive.velocity) * integrator_.time_step;
    });
    ++steps_;
    if (stale_ || wall_travel_ > 0.5 * skin_) rebuild();
    if constexpr (wet) {
      if constexpr (Liquid::redistributes_globally) {
        if (steps_ % bonds_.policies().redistribution().period == 0) redistribute();
      }
    }
    evaluate(true, what);
  }

  void rebuild() {
    check_grains(grains_, domain_, steps_);
    const double small = extreme_radii(grains_).first;
    skin_ = small * options_.skin.value_or(cheapest_skin(longest_way(*this) / small));
    double range = skin_;
    if constexpr (wet) {
      const pair_view before = view();
      range += std::max(bonds_.reach(before), wanted_reach_);
      const std::int64_t torn = break_torn_bonds(bonds_, before, range);
      events_.ruptures += torn;
      torn_ |= torn > 0;
    }
    const graded_grid grid(grains_.template get<column::position>(), grains_.template get<column::radius>(), range);
    const auto order = grid.order(grains_.template get<column::id>());
    grains_.permute(order);
    const auto origin = list_.rebuild(grains_.template get<column::position>(), grains_.template get<column::radius>(),
                                      grains_.template get<column::id>(), grid, range, range - skin_, order);
    contacts_.carry(origin, list_.padded_size());
    relist_walls(origin, order, range);
    const auto places = grains_.template rows<grain_row::place>();
    listed_at_.assign(places.begin(), places.end());
    wall_travel_ = 0;
    stale_ = false;
    ++rebuilds_;
  }

  /// The grains near every wall, and the rows of the bonds behind pairs and walls.
  void relist_walls(const std::vector<std::int32_t>& pair_origin, const std::vector<std::size_t>& order, double range) {
    auto bond_origin = pair_origin;
    bond_origin.resize(list_.padded_size(), -1);
    loads_.relist(grains_.size());
    for_each_wall([&](const auto& wall, auto& contacts) {
      constexpr bool carries_bridges = std::remove_cvref_t<decltype(contacts)>::carries_bridges;
      const auto places = contacts.rebuild(grains_, wall, carries_bridges ? range : skin_, order);
      if constexpr (carries_bridges) contacts.take_bond_rows(places, bond_origin);
      loads_.list(contacts);
    });
    if constexpr (wet) {
      bonds_.book().permute_films(order);
      bonds_.carry(bond_origin, view());
    }
  }

  void redistribute() requires(!std::is_same_v<Liquid, dry>) {
    const pair_view listed = view();
    wanted_reach_ = homogeneous_reach(bonds_, listed, candidates(listed, selection()), bonds_.book().introduced());
    if (list_.range() < wanted_reach_ + skin_) rebuild();
    wanted_reach_ = 0;
    count(distribute_homogeneously(bonds_, view(), selection()));
  }

  void count(const bond_events& e) {
    events_.ruptures += e.ruptures;
    events_.formations += e.formations;
  }

  void settle() requires(!std::is_same_v<Liquid, dry>) {
    const pair_view v = view();
    const auto pairs_of = [&](std::size_t grain) { return list_.pairs_of(grain); };
    if (v.wet_walls) {
      count(settle_bonds(bonds_, v, boundary::gaps_of_all_rows(*this).history(), pairs_of));
    } else {
      count(settle_bonds(bonds_, v, contacts_.gaps(), pairs_of));
    }
    stale_ |= bonds_.formation_reach(v) + skin_ > list_.range();  // liquid has gathered on a grain
  }

  void evaluate(bool moving, followed_by what = followed_by::nothing) {
    if (!moving) forget_constants();
    const contact_clock clock{integrator_.time_step, Integration::velocity_lag, options_.overlap_limit, moving};
    contact_findings found = contacts_.evaluate(grains_, list_, material_, bonds_, clock);
    if (found.trouble) report_pair_trouble(grains_, list_, contacts_, options_.overlap_limit, steps_);
    loads_.clear();
    for_each_wall([&](auto& wall, auto& contacts) {
      const contact_findings here = contacts.evaluate(grains_, wall, material_of(wall), bonds_, clock);
      if (here.trouble) report_wall_trouble(grains_, contacts, options_.overlap_limit, steps_);
      found |= here;
      wall.take(contacts.force_on_wall(), moving ? clock.time_step : 0);
      loads_.add(contacts);
    });
    if constexpr (wet) {
      if (found.liquid_event || torn_) settle();
      torn_ = false;
    }
    stale_ |= correct(grains_, list_, contacts_, loads_, integrator_, moving, what, {listed_at_, 0.5 * skin_});
  }

  Material material_;
  bonds_type bonds_;
  Boundary walls_;
  Integration integrator_;
  run_options options_;
  grains_type grains_;
  pair_list list_;
  contacts_type contacts_;
  typename detail::wall_contacts_of<Material, bonds_type, Boundary>::type wall_contacts_;
  wall_loads<grains_type> loads_;
  std::vector<grain_row::place> listed_at_;
  box domain_{};
  bond_events events_;
  std::int64_t steps_ = 0, rebuilds_ = 0;
  double skin_ = 0, wall_travel_ = 0, wanted_reach_ = 0;
  bool stale_ = true, started_ = false, torn_ = false;
};

template <class... M, class... L, class Boundary, class Integration>
system(const material<M...>&, const liquid<L...>&, const Boundary&, const Integration&, run_options = {})
    -> system<material<M...>, liquid<L...>, Boundary, Integration>;
template <class... M, class Boundary, class Integration>
system(const material<M...>&, const Boundary&, const Integration&, run_options = {})
    -> system<material<M...>, dry, Boundary, Integration>;

}  // namespace pendular
