// SPDX-License-Identifier: BSD-3-Clause
// A checkpoint read into a program with other parameters: refused by name, or whoever wins is seen to win.
#include "../physics/scenes.hpp"

#include <pendular/boundary/servo_stress.hpp>
#include <pendular/io/checkpoint.hpp>
#include <pendular/io/system_state.hpp>
#include <pendular/liquid/source/evaporation.hpp>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

using namespace pendular;
using namespace scenes;

namespace {

struct choices {
  double time_step = 1e-6, stiffness = 1e3, tension = 0.07, lid_stress = 50, film_rate = 0;
};

auto scene(const choices& c = {}) {
  using boundary::plane;
  using boundary::wall;
  return pendular::system{
      material{normal::linear{c.stiffness}, damping::viscous{0.3}},
      liquid{fluid{c.tension, 0, 1000, 1e-3}, capillary::richefeu{}, rupture::lian{}, protocol::grain_films{},
             source::evaporation{c.film_rate, 0, 100000}},
      boundary::walls{wall{plane{{0, 0, 0}, {0, 0, 1}}},
                      wall{plane{{0, 0, 3e-3}, {0, 0, -1}}, boundary::servo_stress{c.lid_stress, 1e-6, 1e-5, 1e-3}}},
      half_step_velocity_verlet{c.time_step, {0, 0, -9.81}}};
}

/// Two wet grains on a floor, after 1 ms.
const std::filesystem::path& saved() {
  static const std::filesystem::path path = [] {
    const auto file = std::filesystem::temp_directory_path() / ("pendular_parameters_" + std::to_string(std::rand()));
    auto s = scene();
    for (int k = 0; k < 2; ++k) s.add({.position = {0, 0, 0.5e-3 + 0.9999e-3 * k}, .radius = 0.5e-3, .density = 2600});
    s.distribute_liquid(1e-12);
    s.run(1000);
    s.canonicalise();
    io::checkpoint_writer out(file);
    io::save(out, s);
    out.commit();
    return file;
  }();
  return path;
}

std::string refusal(const choices& c, io::winner wins = io::winner::nobody) {
  auto s = scene(c);
  try {
    io::load(io::checkpoint_reader(saved()), s, wins);
  } catch (const std::exception& e) {
    CHECK((s.particles().size() == 0 && s.step_count() == 0));  // as it was
    return e.what();
  }
  return "";
}
/// A law that knows one contact angle and cannot be given another, as one that was made from a table.
class made_for {
 public:
  explicit made_for(double angle) : angle_(angle) {}
  template <Scalar T>
  T attraction(const bridge<T>& b, const fluid& f) const {
    return T(f.surface_tension) * b.radius_i + T(0) * b.gap;
  }
  void expect_fluid(const fluid& f) const {
    expects(f.contact_angle == angle_, "the contact angle (rad)", f.contact_angle, "that of the law",
            "docs/reference/laws.md");
  }

