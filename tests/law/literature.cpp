// SPDX-License-Identifier: BSD-3-Clause
// The laws of the literature: coefficients against values that another code (YADE 2022, regression of its wet laws)
// computes, and their known distance from Laplace-Young. A law that fits better or worse than this is another law.
#include "../catch.hpp"

#include <pendular/laplace_young/solve.hpp>
#include <pendular/law/all.hpp>
#include <pendular/law/validity.hpp>
#include <pendular/testing/law_kits.hpp>

#include <boost/hana/for_each.hpp>

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <typeinfo>

using namespace pendular;

namespace {
constexpr double degree = std::numbers::pi / 180;

struct interval {
  double low = 1e300, high = -1e300;
};

/// Relative misfit to Laplace-Young at parts of the rupture distance, equal spheres unless a ratio is given.
template <class Law>
interval misfit(const Law& law, double angle, std::initializer_list<double> volumes,
                std::initializer_list<double> parts, double ratio = 1) {
  const double pi = std::numbers::pi;
  const fluid f{1 / (2 * pi), angle * degree, 1000, 0};
  const double harmonic = 2 / (1 + 1 / ratio), cube = harmonic * harmonic * harmonic;
  interval found;
  for (const double v : volumes) {
    laplace_young::bridges_of_volume exact({1, ratio, f.contact_angle, v * cube, f.surface_tension});
    for (const double part : parts) {
      const double gap = part * exact.rupture_distance();
      const double off = testing::pull(law, bridge<double>{gap, v * cube, 1, ratio}, f) / exact.at(gap)->attraction - 1;
      found = {std::min(found.low, off), std::max(found.high, off)};
    }
  }
  return found;
}

bool inside(const interval& found, double low, double high) { return found.low >= low && found.high <= high; }
}  // namespace

TEST_CASE("Willett's fits and Rabinovich's law give the numbers of another code") {
  const double small = 19e-6;
  const auto gap = [&](double large) { return 249e-9 - 1e-5 * (small + large); };
  const fluid a{27e-3, 10 * degree, 1000, 0}, b{24e-3, 10 * degree, 1000, 0}, c{28e-3, 10 * degree, 1000, 0};
  CHECK(capillary::willett{}.attraction(bridge<double>{gap(35e-6), .2e-18, small, 35e-6}, a) ==
        within(1e-11, 2.07328148666e-7));
  CHECK(capillary::willett_closed_form{}.attraction(bridge<double>{gap(32.5e-6), 1.2e-18, small, 32.5e-6}, b) ==
        within(1e-8, 6.78192074e-7));
  CHECK(capillary::rabinovich{}.attraction(bridge<double>{gap(27.5e-6), 3.6e-18, small, 27.5e-6}, c) ==
        within(1e-11, 1.58617796928e-6));
}

TEST_CASE("Mikami's regression, read to base 10, is Soulie's for equal spheres") {
  for (const double angle : {0.0, 0.2, 0.5}) {
    const fluid f{0.072, angle, 1000, 0};
    for (const double v : {1e-4, 1e-2}) {
      for (const double gap : {0.0, 1e-3, 3e-2}) {
        const bridge<double> b{gap, v, 1, 1};
        CHECK(capillary::mikami{}.attraction(b, f) == within(6e-3, capillary::soulie{}.attraction(b, f)));
      }
    }
  }
}

TEST_CASE("Soulie's radius is that of the larger sphere") {
  // Everything but the geometric mean in front depends on the larger sphere alone.
  const fluid f = fluid::water();
  const auto pull = [&](double gap, double ri, double rj) {
    return capillary::soulie{}.attraction(bridge<double>{gap, 1e-12, ri, rj}, f);
  };
  for (const double gap : {0.0, 1e-5, 1e-4}) {
    CHECK(pull(gap, 5e-4, 1e-3) == within(1e-13, std::sqrt(0.5) * pull(gap, 1e-3, 1e-3)));
    CHECK(pull(gap, 1e-3, 5e-4) == pull(gap, 5e-4, 1e-3));
  }
}

TEST_CASE("what is known of the misfit of each law at perfect wetting") {
  const auto all = {1e-4, 1e-3, 1e-2, 1e-1};
  const auto small = {1e-4};
  const auto contact = {0.0}, inner = {0.0, .1, .25, .5, .75}, outer = {.5, .75, .95}, whole = {0.0, .25, .5, .75, .95};
  CHECK(inside(misfit(capillary::soulie{}, 0, all, contact), -.07, .10));
  CHECK(inside(misfit(capillary::soulie{}, 0, all, inner), -.10, .10));
  CHECK(inside(misfit(capillary::mikami{}, 0, all, inner), -.10, .10));
  CHECK(inside(misfit(capillary::willett{}, 0, all, inner), -.03, .03));
  CHECK(inside(misfit(capillary::willett_closed_form{}, 0, all, contact), .035, .275));
  CHECK(inside(misfit(capillary::willett_closed_form{}, 0, all, outer), -.24, -.07));
  CHECK(inside(misfit(capillary::lambert{}, 0, all, contact), .035, .275));
  CHECK(inside(misfit(capillary::lambert{}, 0, all, outer), -.25, -.12));
  CHECK(misfit(capillary::rabinovich{}, 0, {1e-1}, contact).high > .5);
  CHECK(inside(misfit(capillary::rabinovich{}, 0, small, contact), .04, .05));
  CHECK(inside(misfit(capillary::weigert_ripperger{}, 0, all, contact), -.075, -.01));
  CHECK(misfit(capillary::weigert_ripperger{}, 0, small, whole).high > 4);
  CHECK(inside(misfit(capillary::huppmann_riegger{}, 0, all, contact), -.08, 0));
  CHECK(misfit(capillary::huppmann_riegger{}, 0, small, whole).low < -.9);
  CHECK(inside(misfit(capillary::lian_seville{}, 0, all, contact), -.005, .005));
  CHECK(inside(misfit(capillary::lian_seville{}, 0, all, inner), -.02, .06));
  CHECK(inside(misfit(capillary::bagheri{}, 0, all, contact), -.005, .005));
  CHECK(inside(misfit(capillary::bagheri{}, 0, all, inner), -.021, .02));
  CHECK(inside(misfit(capillary::constant{}, 0, small, contact), .035, .04));
}

