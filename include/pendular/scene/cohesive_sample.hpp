// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/observe/coordination.hpp>
#include <pendular/observe/energy.hpp>
#include <pendular/observe/stress.hpp>
#include <pendular/scene/box_packing.hpp>
#include <pendular/scene/cohesive_result.hpp>
#include <pendular/scene/sample.hpp>
#include <pendular/scene/stages.hpp>
#include <pendular/system.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>

namespace pendular::scene {

/// The wet sample whose forces Richefeu et al. 2006 (Eur. Phys. J. E 21, 359) look at, without gravity and by default
/// without confining pressure; what the paper leaves out is our choice.
struct cohesive_parameters {
  double water_content = 0.007;    // w, mass of liquid over mass of grains
  double confining_pressure = 0;   // of the six walls, Pa
  double relaxation = 0.5;         // at most, s
  double unbalanced_force = 1e-3;  // mean over the mean force of a pair, at which the sample is at rest
  double stress_tolerance = 1;     // by which the stress on the walls at rest may differ from the pressure, Pa
  double time_step = 4e-6;         // s
  double mass_scaling = 1;         // of the inertia
  double sample_interval = 1e-3;   // of the records, s
  bond_selection selection{};
  run_options numerics{};
};

inline void validate(const cohesive_parameters& p) {
  constexpr auto page = "docs/reference/scenes.md";
  expects(p.water_content > 0 && p.water_content < 1, "the water content w", p.water_content, "in (0, 1)", page);
  expects(p.confining_pressure >= 0 && std::isfinite(p.confining_pressure), "the confining pressure (Pa)",
          p.confining_pressure, "at least 0 and finite", page);
  expects_positive("the time step (s)", p.time_step, page);
  expects_steps("the duration of the relaxation (s)", p.relaxation, p.time_step, page);
  expects_positive("the unbalanced force at rest", p.unbalanced_force, page);
  expects_positive("the tolerance of the stress on the walls (Pa)", p.stress_tolerance, page);
  expects_positive("the mass scaling", p.mass_scaling, page);
  expects_positive("the sample interval (s)", p.sample_interval, page);
  validate(p.selection);
}

/// Relaxation for one composition: liquid comes into a compacted dry packing, the walls go to the confining pressure,
/// and the sample moves until it is at rest. Without confining pressure the walls back off until nothing presses on
/// them, and then stay: the sample is held by its bridges alone.
template <class Material, class Liquid>
class cohesive_sample {
 public:
  using system_type = system<Material, Liquid, box_walls, half_step_velocity_verlet>;

  cohesive_sample(const cohesive_parameters& p, const Material& grains, const smooth_contact& walls, const Liquid& l)
      : parameters_(checked(p)),
        system_(grains, l, loaded_box({{-1, -1, -1}, {1, 1, 1}}, p.confining_pressure, walls, p.mass_scaling),
                half_step_velocity_verlet{p.time_step}, p.numerics),
        now_(p.time_step, {{"relax", p.relaxation}}) {}

  /// Wets the grains of a packing, which start at rest. Errors: input_error for what is no packing, or a second one, and
  /// then nothing has changed; input_error where the scene breaks a limit.
  void start(const boxed_packing& packing) {
    validate(packing);
    const auto there = static_cast<double>(system_.particles().size());
    expects(there == 0, "the number of grains in the sample before a packing comes", there, "0",
            "docs/reference/scenes.md");
    add_at_rest(system_, packing.grains, parameters_.mass_scaling);
    enclose(system_.walls(), packing.room);
    load_box(system_.walls(), parameters_.confining_pressure, parameters_.mass_scaling);
    system_.start();
    const double density = system_.bridges().policies().substance().density;
    system_.distribute_liquid(parameters_.water_content * packing.solid_mass() / density, parameters_.selection);
    result_.packing_unbalanced_force = packing.unbalanced_force;
    result_.start = state();
    result_.reference = positions_by_id(system_.particles());
    result_.energy_at_start = observe::energies_of(system_);
  }

  /// From `start` or from where a checkpoint stopped. Errors: run_error.
  const cohesive_result& run(const monitor& watch) {
    if (look && now_.done() == 0) look(system_, result_);
    const double interval = std::min(parameters_.sample_interval, parameters_.relaxation);
    now_.run(
        system_, slice_of(interval, parameters_.time_step), watch, [&] { return record(); },
        [&](io::checkpoint_writer& out) { io::save(out, system_), save(out, result_); }, [&] { return at_rest(); });
    system_.run(1);  // a list made anew for a checkpoint has no forces, and who asks for the result wants them
    result_.end = state();
    return result_;
  }

  void resume(const io::checkpoint_reader& in) {
    const stages there = now_.read(in);
    auto result = result_;
    load(in, result);
    io::load(in, system_, io::winner::file_for_walls);
    now_ = there, result_ = std::move(result);
  }

  /// Called before the first step and after every record.
  std::function<void(const system_type&, const cohesive_result&)> look;

  const cohesive_result& result() const { return result_; }
  const system_type& sample() const { return system_; }

  /// By the last record.
  bool at_rest() const {
    if (result_.records.empty()) return false;
    const cohesive_record& last = result_.records.back();
    return last.unbalanced_force <= parameters_.unbalanced_force &&
           std::abs(last.wall_stress - parameters_.confining_pressure) <= parameters_.stress_tolerance;
  }

 private:
  std::string record() {
    load_box(system_.walls(), parameters_.confining_pressure, parameters_.mass_scaling);
    const auto z = observe::coordination_of(system_);
    const auto energy = observe::energies_of(system_);
    const box room = room_of(system_.walls());
    result_.records.push_back(
        {now_.time(),
         solid_volume(system_.particles()) / volume_of(room),
         z.contacts,
         z.bridges,
         observe::unbalanced_force_ratio(system_),
         mean_stress(system_.walls()),
         liquid_kept(system_),
         {energy.balance() - result_.energy_at_start.balance(), energy.turnover_since(result_.energy_at_start)}});
    if (look) look(system_, result_);
    const auto& last = result_.records.back();
    return std::to_string(last.bridges).substr(0, 5) + " bridges a grain, unbalanced force " +
           std::to_string(last.unbalanced_force).substr(0, 8);
  }

  cohesive_state state() const {
    const auto& g = system_.particles();
    const box room = room_of(system_.walls());
    const double diameter =
        2 * ::ranges::accumulate(g.template get<column::radius>(), 0.0) / static_cast<double>(g.size());
    const auto z = observe::coordination_of(system_);
    return {room,
            solid_volume(g) / volume_of(room),
            observe::solid_fraction_within(g, core_of(room, 2 * diameter)),
            z.contacts,
            z.bridges,
            z.open_bridges};
  }

  cohesive_parameters parameters_;
  system_type system_;
  stages now_;
  cohesive_result result_;
};

}  // namespace pendular::scene
