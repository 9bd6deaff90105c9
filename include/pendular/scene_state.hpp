// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/scene_rows.hpp>
#include <pendular/core/extremes.hpp>
#include <pendular/core/host.hpp>
#include <pendular/motion/driven_grains.hpp>
#include <pendular/motion/run_options.hpp>
#include <pendular/motion/scene_check.hpp>
#include <pendular/motion/velocity_verlet.hpp>
#include <pendular/space/grains.hpp>
#include <pendular/space/neighbourhood.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace pendular {

template <class H>
struct run_on;

namespace detail {
template <class H>
struct options_on {
  using type = run_on<H>;
};
template <>
struct options_on<alone> {
  using type = run_options;
};
}  // namespace detail

/// What a scene is, and how it is looked at: grains, the rows of their pairs and walls, list, integrator and clock. A system
/// is this and moves it.
template <class Material, class Liquid, class Boundary, class Integration, Host H, GrainTag... Tags>
class scene_state {
 public:
  /// run_options, with the host where there is one.
  using options_type = typename detail::options_on<H>::type;
  using material_type = Material;
  using liquid_type = Liquid;
  using rows_type = scene_rows<Material, Liquid, Boundary>;
  using bonds_type = typename rows_type::bonds_type;
  using grains_type = grains<Material::has_friction, Material::counts_contacts, Tags...>;
  using contacts_type = typename rows_type::contacts_type;
  static constexpr bool wet = rows_type::wet;
  static constexpr bool is_part = is_distributed<H>;

  scene_state(const Material& m, const Liquid& l, const Boundary& b, const Integration& i, const options_type& options)
      : rows_(m, l, b), integrator_(i), options_(options) {
    check_arguments();
  }

  const grains_type& particles() const { return grains_; }
  grains_type& particles() { return grains_; }
  const pair_list& pairs() const { return near_.list(); }
  const contacts_type& contacts() const { return rows_.contacts(); }
  contacts_type& contacts() { return rows_.contacts(); }
  const bonds_type& bridges() const { return rows_.bridges(); }
  const Material& contact_material() const { return rows_.material(); }
  Material& contact_material() { return rows_.material(); }
  const Integration& integrator() const { return integrator_; }
  const Boundary& walls() const { return rows_.walls(); }
  Boundary& walls() { return rows_.walls(); }
  /// What a checkpoint puts back.
  rows_type& rows() { return rows_; }

  /// visit(policy) for those of material and liquid and for the integrator.
  template <class Visit>
  void for_each_policy(const Visit& visit) const {
    rows_.material().for_each_policy(visit);
    if constexpr (wet) rows_.bridges().policies().for_each_policy(visit);
    visit(integrator_);
  }

  std::int64_t step_count() const { return steps_; }
  std::int64_t rebuild_count() const { return near_.rebuild_count(); }
  double time() const {  // s
    return clock_.time + static_cast<double>(steps_ - clock_.step) * integrator_.time_step;
  }
  const bond_events& events() const requires(wet) { return rows_.bridges().events(); }
  const bond_selection& selection() const requires(wet) { return rows_.bridges().selection(); }

  /// For observers. Errors: input_error if forces are not known yet.
  void expect_evaluated(std::string_view who) const {
    static_assert(
        !is_distributed<H>,
        "observers look at a scene in one piece: of a part, add up the rows that `view().counts_here(row)` says "
        "and the grains before `particles().kept()` (docs/reference/host.md)");
    if (started_) return;
    throw input_error(std::string(who) +
                      " looks at forces, which have not been evaluated since grains were added: call "
                      "start() or run() first (see docs/reference/observe.md)");
  }

  /// The listed pairs as the observers see them, and as the liquid does the grains near wettable walls.
  pair_view view() const { return rows_.view(grains_, pairs(), up()); }

  /// The wall's own material, or the grains'.
  template <class Wall>
  const auto& material_of(const Wall& wall) const {
    return rows_.material_of(wall);
  }

  /// visit(wall, its contacts) for all walls in the order they were given.
  template <class Visit>
  void for_each_wall(const Visit& visit) {
    rows_.for_each_wall(visit);
  }
  template <class Visit>
  void for_each_wall(const Visit& visit) const {
    rows_.for_each_wall(visit);
  }

