// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/cylinder.hpp>
#include <pendular/boundary/servo_stress.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/scene/grading.hpp>
#include <pendular/scene/lid.hpp>
#include <pendular/scene/packed_grains.hpp>
#include <pendular/scene/placement.hpp>
#include <pendular/scene/sample.hpp>
#include <pendular/scene/stages.hpp>
#include <pendular/system.hpp>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace pendular::scene {

/// A cylindrical sample as Richefeu et al. 2007, section 4.2.1, prepare it; what the paper leaves out is from
/// Richefeu et al. 2006 or our choice (docs/reference/scenes.md).
struct packing_parameters {
  std::int64_t grains = 8000;
  double cylinder_radius = 12.5e-3;  // m
  grading sizes = compression_grading();
  double density = 2700;    // of the grains, kg/m3
  double gravity = 9.81;    // m/s2
  double lid_stress = 300;  // that seals the sample, Pa
  double deposition = 0.2;  // s
  double sealing = 0.2;     // s; 0: no lid
  double time_step = 4e-6;  // s
  std::uint64_t seed = 1;
  run_options numerics{};

  double area() const { return std::numbers::pi * cylinder_radius * cylinder_radius; }
};

inline void validate(const packing_parameters& p) {
  constexpr auto page = "docs/reference/scenes.md";
  expects_countable(p.grains);
  validate(p.sizes);
  expects_positive("the radius of the cylinder (m)", p.cylinder_radius, page);
  expects_positive("the density of the grains (kg/m3)", p.density, page);
  expects_positive("the gravity (m/s2)", p.gravity, page);
  expects_positive("the stress of the lid (Pa)", p.lid_stress, page);
  expects_positive("the duration of the deposition (s)", p.deposition, page);
  expects(p.sealing >= 0 && std::isfinite(p.sealing), "the duration of the sealing (s)", p.sealing,
          "at least 0 and finite", page);
  expects_positive("the time step (s)", p.time_step, page);
}

/// Grains at rest between floor, cylinder and lid, in the order of their ids.
struct sealed_packing {
  std::vector<grain> grains;
  double height = 0;  // of the lid, or of the highest grain where there is none, m
  double solid_fraction = 0;
  double solid_mass = 0;       // kg
  double cylinder_radius = 0;  // m
};

/// Errors: input_error for a packing without grains, with a number that is none, a grain outside of cylinder and height,
/// or a mass or a solid fraction that is not that of the grains.
inline void validate(const sealed_packing& p) {
  constexpr auto page = "docs/reference/scenes.md";
  expects(!p.grains.empty(), "the number of grains in the packing", 0, "at least 1", page);
  expects_positive("the height of the packing (m)", p.height, page);
  expects_positive("the radius of the packing's cylinder (m)", p.cylinder_radius, page);
  double volume = 0, mass = 0;
  for (const grain& g : p.grains) {
    expects_solid(g, p.cylinder_radius);
    const vector x = g.position;
    expects(std::hypot(x.x, x.y) <= p.cylinder_radius, "the distance of a grain in the packing from the axis (m)",
            std::hypot(x.x, x.y), "at most the radius of the cylinder", page);
    expects(x.z >= 0 && x.z <= p.height, "the height of a grain in the packing (m)", x.z, "between floor and lid",
            page);
    volume += volume_of(g), mass += volume_of(g) * g.density;
  }
  const double fraction = volume / (std::numbers::pi * p.cylinder_radius * p.cylinder_radius * p.height);
  constexpr double rounding = 1e-9;
  expects(std::abs(p.solid_mass - mass) <= rounding * mass && std::isfinite(mass), "the solid mass of the packing (kg)",
          p.solid_mass, "that of its grains", page);
  expects(std::abs(p.solid_fraction - fraction) <= rounding * fraction, "the solid fraction of the packing",
          p.solid_fraction, "that of its grains", page);
}

inline void save(io::checkpoint_writer& out, const sealed_packing& p) {
  std::vector<double> numbers{p.height, p.solid_fraction, p.solid_mass, p.cylinder_radius};
  append(numbers, p.grains);
  out.put("packing.numbers", numbers);
}

inline void write(const sealed_packing& p, const std::filesystem::path& file) {
  io::checkpoint_writer out(file);
  save(out, p);
  out.commit();
}

/// Errors: std::runtime_error if the file holds no packing, input_error if it is none.
inline sealed_packing load_packing(const io::checkpoint_reader& in) {
  const auto numbers = packing_numbers(in, "packing.numbers", 4);
  sealed_packing p{grains_of(numbers, 4), numbers[0], numbers[1], numbers[2], numbers[3]};
  validate(p);
  return p;
}

