// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/observe/coordination.hpp>
#include <pendular/observe/energy.hpp>
#include <pendular/observe/stress.hpp>
#include <pendular/scene/compression_result.hpp>
#include <pendular/scene/packing.hpp>
#include <pendular/scene/sample.hpp>
#include <pendular/scene/stages.hpp>
#include <pendular/system.hpp>

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string>
#include <utility>

namespace pendular::scene {

/// Simple compression of a wet cylindrical sample (Richefeu et al. 2007, section 4.2).
struct compression_parameters {
  double area;                    // of the sample before the test, m2
  double gravity = 9.81;          // m/s2
  double relaxation = 0.1;        // without the cylinder, s; 0: none
  double water_content = 0.02;    // w, mass of liquid over mass of grains
  double lid_speed = 1e-3;        // m/s
  double duration = 2;            // of the compression, s
  double time_step = 4e-6;        // s
  double mass_scaling = 1;        // of the inertia; weights stay
  double sample_interval = 1e-3;  // of the stress-strain curve, s
  bond_selection selection{};
  run_options numerics{};
};

inline void validate(const compression_parameters& p) {
  constexpr auto page = "docs/reference/scenes.md";
  expects_positive("the area of the sample (m2)", p.area, page);
  expects_positive("the duration of the compression (s)", p.duration, page);
  expects(std::isfinite(p.gravity), "the gravity (m/s2)", p.gravity, "finite", page);
  expects_positive("the time step (s)", p.time_step, page);
  expects_positive("the mass scaling", p.mass_scaling, page);
  expects_positive("the sample interval (s)", p.sample_interval, page);
  expects_positive("the speed of the lid (m/s)", p.lid_speed, page);
  expects(p.relaxation >= 0 && std::isfinite(p.relaxation), "the duration of the relaxation (s)", p.relaxation,
          "at least 0 and finite", page);
  expects(p.duration >= p.time_step, "the duration of the compression (s)", p.duration, "at least one time step", page);
  expects(p.water_content >= 0 && p.water_content < 1, "the water content w", p.water_content, "in [0, 1)", page);
  validate(p.selection);
}

/// The test for one composition: liquid between the eligible pairs of a sealed packing, no cylinder any more,
/// relaxation, then a lid that moves down at constant speed.
template <class Material, class Liquid>
class simple_compression {
 public:
  using walls_type =
      boundary::walls<boundary::wall<boundary::plane>, boundary::wall<boundary::plane, boundary::constant_velocity>>;
  using system_type = system<Material, Liquid, walls_type, half_step_velocity_verlet>;

  simple_compression(const compression_parameters& p, const Material& m, const Liquid& l)
      : parameters_(checked(p)), system_(m, l, plates(), integrator(p), p.numerics),
        now_(p.time_step, {{"relax", p.relaxation}, {"compress", p.duration}}) {}

  /// Wets the grains. Errors: input_error where the packing is none, the area is not its own, or the wet scene breaks a
  /// limit.
  void start(const sealed_packing& packing) {
    validate(packing);
    const double section = std::numbers::pi * packing.cylinder_radius * packing.cylinder_radius;
    expects(std::abs(parameters_.area / section - 1) < 1e-9, "the area of the sample (m2)", parameters_.area,
            "that of the packing's cylinder", "docs/reference/scenes.md");
    result_.sealed_height = packing.height;
    result_.solid_fraction = packing.solid_fraction;
    add_at_rest(system_, packing.grains, parameters_.mass_scaling);
    const double volume =
        parameters_.water_content * packing.solid_mass / system_.bridges().policies().substance().density;
    system_.distribute_liquid(volume, parameters_.selection);
    result_.initial_bridges = observe::coordination_of(system_).bridges;
    result_.surface_before = surface_height(system_.particles());
    result_.centre_before = mass_centre_height(system_.particles());
  }

  /// From `start` or from where a checkpoint stopped. Errors: run_error.
  const compression_result& run(const monitor& watch) {
    const auto put = [&](io::checkpoint_writer& out) { save(out, result_), io::save(out, system_); };
    const std::int64_t slice = slice_of(parameters_.sample_interval, parameters_.time_step);
    if (!compressing()) {
      now_.run(
          system_, slice, watch, [&] { return look_at_rest(); }, put);
      start_lid();
    }
    now_.run(
        system_, slice, watch, [&] { return record(); }, put);
    return result_;
  }

  void resume(const io::checkpoint_reader& in) {
    const stages there = now_.read(in);
    auto result = result_;
    load(in, result);
    io::load(in, system_, io::winner::file_for_walls);
    now_ = there, result_ = std::move(result);
  }

  /// Called at the end of the relaxation and after every line of the curve.
  std::function<void(const system_type&, const compression_result&)> look;

  const compression_result& result() const { return result_; }
  const system_type& sample() const { return system_; }
  bool compressing() const { return now_.at("compress"); }

 private:
  static constexpr double out_of_the_way = 10;  // height of a lid that is not used, m

  static half_step_velocity_verlet integrator(const compression_parameters& p) {
    return {p.time_step, {0, 0, -p.gravity / p.mass_scaling}};
  }
  static walls_type plates() {
    using boundary::wall, boundary::plane, boundary::constant_velocity;
    return walls_type{wall(plane{{0, 0, 0}, {0, 0, 1}}),
                      wall(plane{{0, 0, out_of_the_way}, {0, 0, -1}}, constant_velocity{{0, 0, 0}})};
  }

  std::string look_at_rest() {
    const double height = surface_height(system_.particles());
    result_.relaxation.push_back({now_.time(), result_.surface_before - height,
                                  result_.centre_before - mass_centre_height(system_.particles()),
                                  observe::coordination_of(system_).bridges});
    return "height " + millimetres(height);
  }

  void start_lid() {
    result_.surface_settlement = result_.surface_before - surface_height(system_.particles());
    result_.centre_settlement = result_.centre_before - mass_centre_height(system_.particles());
    result_.relaxed_bridges = observe::coordination_of(system_).bridges;
    result_.unbalanced_force = observe::unbalanced_force_ratio(system_);
    result_.start_height = tops(system_.particles()).front();
    result_.reference = positions_by_id(system_.particles());
    result_.energy_at_start = observe::energies_of(system_);
    if (look) look(system_, result_);
    auto& lid = boundary::get<1>(system_.walls());
    lid.shape.point.z = result_.start_height;
    lid.drive.velocity = {0, 0, -parameters_.lid_speed};
    system_.canonicalise();
    now_.next();
  }

  std::string record() {
    const auto& lid = boundary::get<1>(system_.walls());
    const auto z = observe::coordination_of(system_);
    const auto energy = observe::energies_of(system_);
    result_.records.push_back({now_.time(), result_.start_height - lid.shape.point.z, lid.force.z / parameters_.area,
                               z.contacts, z.bridges, liquid_kept(system_),
                               energy.balance() - result_.energy_at_start.balance(),
                               energy.turnover_since(result_.energy_at_start)});
    if (look) look(system_, result_);
    const auto& last = result_.records.back();
    return "stress " + std::to_string(std::lround(last.stress)) + " Pa at " + millimetres(last.shortening);
  }

  compression_parameters parameters_;
  system_type system_;
  stages now_;
  compression_result result_;
};

}  // namespace pendular::scene
