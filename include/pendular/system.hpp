// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/liquid_acts.hpp>
#include <pendular/core/expects.hpp>
#include <pendular/core/extremes.hpp>
#include <pendular/core/host.hpp>
#include <pendular/core/never.hpp>
#include <pendular/core/none.hpp>
#include <pendular/liquid/protocol/homogeneous.hpp>
#include <pendular/motion/advance.hpp>
#include <pendular/motion/observer.hpp>
#include <pendular/motion/skin.hpp>
#include <pendular/motion/trouble.hpp>
#include <pendular/scene_state.hpp>
#include <pendular/space/grains.hpp>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace pendular {

/// A DEM scene: material and liquid of the grains, walls, integrator. What is not chosen is not there: no bridge,
/// volume or film without a liquid, no rotation without friction.
template <class Material, class Liquid, class Boundary, class Integration, Host H = alone, GrainTag... Tags>
class system : public scene_state<Material, Liquid, Boundary, Integration, H, Tags...> {
  using state = scene_state<Material, Liquid, Boundary, Integration, H, Tags...>;
  static_assert(Integrator<Integration>,
                "a system needs an integrator as its last policy, such as velocity_verlet{1e-6} "
                "(docs/reference/integrators.md)");

 public:
  using state::contacts, state::expect_limits, state::for_each_wall, state::host, state::pairs, state::time,
      state::view, state::wet;
  using typename state::bonds_type;
  using typename state::clock_start;
  using typename state::grains_type;
  using typename state::options_type;
  using typename state::rows_type;

  // Not deduced from: the guides below say what makes a system.
  using made_of = std::type_identity_t<Material>;

  /// A dry scene has none{} in the place of the liquid, or leaves it out.
  system(const made_of& m, const Liquid& l, const Boundary& b, const Integration& i,
         const options_type& options = default_options())
      : state(m, l, b, i, options) {}
  system(const made_of& m, const Boundary& b, const Integration& i,
         const options_type& options = default_options()) requires(std::is_same_v<Liquid, dry>)
      : system(m, dry{}, b, i, options) {}
  /// With tags of one's own for the grains, as tags<temperature>{}.
  system(const made_of& m, const Liquid& l, const Boundary& b, const Integration& i, tags<Tags...>,
         const options_type& options = default_options())
      : system(m, l, b, i, options) {}
  system(const made_of& m, const Boundary& b, const Integration& i, tags<Tags...>,
         const options_type& options = default_options()) requires(std::is_same_v<Liquid, dry>)
      : system(m, dry{}, b, i, options) {}

  /// Errors: as grains::add.
  void add(const grain& g) {
    grains_.add(g);
    if constexpr (wet) rows_.bridges().resize_films(grains_.size());
    started_ = false;
  }

  /// Takes grains out, by their ids. Their bridges break, and what liquid they then have goes to the account "taken out".
  /// Grains that touched none of them go on with the same bits. Errors: a grain that is not there, all of them, or as
  /// expect_limits(); nothing has changed then.
  void remove(std::initializer_list<std::int64_t> ids) { remove(std::span(ids.begin(), ids.size())); }
  void remove(std::span<const std::int64_t> ids) {
    for (const std::int64_t id : ids) expect_there(id);
    std::vector<char> gone = grains_.marked(ids);
    const auto left = host().any(std::count(gone.begin(), gone.end(), 0) > 0) ? 1.0 : 0.0;
    expects(left > 0, "the number of grains that are left", left, "at least 1", "docs/reference/grains.md");
    change([&] {
      gone = grains_.marked(ids);  // start() may have given the grains other rows
      if constexpr (wet) liquid_now().take_out(gone);
      for (const std::int64_t id : ids) {
        if (driven_.is_driven(id)) driven_.remove(id);
      }
      rebuild(true, 0, gone);
    });
  }

  /// Prescribes the motion of a grain from here on: at these velocities, whatever the forces; at rest without. In contacts
  /// it is then infinitely heavy, as a wall. Errors: a grain that is not there or is driven already.
  void drive(std::int64_t id, const vector& velocity = {0, 0, 0}, const vector& angular_velocity = {0, 0, 0}) {
    expect_there(id);
    driven_.add({id, velocity, angular_velocity});
    driven_.set_off(grains_, {id, velocity, angular_velocity});
    driven_.find(grains_);
  }
  /// Lets it move again. Errors: a grain that is not driven.
  void release(std::int64_t id) {
    driven_.remove(id);
    driven_.find(grains_);
  }
  void restore_driven(std::vector<driven_grain> all, double work) {
    driven_.restore(std::move(all), work);
    driven_.find(grains_);
  }