 private:
  double angle_;
};

bool mentions(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("the same parameters are taken without a word") {
  auto s = scene();
  CHECK(io::load(io::checkpoint_reader(saved()), s).empty());
  CHECK(s.time() == within(1e-15, 1e-3));
  s.run(10);
}

TEST_CASE("a parameter that differs is refused by its name, with both values") {
  CHECK(mentions(refusal({.time_step = 5e-7}),
                 "half_step_velocity_verlet time_step is 1e-06 in the file and 5e-07 in the program"));
  CHECK(mentions(refusal({.stiffness = 900}),
                 "normal::linear normal_stiffness is 1000 in the file and 900 in the program"));
  CHECK(mentions(refusal({.tension = 0.03}), "fluid surface_tension is 0.07 in the file and 0.03 in the program"));
  CHECK(mentions(refusal({.lid_stress = 100}),
                 "wall 1: boundary::servo_stress stress is 50 in the file and 100 in the program"));
  CHECK(mentions(refusal({.film_rate = 1e-9}), "source::evaporation film_rate"));
  CHECK(mentions(refusal({.time_step = 5e-7, .tension = 0.03}), "; half_step"));
  CHECK(mentions(refusal({.tension = 0.03}), "docs/how-to/resume.md"));
}

TEST_CASE("the program may win: another step keeps the time, the lid has its stress, the bridge its tension") {
  const choices other{.time_step = 5e-7, .stiffness = 900, .tension = 0.03, .lid_stress = 100};
  auto s = scene(other);
  CHECK(io::load(io::checkpoint_reader(saved()), s, io::winner::program).size() == 4);
  CHECK(s.time() == within(1e-12, 1e-3));
  CHECK(boundary::get<1>(s.walls()).drive.stress == 100);
  CHECK(s.integrator().time_step == 5e-7);
  CHECK(s.bridges().policies().substance().surface_tension == 0.03);
  // Richefeu et al. 2007, Eq. 5 at contact: 2 pi gamma R
  CHECK(s.bridges().attraction(0, block(0.0))[0] == within(1e-12, 2 * pi * 0.03 * 0.5e-3));
  s.run(10);
  CHECK(s.time() == within(1e-12, 1e-3 + 5e-6));
}

TEST_CASE("the file may win, for everything or for the walls alone") {
  const choices other{.time_step = 5e-7, .stiffness = 900, .tension = 0.03, .lid_stress = 100};
  auto s = scene(other);
  CHECK(io::load(io::checkpoint_reader(saved()), s, io::winner::file).size() == 4);
  CHECK((s.integrator().time_step == 1e-6 && s.contact_material().normal().normal_stiffness == 1e3));
  CHECK(s.bridges().policies().substance().surface_tension == 0.07);
  CHECK(boundary::get<1>(s.walls()).drive.stress == 50);
  auto as_never_stopped = scene();
  io::load(io::checkpoint_reader(saved()), as_never_stopped);
  s.run(50);
  as_never_stopped.run(50);
  CHECK(position(s, 1) == position(as_never_stopped, 1));

  auto w = scene({.lid_stress = 100});
  CHECK(io::load(io::checkpoint_reader(saved()), w, io::winner::file_for_walls).size() == 1);
  CHECK(boundary::get<1>(w.walls()).drive.stress == 50);
  CHECK(mentions(refusal(other, io::winner::file_for_walls), "normal::linear normal_stiffness"));
}

TEST_CASE("a file that wins may not give a law another fluid than it was made for") {
  const auto wet = [](double angle) {
    return pendular::system{material{normal::linear{1e3}},
                            liquid{fluid{0.07, angle, 1000, 1e-3}, made_for{angle}, rupture::lian{}}, boundary::walls{},
                            velocity_verlet{1e-6}};
  };
  const auto file = std::filesystem::temp_directory_path() / ("pendular_fluid_" + std::to_string(std::rand()));
  auto s = wet(0.3);
  s.add({.position = {0, 0, 0}, .radius = 0.5e-3, .density = 2600});
  s.run(1);
  s.canonicalise();
  {
    io::checkpoint_writer out(file);
    io::save(out, s);
    out.commit();
  }
  auto same = wet(0.3), other = wet(0.0);
  CHECK_NOTHROW(io::load(io::checkpoint_reader(file), same, io::winner::file));
  CHECK_THROWS_AS(io::load(io::checkpoint_reader(file), other, io::winner::file), input_error);
  CHECK((other.particles().size() == 0 && other.bridges().policies().substance().contact_angle == 0));
  std::filesystem::remove(file);
}

TEST_CASE("parameters of one name are compared in their order, as those of two sinks of one type") {
  using list = std::vector<io::parameter>;
  const list file{{"pump share", 1}, {"other", 0}, {"pump share", 2}};
  CHECK(io::differences(file, file).empty());
  CHECK(io::differences(file, list{{"pump share", 2}, {"other", 0}, {"pump share", 1}}).size() == 2);
}

TEST_CASE("a scene that would break a limit is not resumed") {
  CHECK(mentions(refusal({.stiffness = 1e7}, io::winner::program), "the time step (s), against stiffness"));
  CHECK(mentions(refusal({.stiffness = 3}, io::winner::program), "must be at most"));
}

TEST_CASE("a checkpoint is not read into a scene that has grains") {
  auto s = scene();
  s.add({.position = {0, 0, 1e-3}, .radius = 0.5e-3, .density = 2600});
  CHECK_THROWS_AS(io::load(io::checkpoint_reader(saved()), s), input_error);
  CHECK(s.particles().size() == 1);
  std::filesystem::remove(saved());
}
