// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/io/checkpoint.hpp>
#include <pendular/observe/stress.hpp>
#include <pendular/scene/box_walls.hpp>
#include <pendular/scene/grading.hpp>
#include <pendular/scene/loose_lattice.hpp>
#include <pendular/scene/packed_grains.hpp>
#include <pendular/scene/sample.hpp>
#include <pendular/scene/stages.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace pendular::scene {

/// Diameters of the companion paper: equal numbers of three (Richefeu et al. 2006, section 2).
inline grading cohesive_grading() { return {{1.0e-3, 1.0 / 3}, {1.5e-3, 1.0 / 3}, {2.0e-3, 1.0 / 3}}; }

/// A dry sample between six smooth walls, compacted by an isotropic pressure without gravity. How Richefeu et al. 2006
/// (Eur. Phys. J. E 21, 359) prepared theirs is not printed: all of this is our choice.
struct box_packing_parameters {
  std::int64_t grains = 8000;
  grading sizes = cohesive_grading();
  double density = 2700;           // of the grains, kg/m3
  double pressure = 300;           // of the walls, Pa
  double agitation = 0.1;          // largest part of a grain's first velocity along an axis, m/s
  double compaction = 0.5;         // at most, s
  double unbalanced_force = 1e-3;  // mean over the mean contact force, at which the sample is at rest
  double stress_tolerance = 3;     // by which the stress on the walls at rest may differ from the pressure, Pa
  double time_step = 4e-6;         // s
  std::uint64_t seed = 1;
  run_options numerics{};
};

inline void validate(const box_packing_parameters& p) {
  constexpr auto page = "docs/reference/scenes.md";
  expects_countable(p.grains);
  validate(p.sizes);
  expects_positive("the density of the grains (kg/m3)", p.density, page);
  expects_positive("the pressure of the walls (Pa)", p.pressure, page);
  expects(p.agitation >= 0 && std::isfinite(p.agitation), "the agitation of the grains (m/s)", p.agitation,
          "at least 0 and finite", page);
  expects_positive("the time step (s)", p.time_step, page);
  expects_steps("the duration of the compaction (s)", p.compaction, p.time_step, page);
  expects_positive("the unbalanced force at rest", p.unbalanced_force, page);
  expects_positive("the tolerance of the stress on the walls (Pa)", p.stress_tolerance, page);
}

/// Grains between six walls, in the order of their ids.
struct boxed_packing {
  std::vector<grain> grains;
  box room{};
  double stress = 0;            // mean on the walls, Pa
  double unbalanced_force = 0;  // mean over the mean contact force

  /// m3
  double solid_volume() const {
    return sum_of_volumes([](const grain&) { return 1.0; });
  }
  /// kg
  double solid_mass() const {
    return sum_of_volumes([](const grain& g) { return g.density; });
  }
  double solid_fraction() const { return solid_volume() / volume_of(room); }

 private:
  template <class Weight>
  double sum_of_volumes(const Weight& weight) const {
    double sum = 0;
    for (const grain& g : grains) sum += weight(g) * g.radius * g.radius * g.radius;
    return 4.0 / 3.0 * std::numbers::pi * sum;
  }
};

/// Errors: input_error for a packing without grains, with a number that is not finite or a room turned inside out.
inline void validate(const boxed_packing& p) {
  constexpr auto page = "docs/reference/scenes.md";
  expects(!p.grains.empty(), "the number of grains in the packing", 0, "at least 1", page);
  const vector size = size_of(p.room);
  for (const double edge : {size.x, size.y, size.z}) expects_positive("an edge of the packing's room (m)", edge, page);
  expects(std::isfinite(p.stress), "the stress on the packing's walls (Pa)", p.stress, "finite", page);
  expects(p.unbalanced_force >= 0, "the unbalanced force in the packing", p.unbalanced_force, "at least 0", page);
  for (const grain& g : p.grains) {
    expects_solid(g, std::min({size.x, size.y, size.z}));
    for (const auto axis : {&vector::x, &vector::y, &vector::z}) {
      const double x = g.position.*axis;
      expects(x >= p.room.lower.*axis && x <= p.room.upper.*axis, "a coordinate of a grain in the packing (m)", x,
              "within the packing's room", page);
    }
  }
}

inline void write(const boxed_packing& p, const std::filesystem::path& file) {
  std::vector<double> numbers{p.stress, p.unbalanced_force};
  for (const vector& v : {p.room.lower, p.room.upper}) numbers.insert(numbers.end(), {v.x, v.y, v.z});
  append(numbers, p.grains);
  io::checkpoint_writer out(file);
  out.put("boxed_packing.numbers", numbers);
  out.commit();
}

