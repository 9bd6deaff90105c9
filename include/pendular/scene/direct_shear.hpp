// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/rimmed_cylinder.hpp>
#include <pendular/boundary/servo_stress.hpp>
#include <pendular/observe/coordination.hpp>
#include <pendular/observe/energy.hpp>
#include <pendular/observe/stress.hpp>
#include <pendular/scene/lid.hpp>
#include <pendular/scene/packing.hpp>
#include <pendular/scene/sample.hpp>
#include <pendular/scene/shear_result.hpp>
#include <pendular/scene/stages.hpp>
#include <pendular/system.hpp>

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string>
#include <utility>

namespace pendular::scene {

/// Direct shear of a wet or dry sample in a cylindrical cell of two halves (Richefeu et al. 2007, section 3.2); what the
/// paper leaves out is our choice (docs/reference/scenes.md).
struct shear_parameters {
  double cell_radius = 23e-3;     // m
  double normal_stress = 300;     // of the lid, Pa
  double water_content = 0.01;    // w, mass of liquid over mass of grains
  double solid_fraction = 0.6;    // at which friction comes
  double consolidation = 0.3;     // without friction, at most, s
  double rest = 0.05;             // with friction, before the upper half moves, s
  double shear_speed = 5e-3;      // of the upper half, m/s
  double displacement = 5e-3;     // of the upper half, m
  double gravity = 9.81;          // m/s2
  double time_step = 6e-6;        // s
  double mass_scaling = 1;        // of the inertia; weights stay
  double sample_interval = 1e-5;  // of the curve, m
  bond_selection selection{};
  run_options numerics{};

  double area() const { return std::numbers::pi * cell_radius * cell_radius; }
  double duration() const { return displacement / shear_speed; }
};

inline void validate(const shear_parameters& p) {
  constexpr auto page = "docs/reference/scenes.md";
  expects_positive("the radius of the cell (m)", p.cell_radius, page);
  expects_positive("the normal stress (Pa)", p.normal_stress, page);
  expects_positive("the duration of the consolidation (s)", p.consolidation, page);
  expects_positive("the duration of the rest (s)", p.rest, page);
  expects_positive("the speed of the upper half (m/s)", p.shear_speed, page);
  expects_positive("the displacement of the upper half (m)", p.displacement, page);
  expects(std::isfinite(p.gravity), "the gravity (m/s2)", p.gravity, "finite", page);
  expects_positive("the time step (s)", p.time_step, page);
  expects_positive("the mass scaling", p.mass_scaling, page);
  expects_positive("the sample interval (m)", p.sample_interval, page);
  expects(p.displacement < p.cell_radius, "the displacement of the upper half (m)", p.displacement,
          "less than the radius of the cell", page);
  expects(p.duration() >= p.time_step, "the displacement over the speed (s)", p.duration(), "at least one time step",
          page);
  expects(p.solid_fraction > 0 && p.solid_fraction < 0.74, "the solid fraction", p.solid_fraction, "in (0, 0.74)",
          page);
  expects(p.water_content >= 0 && p.water_content < 1, "the water content w", p.water_content, "in [0, 1)", page);
  validate(p.selection);
}

/// The contacts in the stages of the test: all of the same laws.
template <class Material>
struct shear_materials {
  Material smooth;  // of everything while the sample is consolidated
  Material grains;
  Material halves;  // of the cell
  Material plates;  // floor and lid
};
template <class Material>
shear_materials(const Material&, const Material&, const Material&, const Material&) -> shear_materials<Material>;

/// The test for one composition: liquid between the eligible pairs of a deposited sample, consolidation under the lid
/// without friction, rest with friction, then the upper half and the lid move at constant speed. `dry{}` in place of the
/// liquid makes a scene without any.
template <class Material, class Liquid>
class direct_shear {
 public:
  using cell_half = boundary::wall<boundary::rimmed_cylinder, boundary::constant_velocity, Material>;
  using walls_type = boundary::walls<boundary::wall<boundary::plane, boundary::fixed, Material>, cell_half, cell_half,
                                     boundary::wall<boundary::plane, boundary::servo_stress, Material>>;
  using system_type = system<Material, Liquid, walls_type, half_step_velocity_verlet>;

