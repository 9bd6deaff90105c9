// SPDX-License-Identifier: BSD-3-Clause

// A scene beyond a limit is refused with value and bound, each limit in its turn; run_options::force overrides.
#include "../physics/scenes.hpp"

#include <pendular/boundary/servo_stress.hpp>

#include <functional>
#include <string>

using namespace pendular;
using namespace scenes;

namespace {

constexpr double r = 0.5e-3, rho = 2600;
const double mass = sphere_mass(r, rho);

template <class Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const input_error& error) {
    return error.what();
  }
  return "accepted";
}

bool mentions(const std::string& text, std::initializer_list<std::string> parts) {
  UNSCOPED_INFO(text);
  for (const std::string& part : parts) {
    if (text.find(part) == std::string::npos) return false;
  }
  return true;
}

/// A user's dashpot without regard to mass or stiffness.
struct plain_dashpot {
  double coefficient;  // N s/m
  template <Scalar T>
  T resistance(const approach<T>& a, const T&) const {
    return T(coefficient) * a.closing_speed * unit_step(T(-a.gap));
  }
};

/// A row of five touching grains.
template <class Material, class Integration>
void try_row(const Material& m, const Integration& i, bool force = false, double gap = -1e-9) {
  pendular::system s{m, boundary::walls{}, i, run_options{.force = force}};
  for (int k = 0; k < 5; ++k) s.add({{k * (2 * r + gap), 0, 0}, r, rho});
  s.start();
}

template <class Integration>
void try_wet_pair(double k_n, double volume, const Integration& i, bool force = false) {
  pendular::system s{material{normal::linear{k_n}}, liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}},
                     boundary::walls{}, i, run_options{.force = force}};
  s.add({{0, 0, 0}, r, rho});
  s.add({{2 * r, 0, 0}, r, rho});
  s.start();
  s.distribute_liquid(volume);
}

}  // namespace

TEST_CASE("a time step too long for the contact stiffness is refused") {
  // An inner grain of the row has two contacts: the bound is 2 / omega, omega^2 = 2 * 2 k / m; two of them swing
  // against each other with at most that frequency.
  const double bound = 2 / std::sqrt(4 * 1e3 / mass);
  const material m{normal::linear{1e3}};
  CHECK_NOTHROW(try_row(m, velocity_verlet{0.99 * bound}));
  const std::string said = refusal([&] { try_row(m, velocity_verlet{1.01 * bound}); });
  CHECK(mentions(said, {"time step", "stiffness", pendular::detail::number(1.01 * bound),
                        pendular::detail::number(bound), "grain"}));
  CHECK_NOTHROW(try_row(m, velocity_verlet{1.01 * bound}, true));
}

TEST_CASE("the bound on the time step is not below the true one by more than its safety and never above") {
  // The row at 0.99 of its bound stays bounded, the pair at 1.01 of its true limit 2 sqrt(m_red / k) explodes.
  pendular::system row{material{normal::linear{1e3}}, boundary::walls{},
                       velocity_verlet{0.99 * 2 / std::sqrt(4 * 1e3 / mass)}};
  for (int k = 0; k < 5; ++k) row.add({{k * (2 * r - 1e-6), 0, 0}, r, rho});
  for (int n = 0; n < 20000; ++n) row.run(1);
  CHECK(kinetic_energy(row) < 4 * 0.5 * 1e3 * 1e-12 * 1.5);
}

TEST_CASE("a time step too long for a strong dashpot is refused") {
  // alpha = 0.99 on a pair: rate c/m_red = 2 * 0.99 omega.
  const double omega = std::sqrt(1e3 / (0.5 * mass));
  const double synchronised = 2 / omega / (std::sqrt(4 * 0.99 * 0.99 + 1) + 2 * 0.99);
  const double half_step = 2 / omega * (std::sqrt(0.99 * 0.99 + 1) - 0.99);  // physics 4.1
  const auto try_pair = [&](auto integration) {
    pendular::system s{material{normal::linear{1e3}, damping::viscous{0.99}}, boundary::walls{}, integration};
    s.add({{0, 0, 0}, r, rho});
    s.add({{2 * r - 1e-9, 0, 0}, r, rho});
    s.start();
  };
  CHECK_NOTHROW(try_pair(velocity_verlet{0.99 * synchronised}));
  CHECK_NOTHROW(try_pair(half_step_velocity_verlet{0.99 * half_step}));
  CHECK(mentions(refusal([&] { try_pair(velocity_verlet{1.01 * synchronised}); }),
                 {"time step", "dashpots", pendular::detail::number(1.01 * synchronised),
                  pendular::detail::number(synchronised)}));
  CHECK(mentions(refusal([&] { try_pair(half_step_velocity_verlet{1.01 * half_step}); }),
                 {pendular::detail::number(1.01 * half_step), pendular::detail::number(half_step)}));
}

