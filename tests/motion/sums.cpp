// SPDX-License-Identifier: BSD-3-Clause
// Force, torque and number of contacts of every grain against sums over pairs and walls in plain numbers.
#include "../catch.hpp"

#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/friction/viscous_coulomb.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/system.hpp>

#include <cmath>
#include <vector>

using namespace pendular;

namespace {
struct total {
  vector force{0, 0, 0}, torque{0, 0, 0};
  double contacts = 0;
};

// A heap of equal spheres that overlap a little, shear past each other and lie in a corner of two walls.
template <class Material>
auto heap_of(const Material& m) {
  pendular::system s{m,
                     boundary::walls{boundary::wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}},
                                     boundary::wall{boundary::plane{{0, 0, 0}, {1, 0, 0}}}},
                     velocity_verlet{1e-6, {0, 0, -9.81}}};
  for (int k = 0; k < 60; ++k) {
    const double x = k % 3, y = k / 3 % 4, z = k / 12;
    const double speed = 1e-2 * std::sin(7.0 * k);
    s.add(
        {0.999e-3 * vector{x + 0.5, y, z + 0.5}, 0.5e-3, 2700, {speed, -2 * speed, 0.5 * speed}, {30 * speed, 5, -9}});
  }
  s.run(20);
  return s;
}

// The action on the first grain is that of the pair; on the second its opposite, with a torque of the same sense.
template <class System>
std::vector<total> sums_of(const System& s) {
  std::vector<total> sums(s.particles().size());
  const auto radius = s.particles().template get<column::radius>();
  for (std::size_t p = 0; p < s.pairs().size(); ++p) {
    const auto i = static_cast<std::size_t>(s.pairs().first()[p]), j = static_cast<std::size_t>(s.pairs().second()[p]);
    const auto& action = s.contacts().actions()[p];
    const vector force = s.contacts().force(p);
    sums[i].force += force, sums[j].force -= force;
    const double touching = s.contacts().gap()[p] < 0 ? 1 : 0;
    sums[i].contacts += touching, sums[j].contacts += touching;
    if constexpr (System::grains_type::rotate) {
      const vector turn{action.high.a, action.high.b, action.high.c};
      sums[i].torque += (radius[i] + 0.5 * s.contacts().gap()[p]) * turn;
      sums[j].torque += (radius[j] + 0.5 * s.contacts().gap()[p]) * turn;
    }
  }
  s.for_each_wall([&](const auto&, const auto& wall) {
    for (std::size_t k = 0; k < wall.size(); ++k) {
      sums[wall.row(k)].force += wall.force(k);
      if constexpr (System::grains_type::rotate) {
        sums[wall.row(k)].torque += wall.torque(k);
      }
      sums[wall.row(k)].contacts += wall.gap(k) < 0 ? 1 : 0;
    }
  });
  return sums;
}
}  // namespace

TEST_CASE("a grain feels all of its pairs and walls, each once and with its own sign and lever") {
  const auto s = heap_of(material{normal::linear{1e3}, damping::viscous{0.5}, friction::viscous_coulomb{0.5, 0.4}});
  const auto sums = sums_of(s);
  double turned = 0;
  for (std::size_t k = 0; k < sums.size(); ++k) {
    CHECK(norm(sums[k].force - s.particles().get<column::force>()[k]) < 1e-17);
    CHECK(norm(sums[k].torque - s.particles().get<column::torque>()[k]) < 1e-21);
    CHECK(sums[k].contacts == s.particles().get<column::contacts>()[k]);
    turned += norm(sums[k].torque);
  }
  CHECK(turned > 1e-8);
  CHECK(s.pairs().size() > 100);
}

TEST_CASE("the same without friction") {
  const auto s = heap_of(material{normal::linear{1e3}, damping::viscous{0.5}});
  const auto sums = sums_of(s);
  for (std::size_t k = 0; k < sums.size(); ++k) {
    CHECK(norm(sums[k].force - s.particles().get<column::force>()[k]) < 1e-17);
  }
}