/// Errors: std::runtime_error if the file holds no packing in a box, input_error for one of another number of grains or
/// of another mean diameter than `wanted`.
inline boxed_packing load_boxed_packing(const io::checkpoint_reader& in, const box_packing_parameters& wanted) {
  constexpr auto page = "docs/reference/scenes.md";
  const auto n = packing_numbers(in, "boxed_packing.numbers", 8);
  boxed_packing p{grains_of(n, 8), {{n[2], n[3], n[4]}, {n[5], n[6], n[7]}}, n[0], n[1]};
  validate(p);
  const auto count = static_cast<double>(p.grains.size());
  expects(count == static_cast<double>(wanted.grains), "the number of grains in the packing", count,
          std::to_string(wanted.grains), page);
  double sum = 0;
  for (const grain& g : p.grains) sum += 2 * g.radius;
  const double mean = mean_diameter(wanted.sizes);
  expects(std::abs(sum / count - mean) <= 0.02 * mean, "the mean diameter in the packing (mm)", 1e3 * sum / count,
          std::to_string(1e3 * mean), page);
  return p;
}

/// Compacts a loose lattice of grains of any dry material; friction makes the sample looser.
template <class Material>
class box_packing {
 public:
  using system_type = system<Material, dry, box_walls, half_step_velocity_verlet>;

  box_packing(const box_packing_parameters& p, const Material& grains, const smooth_contact& walls)
      : parameters_(checked(p)),
        start_(loose_lattice(diameters(p.sizes, p.grains, p.seed), p.density, p.agitation, p.seed)),
        system_(grains, loaded_box(start_.room, p.pressure, walls), half_step_velocity_verlet{p.time_step}, p.numerics),
        now_(p.time_step, {{"compact", p.compaction}}) {}

  /// From the start, or from where a checkpoint stopped, until the sample is at rest under the pressure or the time is
  /// over. Errors: input_error, run_error.
  boxed_packing run(const monitor& watch) {
    if (system_.particles().size() == 0) {
      for (const grain& g : start_.grains) system_.add(g);
    }
    now_.run(
        system_, slice, watch, [&] { return follow(); }, [&](io::checkpoint_writer& out) { put(out); },
        [&] { return at_rest(); });
    return packed();
  }

  /// Errors: input_error for a checkpoint of another number of grains.
  void resume(const io::checkpoint_reader& in) {
    const auto count = in.get<std::int64_t>("scene.grains");
    expects(count == parameters_.grains, "the number of grains in the checkpoint", static_cast<double>(count),
            std::to_string(parameters_.grains), "docs/reference/scenes.md");
    const stages there = now_.read(in);
    const auto state = in.get<std::vector<double>>("scene.rest", 2);
    for (const double x : state) in.require(!std::isnan(x), "scene.rest", x, "a number");
    io::load(in, system_, io::winner::file_for_walls);
    now_ = there, stress_ = state[0], unbalanced_force_ = state[1];
  }

  const system_type& sample() const { return system_; }

 private:
  static constexpr std::int64_t slice = 100;  // steps, in which a box of 8000 grains shrinks by 0.3 % at most

  /// Kept, and not computed anew where a run goes on: a checkpoint has no forces of pairs.
  bool at_rest() const {
    return unbalanced_force_ <= parameters_.unbalanced_force &&
           std::abs(stress_ - parameters_.pressure) <= parameters_.stress_tolerance;
  }

  std::string follow() {
    load_box(system_.walls(), parameters_.pressure);
    stress_ = mean_stress(system_.walls());
    unbalanced_force_ = observe::unbalanced_force_ratio(system_);
    const double fraction = solid_volume(system_.particles()) / volume_of(room_of(system_.walls()));
    return "solid fraction " + std::to_string(fraction).substr(0, 6) + ", walls at " +
           std::to_string(std::lround(stress_)) + " Pa";
  }

  boxed_packing packed() const {
    return {grains_by_id(system_.particles()), room_of(system_.walls()), stress_, unbalanced_force_};
  }

  void put(io::checkpoint_writer& out) const {
    out.put("scene.grains", parameters_.grains);
    out.put("scene.rest", std::vector<double>{stress_, unbalanced_force_});
    io::save(out, system_);
  }

  box_packing_parameters parameters_;
  lattice start_;
  system_type system_;
  stages now_;
  double stress_ = 0, unbalanced_force_ = std::numeric_limits<double>::infinity();
};

}  // namespace pendular::scene