  direct_shear(const shear_parameters& p, const shear_materials<Material>& m, const Liquid& l)
      : parameters_(checked(p)), materials_(m), system_(build(p, m.smooth, l)),
        now_(p.time_step, {{"consolidate", p.consolidation}, {"rest", p.rest}, {"shear", p.duration()}}) {}

  /// Wets the grains and puts the lid on. Errors: input_error where the packing is none or not of this cell, or the scene
  /// breaks a limit.
  void start(const sealed_packing& packing) {
    validate(packing);
    expects(std::abs(packing.cylinder_radius / parameters_.cell_radius - 1) < 1e-9,
            "the radius of the packing's cylinder (m)", packing.cylinder_radius, "that of the cell",
            "docs/reference/scenes.md");
    result_.sample.deposited_height = packing.height;
    add_at_rest(system_, packing.grains, parameters_.mass_scaling);
    lid().shape.point.z = packing.height;
    system_.start();
    if constexpr (system_type::wet) {
      const double density = system_.bridges().policies().substance().density;
      system_.distribute_liquid(parameters_.water_content * packing.solid_mass / density, parameters_.selection);
    }
    result_.sample.initial_bridges = observe::coordination_of(system_).bridges;
  }

  /// From `start` or from where a checkpoint stopped. Errors: run_error.
  const shear_result& run(const monitor& watch) {
    const auto put = [&](io::checkpoint_writer& out) { save(out, result_), io::save(out, system_); };
    const auto news = [&] { return look_at_density(); };
    if (now_.at("consolidate")) {
      now_.run(system_, 1, watch, news, put, [&] { return solid_fraction() >= parameters_.solid_fraction; });
      add_friction();
    }
    if (now_.at("rest")) {
      now_.run(system_, slice, watch, news, put);
      start_shear();
    }
    now_.run(
        system_, slice_of(parameters_.sample_interval / parameters_.shear_speed, parameters_.time_step), watch,
        [&] { return record(); }, put);
    return result_;
  }

  void resume(const io::checkpoint_reader& in) {
    const stages there = now_.read(in);
    auto result = result_;
    load(in, result);
    direct_shear rough = *this;  // which the grains are once they rest
    if (!there.at("consolidate")) rough.roughen();
    io::load(in, rough.system_, io::winner::file_for_walls);
    system_ = std::move(rough.system_);
    now_ = there, result_ = std::move(result);
  }

  /// Called at the start of the shear and after every line of the curve.
  std::function<void(const system_type&, const shear_result&)> look;

  const shear_result& result() const { return result_; }
  const system_type& sample() const { return system_; }
  bool shearing() const { return now_.at("shear"); }

 private:
  static constexpr double out_of_the_way = 10;  // height of a rim while the cell is one piece, m
  static constexpr std::int64_t slice = 200;    // steps

  static system_type build(const shear_parameters& p, const Material& m, const Liquid& l) {
    const half_step_velocity_verlet integrator{p.time_step, {0, 0, -p.gravity / p.mass_scaling}};
    if constexpr (system_type::wet) {
      return system_type(m, l, cell(p, m), integrator, p.numerics);
    } else {
      return system_type(m, cell(p, m), integrator, p.numerics);
    }
  }

  /// In one piece: the lower half reaches above all grains.
  static walls_type cell(const shear_parameters& p, const Material& m) {
    using boundary::wall, boundary::plane, boundary::rimmed_cylinder, boundary::constant_velocity, boundary::fixed;
    const vector rim{0, 0, out_of_the_way};
    return walls_type{wall(plane{{0, 0, 0}, {0, 0, 1}}, fixed{}, m),
                      wall(rimmed_cylinder{rim, {0, 0, -1}, p.cell_radius}, constant_velocity{{0, 0, 0}}, m),
                      wall(rimmed_cylinder{rim, {0, 0, 1}, p.cell_radius}, constant_velocity{{0, 0, 0}}, m),
                      wall(plane{rim, {0, 0, -1}}, loading_lid(p.normal_stress, p.area(), p.mass_scaling), m)};
  }

