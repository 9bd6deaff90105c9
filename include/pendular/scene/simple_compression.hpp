// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/cylinder.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/observe/coordination.hpp>
#include <pendular/observe/energy.hpp>
#include <pendular/observe/stress.hpp>
#include <pendular/scene/grading.hpp>
#include <pendular/scene/placement.hpp>
#include <pendular/scene/sample.hpp>
#include <pendular/scene/stages.hpp>
#include <pendular/system.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace pendular::scene {

/// Simple compression of a wet cylindrical sample (Richefeu et al. 2007, section 4): what the paper states, and what it
/// leaves out from Richefeu et al. 2006 or our choice (docs/reference/scenes.md).
struct compression_parameters {
  std::int64_t grains = 8000;
  double cylinder_radius = 12.5e-3;  // m
  grading sizes = compression_grading();
  double density = 2700;             // of the grains, kg/m3
  double gravity = 9.81;             // m/s2
  double normal_stiffness = 1e3;     // k_n while preparing, N/m
  double damping_rate = 0.8;         // alpha_n while preparing
  double lid_stress = 300;           // that seals the sample, Pa
  double deposition = 0.2;           // s
  double sealing = 0.2;              // s
  double relaxation = 0.1;           // without the cylinder, s
  double water_content = 0.02;       // w, mass of liquid over mass of grains
  double lid_speed = 1e-3;           // m/s
  double duration = 2;               // of the compression, s
  double time_step = 5e-6;           // s
  double mass_scaling = 1;           // of the inertia after the preparation; weights stay
  double sample_interval = 1e-3;     // of the stress-strain curve, s
  bond_selection selection;
  std::uint64_t seed = 1;
  bool force = false;                // run even if the scene breaks a limit
};

/// A line of the stress-strain curve.
struct compression_record {
  double time;               // since the lid started, s
  double shortening;         // of the sample, m
  double stress;             // axial, Pa
  double contacts;           // mean touching neighbours of a grain
  double bridges;            // mean liquid bridges of a grain
  double liquid;             // total over what was introduced
  double balance;            // energy balance, J
};

struct compression_result {
  double sealed_height = 0;      // m
  double solid_fraction = 0;
  double initial_bridges = 0;    // mean per grain, as distributed
  double relaxed_bridges = 0;    // mean per grain, when the lid starts
  double surface_settlement = 0; // in the relaxation, m
  double centre_settlement = 0;  // of the centre of mass in the relaxation, m
  double unbalanced_force = 0;   // after the relaxation, over the mean contact force
  double start_height = 0;       // of the lid when it starts, m
  std::vector<vector> reference; // positions by id when the lid starts, m
  std::vector<compression_record> records;
  observe::energies energy_at_start;
};

/// The whole test for one composition. Stages: deposit and seal without friction, then wet, relax, compress.
template <class Material, class Liquid>
class simple_compression {
 public:
  using preparation_material = material<normal::linear, damping::viscous>;
  using preparation_walls =
      boundary::walls<boundary::wall<boundary::plane>, boundary::wall<boundary::cylinder>,
                      boundary::wall<boundary::plane, boundary::servo_stress>>;
  using preparation_system = system<preparation_material, dry, preparation_walls, half_step_velocity_verlet>;
  using test_walls =
      boundary::walls<boundary::wall<boundary::plane>, boundary::wall<boundary::plane, boundary::constant_velocity>>;
  using test_system = system<Material, Liquid, test_walls, half_step_velocity_verlet>;

  simple_compression(const compression_parameters& p, const Material& m, const Liquid& l)
      : parameters_(p), material_(m), liquid_(l) {
    validate();
  }

  /// From the first stage or from where a checkpoint stopped. Errors: input_error, run_error.
  const compression_result& run(const monitor& watch) {
    if (stage_ <= stage::seal) prepare(watch);
    if (stage_ <= stage::relax) relax(watch);
    compress(watch);
    return result_;
  }

  /// Goes on from a checkpoint written by a scene of the same composition and parameters.
  void resume(const io::checkpoint_reader& in) {
    stage_ = static_cast<stage>(in.get<std::int64_t>("scene.stage"));
    done_ = in.get<std::int64_t>("scene.done");
    load_result(in);
    if (stage_ <= stage::seal) {
      preparation_.emplace(new_preparation());
      io::load(in, *preparation_);
    } else {
      test_.emplace(new_test());
      io::load(in, *test_);
    }
  }

  const compression_parameters& parameters() const { return parameters_; }
  const compression_result& result() const { return result_; }
  const test_system& sample() const { return *test_; }
  double area() const { return std::numbers::pi * parameters_.cylinder_radius * parameters_.cylinder_radius; }

  /// Called after every slice of the relaxation and the compression.
  std::function<void(const test_system&, const compression_result&)> look;

 private:
  enum class stage { deposit, seal, relax, compress };
  static constexpr double out_of_the_way = 10;  // height of a lid that is not used, m