  /// Lists the pairs and evaluates the forces, so that the state can be looked at before the first step. Grains that were
  /// there before keep their forces.
  void start() {
    if (started_) return;
    expect_grains("the first step");
    domain_ = wide_domain();
    rebuild(true);
    renew();
    expect_limits();
    started_ = true;
  }

  /// Puts liquid of the given volume, m3, between all eligible pairs (Richefeu et al. 2007, Eqs. 13-14). Errors: as
  /// expect_limits(); nothing has changed then.
  void distribute_liquid(double volume, bond_selection selection = {}) requires(wet) {
    validate(selection);
    change([&] {
      rows_.bridges().introduce(volume, host().leads());
      rows_.bridges().select(selection);
      see_far_enough(protocol::homogeneous{}, true);
      liquid_now().redistribute(protocol::homogeneous{});
      rows_.bridges().restore_events({});
    });
  }

  /// Another fluid, or other parameters of the same laws, from here on. Bridges keep their volumes; those that are beyond
  /// their new rupture distance break. Errors: as at construction, or a limit that the scene would break; nothing has
  /// changed then.
  void change_liquid(const Liquid& next) requires(wet) {
    change([&] {
      rows_.bridges().change_policies(next, view());
      if (liquid_now().outgrows_list(near_.skin())) rebuild(true);
    });
  }

  /// What a source or sink does in one of its periods, now. Errors: as distribute_liquid, or of the source.
  template <Source S>
  void exchange(const S& source) requires(wet) {
    check_policy(source);
    change([&] { liquid_now().act(source, integrator_.time_step); });
  }
  /// Liquid moved by hand between the scene and an account outside of it: act(outside_door&).
  template <class Act>
  void exchange(std::string_view account, const Act& act) requires(wet) {
    change([&] { liquid_now().through_door(account, 0, act); });
  }

  /// Errors: input_error for less than 0 steps; run_error, naming grain, step and cause; whatever an observer or a source
  /// throws, after a whole step.
  template <class Watcher = null_observer>
  void run(std::int64_t steps, Watcher&& observer = {}) {
    using watcher = std::remove_cvref_t<Watcher>;
    static_assert(Observer<watcher, system>,
                  "an observer is called with `const system&`, or has a `notice(const bridge_event&)`, or both "
                  "(docs/reference/observe.md)");
    detail::expect_period(observer);
    expects(steps >= 0, "the number of steps of a run", static_cast<double>(steps), "at least 0",
            "docs/reference/system.md");
    start();
    rows_.forget_constants();
    if constexpr (wet) rows_.bridges().keep_log(ObservesEvents<watcher>);
    bool begun = false;
    for (std::int64_t k = 1; k <= steps; ++k) begun = step(begun, k < steps, observer);
  }

  /// Makes neighbour list and running sums anew. Done where a checkpoint is written and where it is read, so that both
  /// runs go on with the same bits.
  /// `reach` is how far the new list must see at least, m. Errors: no grains.
  void canonicalise(double reach = 0) {
    expect_grains("the neighbour list");
    rebuild(true, reach);
    rows_.canonicalise(grains_, view());
  }

  /// Another time step or gravity from here on; the time goes on from where it is. Errors: as at construction, or a limit
  /// that the scene would break; nothing has changed then.
  void change_integrator(const Integration& next) {
    system changed = *this;
    changed.clock_ = {time(), steps_};
    changed.integrator_ = next;
    changed.check_arguments();
    if (started_) changed.expect_limits();
    *this = std::move(changed);
  }

  /// Sets the clock of a run whose grains, walls and bridges a checkpoint has just put back.
  void resume_at(std::int64_t steps, const clock_start& clock) {
    steps_ = steps;
    clock_ = clock;
    domain_ = wide_domain();
    started_ = true;
  }

 private:
  static options_type default_options() requires(!is_distributed<H>) { return {}; }