TEST_CASE("explicit tangential viscosity beyond its bound is refused, the stable form is not") {
  // gamma dt n < 2 m_t with half-step velocities and half of that with synchronised ones, m_t = 2/7 of half a mass.
  const double bound = 2 * (2.0 / 7) * 0.5 * mass / (2 * 1.0);  // two contacts, 1 N s/m
  const material published{normal::linear{1e3}, friction::viscous_coulomb_explicit{1, 0.4}};
  const material stable{normal::linear{1e3}, friction::viscous_coulomb{1, 0.4}};
  CHECK_NOTHROW(try_row(published, half_step_velocity_verlet{0.99 * bound}));
  CHECK_NOTHROW(try_row(published, velocity_verlet{0.495 * bound}));
  CHECK(mentions(
      refusal([&] { try_row(published, half_step_velocity_verlet{1.01 * bound}); }),
      {"explicit tangential viscosity", pendular::detail::number(1.01 * bound), pendular::detail::number(bound)}));
  CHECK(mentions(refusal([&] { try_row(published, velocity_verlet{1e-6}); }),
                 {"explicit tangential viscosity", "1e-06"}));
  CHECK_NOTHROW(try_row(published, velocity_verlet{1e-6}, true));
  CHECK_NOTHROW(try_row(stable, velocity_verlet{1e-6}));
}

TEST_CASE("a bridge so small that its force changes within a step is refused when the liquid is put in") {
  // V_b = 2e-6 R^3: lambda = 0.9 sqrt(V_b / R), slope kappa R / lambda, bound 0.1 sqrt(m_red lambda / kappa R).
  const double v = 2e-6 * r * r * r, lambda = 0.9 * std::sqrt(v / r), pull = 2 * pi * 0.0728 * r;
  const double bound = 0.1 * std::sqrt(0.5 * mass * lambda / pull);
  CHECK_NOTHROW(try_wet_pair(1e3, v, velocity_verlet{0.99 * bound}));
  CHECK(mentions(
      refusal([&] { try_wet_pair(1e3, v, velocity_verlet{1.01 * bound}); }),
      {"slope of the capillary force", pendular::detail::number(1.01 * bound), pendular::detail::number(bound)}));
  CHECK_NOTHROW(try_wet_pair(1e3, v, velocity_verlet{1.01 * bound}, true));
}

TEST_CASE(
    "a damping rate of 1 is refused by the scene, a larger one by the law, and so is a user's overdamped contact") {
  CHECK(mentions(refusal([] {
                   material{normal::linear{1e3}, damping::viscous{1.01}};
                 }),
                 {"alpha_n", "is 1.01", "[0, 1]"}));
  CHECK(mentions(refusal([] {
                   material{normal::linear{1e3}, damping::viscous_on_approach{1.01}};
                 }),
                 {"alpha_n", "is 1.01"}));
  CHECK(mentions(refusal([] {
                   try_row(material{normal::linear{1e3}, damping::viscous{1.0}}, velocity_verlet{1e-7});
                 }),
                 {"damping rate", "is 1,"}));
  const double critical = 2 * std::sqrt(0.5 * mass * 1e3);
  CHECK_NOTHROW(try_row(material{normal::linear{1e3}, plain_dashpot{0.99 * critical}}, velocity_verlet{1e-7}));
  const std::string said = refusal([&] {
    try_row(material{normal::linear{1e3}, plain_dashpot{1.5 * critical}}, velocity_verlet{1e-7});
  });
  CHECK(mentions(said, {"damping rate", "1.5", "at most"}));
  CHECK_NOTHROW(try_row(material{normal::linear{1e3}, plain_dashpot{1.5 * critical}}, velocity_verlet{1e-7}, true));
}