  void validate() const {
    constexpr auto page = "docs/reference/scenes.md";
    const auto positive = [&](const char* what, double value) {
      expects(value > 0 && std::isfinite(value), what, value, "positive and finite", page);
    };
    expects(parameters_.grains > 0, "the number of grains", static_cast<double>(parameters_.grains), "at least 1", page);
    positive("the radius of the cylinder (m)", parameters_.cylinder_radius);
    positive("the density of the grains (kg/m3)", parameters_.density);
    positive("the time step (s)", parameters_.time_step);
    positive("the mass scaling", parameters_.mass_scaling);
    positive("the lid stress (Pa)", parameters_.lid_stress);
    positive("the sample interval (s)", parameters_.sample_interval);
    positive("the duration of the compression (s)", parameters_.duration);
    expects(parameters_.lid_speed >= 0 && std::isfinite(parameters_.lid_speed), "the speed of the lid (m/s)",
            parameters_.lid_speed, "at least 0 and finite", page);
    expects(parameters_.water_content >= 0 && parameters_.water_content < 1, "the water content w",
            parameters_.water_content, "in [0, 1)", page);
  }

  std::int64_t steps(double duration) const { return std::llround(duration / parameters_.time_step); }
  std::int64_t slice() const { return std::max<std::int64_t>(1, steps(parameters_.sample_interval)); }

  preparation_system new_preparation() const {
    const preparation_material m{normal::linear{parameters_.normal_stiffness}, damping::viscous{parameters_.damping_rate}};
    const double lid_mass = 2 * area(), lid_damping = 2000 * area();  // light, and close to critical on the sample
    const preparation_walls w{
        boundary::wall<boundary::plane>{{{0, 0, 0}, {0, 0, 1}}},
        boundary::wall<boundary::cylinder>{{{0, 0, 0}, {0, 0, 1}, parameters_.cylinder_radius}},
        boundary::wall<boundary::plane, boundary::servo_stress>{{{0, 0, out_of_the_way}, {0, 0, -1}},
                                                                {0, area(), lid_mass, lid_damping}}};
    return {m, w, half_step_velocity_verlet{parameters_.time_step, {0, 0, -parameters_.gravity}},
            run_options{.force = parameters_.force}};
  }

  test_system new_test() const {
    const test_walls w{boundary::wall<boundary::plane>{{{0, 0, 0}, {0, 0, 1}}},
                       boundary::wall<boundary::plane, boundary::constant_velocity>{
                           {{0, 0, out_of_the_way}, {0, 0, -1}}, {{0, 0, 0}}}};
    return {material_, liquid_, w,
            half_step_velocity_verlet{parameters_.time_step, {0, 0, -parameters_.gravity / parameters_.mass_scaling}},
            run_options{.force = parameters_.force}};
  }

  void prepare(const monitor& watch) {
    if (!preparation_) {
      preparation_.emplace(new_preparation());
      const auto sizes = diameters(parameters_.sizes, parameters_.grains, parameters_.seed);
      constexpr double fall_speed = 0.1;  // m/s
      for (const grain& g :
           loose_column(sizes, parameters_.density, parameters_.cylinder_radius, fall_speed, parameters_.seed)) {
        preparation_->add(g);
      }
    }
    auto& lid = boundary::get<2>(preparation_->walls());
    const auto height = [&] { return tops(preparation_->particles()).front(); };
    if (stage_ == stage::deposit) {
      run_stage(*preparation_, "deposit", done_, steps(parameters_.deposition), slice(), watch,
                [&] { return "height " + millimetres(height()); }, [&] { save(watch, *preparation_); });
      lid.shape.point.z = height();
      lid.drive.stress = parameters_.lid_stress;
      preparation_->canonicalise();
      enter(stage::seal);
    }
    run_stage(*preparation_, "seal", done_, steps(parameters_.sealing), slice(), watch,
              [&] { return "height " + millimetres(lid.shape.point.z); }, [&] { save(watch, *preparation_); });
    result_.sealed_height = lid.shape.point.z;
    result_.solid_fraction = solid_volume(preparation_->particles()) / (area() * result_.sealed_height);
  }

  /// The sealed grains get friction and liquid and lose the cylinder.
  void wet() {
    test_.emplace(new_test());
    const auto& g = preparation_->particles();
    double mass = 0;
    for (const std::size_t row : g.rows_by_id()) {
      grain next = g[row];
      mass += 1 / g.template get<column::inverse_mass>()[row];
      next.density *= parameters_.mass_scaling;
      next.velocity = {0, 0, 0};
      test_->add(next);
    }
    preparation_.reset();
    if constexpr (test_system::wet) {
      const double volume = parameters_.water_content * mass / liquid_.substance().density;
      test_->distribute_liquid(volume, parameters_.selection);
    }
    test_->start();
    result_.initial_bridges = observe::coordination_of(*test_).bridges;
    surface_before_ = surface_height(test_->particles());
    centre_before_ = mass_centre_height(test_->particles());
  }

