// SPDX-License-Identifier: BSD-3-Clause

// A run that cannot go on stops with a run_error that names grain, step and cause.
#include "../physics/scenes.hpp"

#include <string>

using namespace pendular;
using namespace scenes;

namespace {

constexpr double r = 0.5e-3, rho = 2600;

template <class Call>
std::string failure(const Call& call) {
  try {
    call();
  } catch (const run_error& error) {
    return error.what();
  }
  return "no run_error";
}

bool mentions(const std::string& text, std::initializer_list<std::string> parts) {
  UNSCOPED_INFO(text);
  for (const std::string& part : parts) {
    if (text.find(part) == std::string::npos) return false;
  }
  return true;
}

/// Laws of a user that break deep in a contact.
struct bursting_spring {
  double normal_stiffness;
  template <Scalar T>
  T repulsion(const approach<T>& a) const {
    const T overlap = pendular::max(T(-a.gap), T(0));
    return T(normal_stiffness) * overlap + pendular::sqrt(T(1e-7 - overlap)) * T(1e-30);
  }
  template <Scalar T>
  T stiffness(const approach<T>&) const {
    return T(normal_stiffness);
  }
};
struct bursting_friction {
  template <Scalar T>
  Vec3<T> traction(const slip<T>& s, const T& normal_force) const {
    const T broken = pendular::sqrt(T(1e-4 - normal_force)) * T(1e-30);
    return T(-broken) * s.velocity;
  }
};

template <class Material>
auto colliding(const Material& m, double speed, double k = 1e3) {
  pendular::system s{m, boundary::walls{}, velocity_verlet{1e-6}, run_options{.force = true}};
  static_cast<void>(k);
  s.add({{-10e-3, 0, 0}, r, rho});  // a bystander, so that the culprits are 1 and 2
  s.add({{0, 0, 0}, r, rho, {0.5 * speed, 0, 0}});
  s.add({{2 * r + 1e-6, 0, 0}, r, rho, {-0.5 * speed, 0, 0}});
  return s;
}

}  // namespace

TEST_CASE("an overlap beyond the limit names both grains, step, overlap and limit") {
  // 6 m/s on 1e3 N/m: overlap v sqrt(m_red / k) = 0.157 mm, past 0.05 mm after some 9 us.
  auto s = colliding(material{normal::linear{1e3}}, 6);
  const std::string said = failure([&] { s.run(1000); });
  CHECK(mentions(said, {"grain 1 at step " + std::to_string(s.step_count()), "grain 2", "overlaps", "limit of 0.1"}));
  CHECK(s.step_count() >= 8);
  CHECK(s.step_count() <= 12);
}

TEST_CASE("an overlap beyond the limit with a wall is found as well") {
  pendular::system s{material{normal::linear{1e3}}, floor_plane(), velocity_verlet{1e-6}, run_options{.force = true}};
  s.add({{-10e-3, 0, 10 * r}, r, rho});
  s.add({{0, 0, r + 1e-6}, r, rho, {0, 0, -6}});
  CHECK(mentions(failure([&] { s.run(40); }), {"grain 1 at step", "overlaps wall 0 by", "limit of 0.1"}));
}

TEST_CASE("an overlap of two grains is found also where a wall is in order") {
  pendular::system s{material{normal::linear{1e3}}, floor_plane(), velocity_verlet{1e-6}, run_options{.force = true}};
  s.add({{-10e-3, 0, r}, r, rho});
  s.add({{0, 0, 10 * r}, r, rho, {3, 0, 0}});
  s.add({{2 * r + 1e-6, 0, 10 * r}, r, rho, {-3, 0, 0}});
  CHECK(mentions(failure([&] { s.run(40); }), {"grain 1 at step", "overlaps grain 2"}));
}

TEST_CASE("an overlap of grains of different sizes is measured with the smaller one") {
  pendular::system s{material{normal::linear{1e3}}, boundary::walls{}, velocity_verlet{1e-6},
                     run_options{.force = true}};
  s.add({{0, 0, 0}, 4 * r, rho});
  s.add({{5 * r + 1e-6, 0, 0}, r, rho, {-6, 0, 0}});
  const std::string said = failure([&] { s.run(1000); });
  REQUIRE(mentions(said, {"grain 0 at step", "overlaps grain 1 by "}));
  const double overlap = std::stod(said.substr(said.find(" by ") + 4));
  CHECK((overlap >= 0.1 && overlap < 0.12));
}

TEST_CASE("a normal law that returns a value that is not finite stops the run and the grain is named") {
  auto s = colliding(material{bursting_spring{1e3}}, 0.1);
  const std::string said = failure([&] { s.run(1000); });
  CHECK(mentions(said, {"not finite", "from a contact law", "step " + std::to_string(s.step_count())}));
  CHECK(mentions(said, {"grain 1"}));
}

TEST_CASE("a friction law that returns a value that is not finite stops the run") {
  auto s = colliding(material{normal::linear{1e3}, bursting_friction{}}, 0.1);
  velocity(s, 1).y = 0.01;
  const std::string said = failure([&] { s.run(1000); });
  CHECK(mentions(said, {"not finite", "grain", "step"}));
}

TEST_CASE("a law that returns a value that is not finite at a wall stops the run") {
  pendular::system s{material{bursting_spring{1e3}}, floor_plane(), velocity_verlet{1e-6}, run_options{.force = true}};
  s.add({{0, 0, r + 1e-6}, r, rho, {0, 0, -0.1}});
  CHECK(mentions(failure([&] { s.run(1000); }), {"grain 0 at step", "and wall 0 at a gap of", "not finite"}));
}

TEST_CASE("trouble at the second of two walls names the second") {
  pendular::system s{material{normal::linear{1e3}},
                     boundary::walls{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}},
                                     boundary::wall{boundary::plane{{0, 0, 20 * r}, {0, 0, -1}}}},
                     velocity_verlet{1e-6}, run_options{.force = true}};
  s.add({{0, 0, 2 * r}, r, rho});
  s.add({{0, 0, 19 * r - 1e-6}, r, rho, {0, 0, 6}});
  CHECK(mentions(failure([&] { s.run(40); }), {"grain 1 at step", "overlaps wall 1 by"}));
}

TEST_CASE("a grain that no wall holds is lost with its name, step and place") {
  pendular::system s{material{normal::linear{1e3}}, boundary::walls{}, velocity_verlet{1e-4},
                     run_options{.force = true}};
  s.add({{0, 0, 0}, r, rho});
  s.add({{5e-3, 0, 0}, r, rho, {0, 100, 0}});
  const std::string said = failure([&] { s.run(100000); });
  CHECK(mentions(said, {"grain 1 at step " + std::to_string(s.step_count()), "lost at (0.005,", "no wall"}));
  CHECK(position(s, 1).y > 0.5);
}

TEST_CASE("coincident centres are reported and not divided by") {
  pendular::system s{material{normal::linear{1e3}}, boundary::walls{}, velocity_verlet{1e-6},
                     run_options{.force = true}};
  s.add({{1e-3, 0, 0}, r, rho});
  s.add({{1e-3, 0, 0}, r, rho});
  CHECK(mentions(failure([&] { s.start(); }), {"grain 0 at step 0", "overlaps grain 1", "limit"}));
}

TEST_CASE("a velocity that a user sets to NaN is found at the next step") {
  auto s = colliding(material{normal::linear{1e3}}, 0.01);
  s.run(5);
  velocity(s, 0).y = NAN;
  CHECK(mentions(failure([&] { s.run(5); }), {"grain 0 at step 6", "not finite"}));
}