TEST_CASE("contacts too soft for bridges, for a lid or for the weight of the scene are refused") {
  // Overlap kappa R / k_n over the diameter at most 1e-3.
  const double pull = 2 * pi * 0.0728 * r, softest = pull / (1e-3 * 2 * r), v = 0.01 * r * r * r;
  CHECK_NOTHROW(try_wet_pair(1.01 * softest, v, velocity_verlet{1e-6}));
  CHECK(mentions(refusal([&] { try_wet_pair(0.5 * softest, v, velocity_verlet{1e-6}); }),
                 {"overlap", "capillary force", "0.002", "0.001"}));
  CHECK_NOTHROW(try_wet_pair(0.5 * softest, v, velocity_verlet{1e-6}, true));

  const auto try_lid = [&](double stress) {  // sigma d^2 / k_n over d
    pendular::system s{material{normal::linear{1e3}},
                       boundary::walls{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}},
                                       boundary::wall{boundary::plane{{0, 0, 1e-3}, {0, 0, -1}},
                                                      boundary::servo_stress{stress, 1e-6, 1e-6, 1e-3}}},
                       velocity_verlet{1e-6}};
    s.add({{0, 0, r}, r, rho});
    s.start();
  };
  CHECK_NOTHROW(try_lid(990));
  CHECK(mentions(refusal([&] { try_lid(2000); }), {"overlap", "pressure of the scene", "0.002", "0.001"}));

  const auto try_weight = [&](double gravity) {  // two grains far above each other: phi rho g H
    pendular::system s{material{normal::linear{1e3}}, floor_plane(), velocity_verlet{1e-6, {0, 0, -gravity}}};
    s.add({{0, 0, r}, r, rho});
    s.add({{0, 0, 99e-3 + r}, r, rho});
    s.start();
  };
  CHECK_NOTHROW(try_weight(6));
  CHECK(mentions(refusal([&] { try_weight(9.81); }), {"pressure of the scene", "0.00153", "0.001"}));
}

TEST_CASE("a wall stiffer than the grains counts in the bound on the time step") {
  const auto try_wall = [&](double time_step) {
    pendular::system s{material{normal::linear{1e3}},
                       boundary::walls{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}, boundary::fixed{},
                                                      material{normal::linear{1e6}}}},
                       velocity_verlet{time_step}};
    s.add({{0, 0, r - 1e-9}, r, rho});
    s.start();
  };
  const double bound = 2 / std::sqrt(1e6 / mass);
  CHECK_NOTHROW(try_wall(0.5 * bound));
  CHECK(mentions(refusal([&] { try_wall(1.5 * bound); }), {"time step", pendular::detail::number(1.5 * bound)}));
}

TEST_CASE("several broken limits are all named at once") {
  const std::string said = refusal([&] {
    try_row(material{normal::linear{1e3}, friction::viscous_coulomb_explicit{1, 0.4}}, velocity_verlet{1e-3});
  });
  CHECK(mentions(said, {"stiffness", "explicit tangential viscosity"}));
}

TEST_CASE("arguments without meaning are refused at the border") {
  const material m{normal::linear{1e3}};
  CHECK(mentions(refusal([&] {
                   pendular::system s{m, boundary::walls{}, velocity_verlet{0}};
                 }),
                 {"time step", "is 0"}));
  CHECK(mentions(refusal([&] {
                   pendular::system s{m, boundary::walls{}, velocity_verlet{1e-6}, run_options{.skin = 0}};
                 }),
                 {"skin", "is 0"}));
  CHECK(mentions(refusal([&] {
                   pendular::system s{m, boundary::walls{}, velocity_verlet{1e-6}, run_options{.overlap_limit = 1}};
                 }),
                 {"overlap limit", "is 1"}));
  pendular::system empty{m, boundary::walls{}, velocity_verlet{1e-6}};
  CHECK(mentions(refusal([&] { empty.run(1); }), {"number of grains", "is 0"}));
  CHECK(mentions(refusal([&] { empty.limits(); }), {"number of grains", "is 0"}));
  CHECK(mentions(refusal([&] { empty.canonicalise(); }), {"number of grains", "is 0"}));
  empty.add({{0, 0, 0}, r, rho});
  empty.run(1);
  CHECK(mentions(refusal([&] {
                   pendular::system s{m, boundary::walls{}, velocity_verlet{1e-6}};
                   s.add({{0, 0, 0}, -1, rho});
                 }),
                 {"radius", "-1"}));
  CHECK(mentions(refusal([&] {
                   pendular::system s{m, boundary::walls{}, velocity_verlet{1e-6}};
                   s.add({{0, 0, NAN}, r, rho});
                 }),
                 {"position", "nan"}));
  CHECK(mentions(refusal([&] {
                   pendular::system s{
                       m, liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::gravity{}},
                       boundary::walls{}, velocity_verlet{1e-6}};
                 }),
                 {"gravity", "is 0"}));
  CHECK(mentions(refusal([&] {
                   pendular::system s{m, liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}},
                                      boundary::walls{}, velocity_verlet{1e-6}};
                   s.add({{0, 0, 0}, r, rho});
                   s.distribute_liquid(-1e-12);
                 }),
                 {"liquid volume", "-1e-12"}));
}