  using state::check_arguments, state::clock_of, state::expect_grains, state::fastest_driven, state::up,
      state::wide_domain;
  using state::clock_, state::steps_, state::started_;
  using state::rows_, state::integrator_, state::options_, state::grains_, state::driven_, state::near_, state::domain_;

  /// One step, whose first half is done if `begun`. Answers whether the first half of the next is.
  template <class Watcher>
  bool step(bool begun, bool goes_on, Watcher& observer) {
    if (!begun) predict_all();
    for_each_wall([&](auto& wall, auto&) {
      wall.move(integrator_.time_step);
      near_.wall_came(wall.approach_speed() * integrator_.time_step);
    });
    ++steps_;
    if (host().any(near_.is_stale())) rebuild(false);
    std::exception_ptr thrown;
    if constexpr (wet) thrown = act_on_liquid();
    evaluate();
    const bool look = host().any(detail::looks_at_step<system>(observer, steps_) || has_news() || thrown);
    const followed_by what = goes_on && !look ? followed_by::next_step : followed_by::nothing;
    correct_all(what);
    if (thrown) std::rethrow_exception(thrown);
    if (look) together(host(), [&] { detail::tell(observer, *this, take_news()); });
    return what == followed_by::next_step;
  }

  void predict_all() {
    driven_.remember(grains_);
    near_.expire(predict(grains_, integrator_, near_.listed()));
    near_.expire(driven_.impose(grains_, integrator_.gravity, integrator_.time_step, false, true, near_.listed()));
    if constexpr (is_distributed<H>) update_copies(grains_, host());
  }
  void correct_all(followed_by what) {
    driven_.remember(grains_);
    near_.expire(correct(grains_, pairs(), contacts(), rows_.loads(), integrator_, true, what, near_.listed()));
    const bool predicted = what == followed_by::next_step;
    near_.expire(driven_.impose(grains_, integrator_.gravity, integrator_.time_step, true, predicted, near_.listed()));
    if constexpr (is_distributed<H>) update_copies(grains_, host());
  }

  /// All forces of a moving scene, and what bridges do that break or may form.
  void evaluate() {
    const contact_findings found = rows_.evaluate(grains_, pairs(), clock_of(true), host());
    if constexpr (wet) settle_if(found);
  }
  /// The forces of a scene that stands, where something has changed.
  void renew() {
    rows_.forget_constants();
    const contact_findings found = rows_.renew(grains_, pairs(), clock_of(false), host());
    if constexpr (wet) settle_if(found);
    correct(grains_, pairs(), contacts(), rows_.loads(), integrator_, false, followed_by::nothing, near_.listed());
    if constexpr (is_distributed<H>) update_copies(grains_, host());
  }

  /// What changes a standing scene from outside happens as a whole or not at all.
  template <class Act>
  void change(const Act& act) {
    start();
    system before = *this;
    try {
      act();
      renew();
      expect_limits();
    } catch (...) {
      *this = std::move(before);
      tell_rows();  // the grains are where they were before a list was made
      throw;
    }
  }

  /// `standing` if nobody evaluates all forces at once, `reach` is what the list must see besides, m, `gone` marks the
  /// grains that are taken out.
  void rebuild(bool standing, double reach = 0, std::span<const char> gone = {}) {
    together(host(), [&] { check_grains(grains_, domain_, steps_); });
    const double smallest = extremes_of(grains_.template get<column::radius>(), host()).smallest;
    const double way = host().most(longest_way(grains_, fastest_driven(), integrator_.time_step));
    const double skin = smallest * options_.skin.value_or(cheapest_skin(way / smallest));
    double range = skin;
    if constexpr (wet) {
      const pair_view before = view();
      range += std::max(rows_.bridges().reach(before, host()), reach);
      break_torn_bonds(rows_.bridges(), before, range);
    }
    if constexpr (is_distributed<H>) {
      exchange_and_list(standing, range, skin, gone);
    } else {
      list_anew(standing, range, skin, gone);
    }
  }
  void list_anew(bool standing, double range, double skin, std::span<const char> gone) {
    const auto from = near_.relist(grains_, range, skin, gone);
    driven_.find(grains_);
    rows_.relist(grains_, pairs(), up(), {from.of_pairs, from.of_grains, range, skin, standing});
  }