  std::string look_at_density() {
    return "solid fraction " + std::to_string(solid_fraction()).substr(0, 6) + ", height " +
           millimetres(lid().shape.point.z);
  }

  void add_friction() {
    auto& sample = result_.sample;
    sample.consolidation_time = now_.time();
    sample.solid_fraction = solid_fraction();
    sample.split_height = 0.5 * lid().shape.point.z;
    for (auto* half : {&lower_half(), &upper_half()}) half->shape.point.z = sample.split_height;
    roughen();
    system_.expect_limits();
    system_.canonicalise();
    now_.next();
  }

  void start_shear() {
    auto& sample = result_.sample;
    sample.start = {lid().shape.point.z, observe::coordination_of(system_).bridges,
                    observe::unbalanced_force_ratio(system_), stresses().shear, density()};
    result_.reference = positions_by_id(system_.particles());
    result_.energy_at_start = observe::energies_of(system_);
    if (look) look(system_, result_);
    upper_half().drive.velocity = lid().drive.sliding = {parameters_.shear_speed, 0, 0};
    system_.canonicalise();
    now_.next();
  }

  void roughen() {
    system_.contact_material() = materials_.grains;
    for (auto* half : {&lower_half(), &upper_half()}) half->material = materials_.halves;
    boundary::get<0>(system_.walls()).material = materials_.plates;
    lid().material = materials_.plates;
  }

  std::string record() {
    const double time = now_.time();
    const auto z = observe::coordination_of(system_);
    const auto energy = observe::energies_of(system_);
    result_.records.push_back(
        {time,
         time * parameters_.shear_speed,
         stresses(),
         lid().shape.point.z,
         z.contacts,
         z.bridges,
         liquid_kept(system_),
         {energy.balance() - result_.energy_at_start.balance(), energy.turnover_since(result_.energy_at_start)}});
    if (look) look(system_, result_);
    const auto& last = result_.records.back();
    return "shear stress " + std::to_string(std::lround(last.stress.shear)) + " Pa at " +
           millimetres(last.displacement);
  }

  shear_stresses stresses() {
    const auto& g = system_.particles();
    const auto position = g.template get<column::position>();
    const auto inverse_mass = g.template get<column::inverse_mass>();
    double weight = 0;  // of the grains below the plane between the halves, N
    for (std::size_t k = 0; k < g.size(); ++k) {
      if (position[k].z < result_.sample.split_height) weight -= system_.integrator().gravity.z / inverse_mass[k];
    }
    const double below = -boundary::get<0>(system_.walls()).force.z - lower_half().force.z - weight;
    return {-(upper_half().force.x + lid().force.x) / parameters_.area(), lid().force.z / parameters_.area(),
            below / parameters_.area()};
  }

  observe::solid_fractions density() {
    const auto& g = system_.particles();
    const double diameter =
        2 * ::ranges::accumulate(g.template get<column::radius>(), 0.0) / static_cast<double>(g.size());
    return observe::solid_fractions_of(g, {parameters_.cell_radius, 0, lid().shape.point.z}, 2 * diameter);
  }

  double solid_fraction() { return solid_volume(system_.particles()) / (parameters_.area() * lid().shape.point.z); }

  auto& lower_half() { return boundary::get<1>(system_.walls()); }
  auto& upper_half() { return boundary::get<2>(system_.walls()); }
  auto& lid() { return boundary::get<3>(system_.walls()); }

  shear_parameters parameters_;
  shear_materials<Material> materials_;
  system_type system_;
  stages now_;
  shear_result result_;
};

}  // namespace pendular::scene