  void relax(const monitor& watch) {
    if (stage_ != stage::relax) {
      wet();
      enter(stage::relax);
    }
    run_stage(*test_, "relax", done_, steps(parameters_.relaxation), slice(), watch, [&] {
      if (look) look(*test_, result_);
      return "height " + millimetres(surface_height(test_->particles()));
    }, [&] { save(watch, *test_); });
    result_.surface_settlement = surface_before_ - surface_height(test_->particles());
    result_.centre_settlement = centre_before_ - mass_centre_height(test_->particles());
    result_.relaxed_bridges = observe::coordination_of(*test_).bridges;
    result_.unbalanced_force = observe::unbalanced_force_ratio(*test_);
    start_lid();
    enter(stage::compress);
  }

  void start_lid() {
    auto& lid = boundary::get<1>(test_->walls());
    result_.start_height = tops(test_->particles()).front();
    lid.shape.point.z = result_.start_height;
    lid.drive.velocity = {0, 0, -parameters_.lid_speed};
    result_.reference = positions_by_id(test_->particles());
    result_.energy_at_start = observe::energies_of(*test_);  // before the new list, which has no gaps yet
    test_->canonicalise();
  }

  void compress(const monitor& watch) {
    run_stage(*test_, "compress", done_, steps(parameters_.duration), slice(), watch, [&] {
      record();
      if (look) look(*test_, result_);
      const auto& last = result_.records.back();
      return "stress " + std::to_string(std::lround(last.stress)) + " Pa at " + millimetres(last.shortening);
    }, [&] { save(watch, *test_); });
  }

  void record() {
    const auto& lid = boundary::get<1>(test_->walls());
    const auto z = observe::coordination_of(*test_);
    compression_record r{static_cast<double>(done_) * parameters_.time_step, result_.start_height - lid.shape.point.z,
                         lid.force.z / area(), z.contacts, z.bridges, 1, observe::energies_of(*test_).balance()};
    if constexpr (test_system::wet) {
      const auto& book = test_->bridges().book();
      if (book.introduced() > 0) r.liquid = book.total() / book.introduced();
    }
    result_.records.push_back(r);
  }

  void enter(stage next) {
    stage_ = next;
    done_ = 0;
  }

  static std::string millimetres(double length) {
    return std::to_string(length * 1e3).substr(0, 6) + " mm";
  }

  template <class System>
  void save(const monitor& watch, const System& s) const {
    io::checkpoint_writer out(watch.checkpoint);
    out.put("scene.stage", static_cast<std::int64_t>(stage_));
    out.put("scene.done", done_);
    save_result(out);
    io::save(out, s);
    out.commit();
  }

  /// Everything in the result that is a number, in one fixed order.
  template <class Result, class Visit>
  static void for_each_number(Result& r, const Visit& visit) {
    for (auto* v : {&r.sealed_height, &r.solid_fraction, &r.initial_bridges, &r.relaxed_bridges, &r.surface_settlement,
                    &r.centre_settlement, &r.unbalanced_force, &r.start_height}) {
      visit(*v);
    }
    auto& e = r.energy_at_start;
    for (auto* v : {&e.kinetic, &e.gravity, &e.elastic, &e.friction_springs, &e.capillary, &e.damping, &e.friction,
                    &e.liquid, &e.walls}) {
      visit(*v);
    }
    for (auto& p : r.reference) for_each_scalar<double>(p, visit);
    for (auto& line : r.records) for_each_scalar<double>(line, visit);
  }

  void save_result(io::checkpoint_writer& out) const {
    std::vector<double> numbers{surface_before_, centre_before_};
    for_each_number(result_, [&](const double& v) { numbers.push_back(v); });
    out.put("scene.references", static_cast<std::uint64_t>(result_.reference.size()));
    out.put("scene.records", static_cast<std::uint64_t>(result_.records.size()));
    out.put("scene.numbers", numbers);
  }

  void load_result(const io::checkpoint_reader& in) {
    const auto numbers = in.get<std::vector<double>>("scene.numbers");
    result_.reference.resize(in.get<std::uint64_t>("scene.references"));
    result_.records.resize(in.get<std::uint64_t>("scene.records"));
    std::size_t k = 2;
    surface_before_ = numbers.at(0);
    centre_before_ = numbers.at(1);
    for_each_number(result_, [&](double& v) { v = numbers.at(k++); });
  }

  compression_parameters parameters_;
  Material material_;
  Liquid liquid_;
  stage stage_ = stage::deposit;
  std::int64_t done_ = 0;
  double surface_before_ = 0, centre_before_ = 0;
  compression_result result_;
  std::optional<preparation_system> preparation_;
  std::optional<test_system> test_;
};

}  // namespace pendular::scene
