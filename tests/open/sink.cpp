// SPDX-License-Identifier: BSD-3-Clause
// A user's sink, written from outside: a pump that takes a tenth of every bridge once per period.
#include "../catch.hpp"

#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/liquid/protocol/all.hpp>
#include <pendular/system.hpp>

#include <cmath>
#include <string>
#include <string_view>

using namespace pendular;

namespace {

struct pump {
  static constexpr std::string_view account = "pump";
  std::int64_t period = 10;  // steps
  double share = 0.1;
  double more = 0;  // of every bridge than of the one before

  template <class Door>
  void act(Door& door) const {
    double part = share;
    door.for_each_bridge([&](std::size_t pair) {
      door.drain_bridge(pair, part * door.bridge_at(pair).volume);
      part += more;
    });
  }
};
static_assert(Source<pump>);

constexpr double radius = 0.5e-3, gap = 1e-6;

template <class... Policies>
auto chain(int grains, const Policies&... policies) {
  pendular::system s{material{normal::linear{1e3}, damping::viscous{0.3}},
                     liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, policies...}, boundary::walls{},
                     velocity_verlet{1e-7}, run_options{.force = true}};
  for (int k = 0; k < grains; ++k) {
    s.add({.position = {(2 * radius + gap) * k, 0, 0}, .radius = radius, .density = 1e12});  // too heavy to move
  }
  s.distribute_liquid(1e-12 * (grains - 1));
  return s;
}

/// The pull of the first bridge on the first grain, N.
template <class System>
double pull(const System& s) {
  return s.contacts().force(0).x;
}

}  // namespace

TEST_CASE("a pump takes what it says, and here and outside are what was introduced") {
  auto s = chain(5, pump{});
  s.run(200);
  const ledger& book = s.bridges().book();
  for (int k = 0; k < 4; ++k)
    CHECK(book.bonds()[static_cast<std::size_t>(k)] == within(1e-12, 1e-12 * std::pow(0.9, 20)));
  CHECK(book.outside("pump") == within(1e-12, 4e-12 * (1 - std::pow(0.9, 20))));
  CHECK(book.total() + book.outside("pump") == within(1e-12, book.introduced()));
  CHECK(book.here() == within(1e-12, book.total()));
}

TEST_CASE("pull and rupture distance follow the volume in the step in which it is taken") {
  auto pumped = chain(2, pump{1, 0.5});
  pumped.run(1);
  const double volume = pumped.bridges().book().bonds()[0];
  CHECK(volume == within(1e-12, 0.5e-12));
  CHECK(pumped.bridges().breaks_above(0) == within(1e-12, std::cbrt(0.5e-12)));
  // Richefeu et al. 2007, Eqs. 5-7 at this volume: kappa R exp(-gap / lambda)
  const double lambda = 0.9 * std::sqrt(volume / radius);  // equal grains
  const double expected = 2 * 3.14159265358979 * 0.0728 * radius * std::exp(-gap / lambda);
  CHECK(pull(pumped) == within(1e-6, expected));
}

TEST_CASE("what a sink has taken never comes back") {
  auto s = chain(5, pump{10, 0.5}, protocol::homogeneous{7});
  s.run(100);
  const double here = 4e-12 * std::pow(0.5, 10);
  CHECK(s.bridges().book().total() == within(1e-12, here));
  s.distribute_liquid(1e-12);
  CHECK(s.bridges().book().total() == within(1e-12, here + 1e-12));
  CHECK(s.bridges().book().introduced() == within(1e-12, 5e-12));
}

TEST_CASE("a sink without a period is refused where the liquid is built") {
  CHECK_THROWS_AS((liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, pump{0}}), input_error);
  CHECK_THROWS_AS((liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, pump{-3}}), input_error);
}

TEST_CASE("a sink that asks for more than there is stops the run after a whole step, and nothing was taken") {
  auto s = chain(3, pump{10, 1.5});
  auto alone = chain(3);
  std::string message;
  try {
    s.run(100);
  } catch (const input_error& e) {
    message = e.what();
  }
  CHECK(message.find("the volume taken from the bridge of 0 and 1 (m3) is 1.5e-12") != std::string::npos);
  CHECK(message.find("docs/reference/liquid.md") != std::string::npos);
  CHECK(s.step_count() == 10);
  alone.run(10);
  CHECK(s.bridges().book().total() == alone.bridges().book().total());
  CHECK(s.bridges().book().outside("pump") == 0);
  CHECK(pull(s) == pull(alone));
  s.run(5);
  alone.run(5);
  CHECK(pull(s) == pull(alone));
}

TEST_CASE("what a sink has taken before it asks for more than there is is given back") {
  auto s = chain(3, pump{10, 0.5, 1});
  auto alone = chain(3);
  CHECK_THROWS_WITH(s.run(100), Catch::Contains("the bridge of 1 and 2"));
  alone.run(10);
  CHECK(s.bridges().book().bonds()[0] == alone.bridges().book().bonds()[0]);
  CHECK(s.bridges().book().outside("pump") == 0);
  CHECK(pull(s) == pull(alone));
}

TEST_CASE("a sink after one that throws takes nothing in that step, and what was thrown is not lost") {
  auto s = chain(3, pump{10, 1.5}, pump{10, 0.1});
  CHECK_THROWS_AS(s.run(100), input_error);
  CHECK(s.step_count() == 10);
  CHECK(s.bridges().book().outside("pump") == 0);
}