/// The same of a packing that must have the grains and the cylinder of the parameters. Errors: input_error too.
inline sealed_packing load_packing(const io::checkpoint_reader& in, const packing_parameters& wanted) {
  constexpr auto page = "docs/reference/scenes.md";
  sealed_packing p = load_packing(in);
  const auto count = static_cast<double>(p.grains.size());
  const auto expect = [&](const char* what, double value, double bound, double tolerance) {
    expects(std::abs(value - bound) <= tolerance * bound, what, value, std::to_string(bound), page);
  };
  expect("the number of grains in the packing", count, static_cast<double>(wanted.grains), 0);
  expect("the radius of the packing's cylinder (mm)", 1e3 * p.cylinder_radius, 1e3 * wanted.cylinder_radius, 1e-9);
  double sum = 0;
  for (const grain& g : p.grains) sum += 2 * g.radius;
  expect("the mean diameter in the packing (mm)", 1e3 * sum / count, 1e3 * mean_diameter(wanted.sizes), 0.02);
  return p;
}

/// Deposits grains under gravity in a cylinder and seals them by a loaded lid. All walls are without friction; the
/// grains' own material may have some, which makes the sample looser.
template <class Material>
class packing {
 public:
  using smooth = material<normal::linear, damping::viscous>;
  using walls_type = boundary::walls<boundary::wall<boundary::plane, boundary::fixed, smooth>,
                                     boundary::wall<boundary::cylinder, boundary::fixed, smooth>,
                                     boundary::wall<boundary::plane, boundary::servo_stress, smooth>>;
  using system_type = system<Material, dry, walls_type, half_step_velocity_verlet>;

  packing(const packing_parameters& p, const Material& grains, const smooth& walls)
      : parameters_(checked(p)), system_(grains, enclosure(p, walls), integrator(p), p.numerics),
        now_(p.time_step, {{"deposit", p.deposition}, {"seal", p.sealing}}) {}

  /// From the start, or from where a checkpoint stopped. Errors: input_error, run_error.
  sealed_packing run(const monitor& watch) {
    if (system_.particles().size() == 0) fill();
    const auto put = [&](io::checkpoint_writer& out) { io::save(out, system_); };
    if (now_.at("deposit")) {
      now_.run(
          system_, slice, watch, [&] { return "height " + millimetres(top()); }, put);
      if (steps_in(parameters_.sealing, parameters_.time_step) == 0) return sealed(top());
      put_lid_on();
    }
    now_.run(
        system_, slice, watch, [&] { return "height " + millimetres(lid().shape.point.z); }, put);
    return sealed(lid().shape.point.z);
  }

  /// Errors: std::runtime_error for a checkpoint of another scene.
  void resume(const io::checkpoint_reader& in) {
    const stages there = now_.read(in);
    io::load(in, system_, io::winner::file_for_walls);
    now_ = there;
  }

 private:
  static constexpr double out_of_the_way = 10;  // height of a lid that is not used, m
  static constexpr std::int64_t slice = 200;    // steps

  static half_step_velocity_verlet integrator(const packing_parameters& p) { return {p.time_step, {0, 0, -p.gravity}}; }
  static walls_type enclosure(const packing_parameters& p, const smooth& m) {
    using boundary::wall, boundary::plane, boundary::cylinder, boundary::fixed;
    return walls_type{wall(plane{{0, 0, 0}, {0, 0, 1}}, fixed{}, m),
                      wall(cylinder{{0, 0, 0}, {0, 0, 1}, p.cylinder_radius}, fixed{}, m),
                      wall(plane{{0, 0, out_of_the_way}, {0, 0, -1}}, loading_lid(0, p.area()), m)};
  }

  void fill() {
    const auto sizes = diameters(parameters_.sizes, parameters_.grains, parameters_.seed);
    constexpr double fall_speed = 0.1;  // m/s
    for (const grain& g :
         loose_column(sizes, parameters_.density, parameters_.cylinder_radius, fall_speed, parameters_.seed)) {
      system_.add(g);
    }
  }

  void put_lid_on() {
    lid().shape.point.z = top();
    lid().drive.stress = parameters_.lid_stress;
    system_.canonicalise();
    system_.expect_limits();
    now_.next();
  }

  sealed_packing sealed(double height) const {
    const auto& g = system_.particles();
    sealed_packing p{grains_by_id(g), height, 0, 0, parameters_.cylinder_radius};
    for (const std::size_t row : g.rows_by_id()) p.solid_mass += 1 / g.template get<column::inverse_mass>()[row];
    p.solid_fraction = solid_volume(g) / (parameters_.area() * height);
    return p;
  }

  auto& lid() { return boundary::get<2>(system_.walls()); }
  double top() const { return tops(system_.particles()).front(); }

  packing_parameters parameters_;
  system_type system_;
  stages now_;
};

}  // namespace pendular::scene