  // Parts of a scene --------------------------------------------------------------------------------------------------

  /// Every grain to its keeper, with copies of those that are near, and all contacts with what they remember.
  void exchange_and_list(bool standing, double range, double skin, std::span<const char> gone) {
    const double largest = extremes_of(grains_.template get<column::radius>(), host()).largest;
    auto bags = luggage_of(rows_, grains_);  // in parts.hpp, which whoever has a host has included
    bags.exchange(pairs(), view(), host(), 2 * largest + range, gone);
    near_.forget();
    list_anew(standing, range, skin, {});
    together(host(), [&] { bags.unpack_contacts(pairs(), view()); });
    tell_rows();
  }
  void tell_rows() const {
    if constexpr (is_distributed<H>) host().know_rows(grains_.template get<column::id>(), grains_.kept());
  }

  void expect_there(std::int64_t id) const {
    if (!host().any(grains_.has_id(id))) grains_.row_of(id);
  }

  // The liquid --------------------------------------------------------------------------------------------------------

  auto liquid_now() { return liquid_acts<rows_type, grains_type, H>(rows_, grains_, pairs(), up(), host()); }

  bool has_news() const {
    if constexpr (wet) return !rows_.bridges().log().empty();
    return false;
  }
  std::vector<bridge_event> take_news() {
    if constexpr (wet) return rows_.bridges().take_log();
    return {};
  }
  /// Sources and sinks, then a global protocol, if their periods end here. Answers what they threw.
  std::exception_ptr act_on_liquid() requires(wet) {
    std::exception_ptr thrown;
    if constexpr (Liquid::has_sources) {
      thrown = liquid_now().act_at(steps_, integrator_.time_step);
      if (host().any(rows_.bridges().asks_protocol())) near_.expire(liquid_now().outgrows_list(near_.skin()));
    }
    if constexpr (Liquid::redistributes_globally) {
      const auto protocol = rows_.bridges().policies().redistribution();
      if (thrown || steps_ % protocol.period != 0) return thrown;
      see_far_enough(protocol, false);
      thrown = liquid_now().all_or_nothing([&] { liquid_now().redistribute(protocol); });
    }
    return thrown;
  }
  /// A global protocol may need pairs that are farther apart than those that are listed.
  template <class P>
  void see_far_enough(const P& protocol, bool standing) {
    const double reach = liquid_now().reach_of(protocol);
    if (pairs().range() < reach + near_.skin()) rebuild(standing, reach);
  }

  void settle_if(const contact_findings& found) requires(wet) {
    const bool asked = liquid_now().settle_if(found);
    if (asked) near_.expire(liquid_now().outgrows_list(near_.skin()));  // liquid may have gathered on a grain
  }
};

/// What other arguments deduce: a sentence.
template <class... Parts>
class system<std::tuple<Parts...>, none, none, none> {
  static_assert(detail::never<std::tuple<Parts...>>,
                "a system is made of a material, a liquid (or nothing), a boundary such as boundary::walls{} and an "
                "integrator, in this order, then tags and run_options where wanted (docs/reference/system.md)");

 public:
  explicit system(const Parts&...) {}
};
template <class... Parts>
system(const Parts&...) -> system<std::tuple<Parts...>, none, none, none>;

template <class... M, LiquidOrNone L, class Boundary, class Integration>
system(const material<M...>&, const L&, const Boundary&, const Integration&, run_options = {})
    -> system<material<M...>, L, Boundary, Integration>;
template <class... M, class Boundary, class Integration>
system(const material<M...>&, const Boundary&, const Integration&, run_options = {})
    -> system<material<M...>, dry, Boundary, Integration>;
template <class... M, LiquidOrNone L, class Boundary, class Integration, class... Tags>
system(const material<M...>&, const L&, const Boundary&, const Integration&, tags<Tags...>, run_options = {})
    -> system<material<M...>, L, Boundary, Integration, alone, Tags...>;
template <class... M, class Boundary, class Integration, class... Tags>
system(const material<M...>&, const Boundary&, const Integration&, tags<Tags...>, run_options = {})
    -> system<material<M...>, dry, Boundary, Integration, alone, Tags...>;

}  // namespace pendular