TEST_CASE("the laws on the harmonic mean keep their misfit at every size ratio and at a plane") {
  const double plane = std::numeric_limits<double>::infinity();
  for (const double ratio : {2.0, 10.0, 100.0, plane}) {
    CAPTURE(ratio);
    CHECK(inside(misfit(capillary::willett{}, 0, {1e-4, 1e-3, 1e-2}, {0.0, .25, .5, .75}, ratio), -.04, .05));
    CHECK(inside(misfit(capillary::bagheri{}, 0, {1e-4, 1e-3, 1e-2}, {0.0, .25, .5, .75}, ratio), -.04, .04));
    CHECK(inside(misfit(capillary::lambert{}, 0, {1e-4, 1e-3, 1e-2}, {0.0}, ratio), .03, .18));
  }
}

TEST_CASE("the laws that carry the contact angle keep their misfit at 20 and 40 degrees") {
  CHECK(inside(misfit(capillary::willett{}, 20, {1e-4, 1e-2}, {0.0, .25, .5, .75}), -.03, .03));
  CHECK(inside(misfit(capillary::willett{}, 40, {1e-4, 1e-2}, {0.0, .25, .5, .75}), -.03, .04));
  CHECK(inside(misfit(capillary::bagheri{}, 40, {1e-4, 1e-2, 1e-1}, {0.0}), -.01, .01));
  CHECK(misfit(capillary::bagheri{}, 40, {1e-4}, {.75, .95}).low < -.1);
  CHECK(misfit(capillary::soulie{}, 40, {1e-4}, {0.0}).high > .4);
  CHECK(inside(misfit(capillary::lian_seville{}, 40, {1e-4, 1e-2}, {0.0}), -.005, .005));
}

TEST_CASE("the rupture distances of equal spheres") {
  const fluid f{0.072, 0, 1000, 0};
  const double mikami[] = {-.074, -.062, -.055, -.073};
  const double volumes[] = {1e-4, 1e-3, 1e-2, 1e-1};
  for (int k = 0; k < 4; ++k) {
    const double exact = laplace_young::rupture_distance({1, 1, 0, volumes[k], 0.072});
    const bridge<double> b{0, volumes[k], 1, 1};
    CHECK(rupture::willett_equal{}.distance(b, f) / exact - 1 == near(.007, 0));
    CHECK(rupture::mikami{}.distance(b, f) / exact - 1 == near(.005, mikami[k]));
    CHECK(rupture::willett_equal{}.distance(b, f) == within(1e-14, rupture::willett{}.distance(b, f)));
  }
}

TEST_CASE("validity is data: which bridges a law was made for") {
  const fluid wetting{0.072, 0, 1000, 0}, beading{0.072, 1.2, 1000, 0};
  const auto equal = [](double v) { return bridge<double>{0, v * 1e-9, 1e-3, 1e-3}; };
  CHECK(validity_of<capillary::willett>().covers(equal(1e-3), wetting));
  CHECK_FALSE(validity_of<capillary::willett>().covers(equal(1e-6), wetting));
  CHECK_FALSE(validity_of<capillary::willett>().covers(equal(0.2), wetting));
  CHECK_FALSE(validity_of<capillary::willett>().covers(equal(1e-3), beading));
  CHECK_FALSE(validity_of<capillary::mikami>().covers({0, 1e-12, 1e-3, 2e-3}, wetting));
  CHECK(validity_of<capillary::richefeu_harmonic>().covers({0, 1e-30, 1e-3, 1}, beading));
}

TEST_CASE("out of their ranges the laws stay finite, and do not see the size of things") {
  boost::hana::for_each(law::capillary_laws, []<class L>(L) {
    const typename L::type l{};
    for (const double angle : {0.0, 45.0, 60.0, 79.0, 82.0, 89.0}) {
      const fluid f{0.07, angle * degree, 1000, 0};
      for (const double v : {0.0, 1e-12, 1e-6, 1e-4, 1e-2, 0.3}) {
        for (const double gap : {0.0, 5e-3, 0.1}) {
          const double force = testing::pull(l, bridge<double>{gap, v, 1, 1}, f);
          const double tiny_one = testing::pull(l, bridge<double>{1e-9 * gap, 1e-27 * v, 1e-9, 1e-9}, f);
          CAPTURE(typeid(l).name(), angle, v, gap, force);
          CHECK((std::isfinite(force) && std::abs(force) < 2000));
          if (v > 0) CHECK(tiny_one == near(1e-10 * (1e-9 * std::abs(force)) + 1e-22, 1e-9 * force));
        }
      }
    }
    if constexpr (HasCapillaryEnergy<typename L::type>) {
      CHECK(std::isfinite(l.energy(bridge<double>{0, 0, 1, 1}, fluid::water(), 0.1)));
    }
  });
}