  const driven_grains& driven() const { return driven_; }

  /// What speaks with the other parts of the scene.
  H host() const {
    if constexpr (is_distributed<H>) {
      return options_.host;
    } else {
      return {};
    }
  }

  /// When the integrator was last changed.
  struct clock_start {
    double time = 0;  // s
    std::int64_t step = 0;
  };
  const clock_start& clock_began() const { return clock_; }

  /// What the scene must keep below a bound, as it stands: time step, damping, stiffness; what bounds nothing here is
  /// left out. Errors: no grains.
  std::vector<scene_limit> limits() const {
    expect_grains("a list of limits");
    return limits_of_rows();
  }

  /// Done at the start and whenever liquid is put in. Errors: input_error for a scene without grains, and with value and
  /// bound of every limit broken unless run_options::force is set.
  void expect_limits() const {
    expect_grains("a check of limits");
    if (options_.force) return;
    together(host(), [&] {
      if (is_distributed<H> && grains_.size() == 0) return;  // nothing is here
      if (const std::string broken = violations(limits_of_rows()); !broken.empty()) throw input_error(broken);
    });
  }

 protected:
  /// Of the grains and pairs that are here, of which there must be some; nobody else is asked.
  std::vector<scene_limit> limits_of_rows() const {
    const auto walls = [&](const auto& visit) {
      for_each_wall([&](const auto& wall, const auto&) { visit(wall, material_of(wall)); });
    };
    std::vector<scene_limit> all = contact_limits(integrator_, grains_, pairs(), rows_.material(), walls);
    if constexpr (wet) {
      const auto of_bridges = bridge_limits(integrator_, grains_, rows_.material(), view(), bridges());
      all.insert(all.end(), of_bridges.begin(), of_bridges.end());
    }
    std::erase_if(all, [](const scene_limit& l) { return l.bound == HUGE_VAL; });
    return all;
  }

  void check_arguments() const {
    if constexpr (requires { validate(integrator_); }) validate(integrator_);
    validate(options_);
    if constexpr (wet) {
      if constexpr (Liquid::needs_gravity) {
        expects(norm(integrator_.gravity) > 0, "the gravity of a scene with protocol::gravity (m/s2)", 0.0,
                "different from 0", "docs/reference/liquid.md");
      }
    }
  }
  void expect_grains(std::string_view of_what) const {
    expects(host().any(grains_.size() > 0), "the number of grains, where " + std::string(of_what) + " is asked for,", 0,
            "at least 1", "docs/reference/system.md");
  }

  vector up() const {
    const double g = norm(integrator_.gravity);
    return g > 0 ? (-1.0 / g) * integrator_.gravity : vector{0, 0, 0};
  }
  /// Where the grains of all parts may go.
  box wide_domain() const {
    const box b = over_all_parts(bounding_box(grains_.template get<column::position>()));
    const vector size = b.upper - b.lower;
    const double largest = extremes_of(grains_.template get<column::radius>(), host()).largest;
    const double margin = options_.domain_margin * (size.x + size.y + size.z + 100 * largest);
    const vector all_around{margin, margin, margin};
    return {b.lower - all_around, b.upper + all_around};
  }
  box over_all_parts(const box& b) const {
    const auto least = [&](double v) { return -host().most(grains_.size() > 0 ? -v : -HUGE_VAL); };
    const auto most = [&](double v) { return host().most(grains_.size() > 0 ? v : -HUGE_VAL); };
    return {{least(b.lower.x), least(b.lower.y), least(b.lower.z)},
            {most(b.upper.x), most(b.upper.y), most(b.upper.z)}};
  }
  /// Of a driven grain or a wall, m/s.
  double fastest_driven() const {
    double speed = driven_.fastest();
    for_each_wall([&](const auto& wall, const auto&) { speed = std::max(speed, wall.approach_speed()); });
    return speed;
  }
  contact_clock clock_of(bool moving) const {
    return {integrator_.time_step, Integration::velocity_lag, options_.overlap_limit, moving, steps_};
  }

  rows_type rows_;
  Integration integrator_;
  options_type options_;
  grains_type grains_;
  driven_grains driven_;
  neighbourhood near_;
  box domain_{};
  clock_start clock_;
  std::int64_t steps_ = 0;
  bool started_ = false;
};

}  // namespace pendular
