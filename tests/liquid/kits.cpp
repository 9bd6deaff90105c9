// SPDX-License-Identifier: BSD-3-Clause
// Formation rules, protocols and sources keep their promises, and the kits find one that does not.
#include "../found.hpp"

#include <pendular/liquid/protocol/all.hpp>
#include <pendular/liquid/protocol/one_of.hpp>
#include <pendular/liquid/source/all.hpp>
#include <pendular/testing/formation_rule.hpp>
#include <pendular/testing/global_protocol.hpp>
#include <pendular/testing/local_protocol.hpp>
#include <pendular/testing/role_archetypes.hpp>
#include <pendular/testing/source.hpp>

#include <boost/hana/for_each.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace pendular;
using testing::formation_rule_report;
using testing::global_protocol_report;
using testing::local_protocol_report;
using testing::source_report;
namespace archetype = pendular::testing::archetype;

namespace {
struct bad_rule {
  enum class mistake { none, too_far, shrinks, endless, negative_volume } made;
  double minimum_volume = made == mistake::negative_volume ? -1 : 1e-6;
  double reach(double distance) const {
    if (made == mistake::too_far) return 1.1 * distance;
    if (made == mistake::shrinks) return -distance;
    if (made == mistake::endless) return -1 / distance;
    return 0.5 * distance;
  }
};

/// Shares by the partners' radii with one mistake.
struct bad_shares {
  enum class mistake { none, twice, gives_back, last_counts, by_pairs, divides_by_none } made;
  double offer(const bond_side& b) const {
    return made == mistake::divides_by_none && !b.forming ? 0 : b.partner_radius;
  }
  double merge(double a, double b) const {
    if (made == mistake::last_counts) return 2 * a + b;
    return made == mistake::by_pairs ? a + b + 1e3 * a * b / (a + b) * std::abs(a - b) : a + b;
  }
  double settle(double bonds, double film) const {
    if (made == mistake::gives_back) return -film / bonds;
    return (made == mistake::twice ? 2 : 1) * film / bonds;
  }
  double pull(const bond_side& b, double grant) const { return grant * b.partner_radius; }
};

struct bad_global {
  enum class mistake { none, never, takes_too_much, by_storage, to_itself, drains, at_the_wall } made;
  std::int64_t period = made == mistake::never ? 0 : 10;
  template <class Door>
  void redistribute(Door& door) const {
    using enum mistake;
    if (made == takes_too_much) door.for_each_bridge([&](std::size_t p) { door.from_bridge_to_film(p, 0, 1e-9); });
    if (made == by_storage && door.film(0) > 0) door.from_film_to_film(0, 1, 0.5 * door.film(0));
    if constexpr (requires { door.drain_bridge(0, 0.0); }) {
      if (made == drains) door.for_each_bridge([&](std::size_t p) { door.drain_bridge(p, door.bridge_at(p).volume); });
    }
    if (made == at_the_wall) {
      door.for_each_bridge([&](std::size_t p) { door.from_bridge_to_film(p, door.second_grain(p), 0); });
    }
    if (made == none) door.for_each_bridge([&](std::size_t p) { door.break_bridge(p); });
  }
};

struct bad_source {
  enum class mistake { none, never, nameless, too_much, nothing_real, by_storage } made;
  std::string_view account = made == mistake::nameless ? "" : "pump";
  std::int64_t period = made == mistake::never ? -1 : 10;
  template <class Door>
  void act(Door& door) const {
    using enum mistake;
    if (made == by_storage) return door.wet_grain(0, 1e-15);
    door.for_each_grain([&](std::size_t grain) {
      if (made == too_much) door.dry_grain(grain, 1e-15);
      if (made == nothing_real) door.wet_grain(grain, std::numeric_limits<double>::quiet_NaN());
      door.dry_grain(grain, 0.5 * door.film(grain));
    });
  }
};
}  // namespace

TEST_CASE("formation rules keep their promises, and the kit finds a broken one") {
  check_sound(formation_rule_report(formation::at_contact{}));
  check_sound(formation_rule_report(formation::within_rupture_distance{}));
  check_sound(formation_rule_report(archetype::formation_rule(1e-5)));
  using enum bad_rule::mistake;
  const auto of = [](auto made) { return formation_rule_report(bad_rule{made}); };
  check_sound(of(none));
  CHECK(finds(of(too_far), "the reach must not be above the rupture distance"));
  CHECK(finds(of(shrinks), "the reach must not fall"));
  CHECK(finds(of(endless), "the reach must be finite"));
  CHECK(finds(of(negative_volume), "the minimum volume must be at least 0"));
}

TEST_CASE("shipped protocols keep their promises") {
  boost::hana::for_each(protocol::all, []<class P>(P) {
    using shipped = typename P::type;
    if constexpr (LocalProtocol<shipped>) {
      check_sound(local_protocol_report(shipped{}));
    } else if constexpr (GlobalProtocol<shipped>) {
      check_sound(global_protocol_report(shipped{}));
    }
  });
  using either = protocol::one_of<protocol::gravity, protocol::grain_films>;
  check_sound(local_protocol_report(either{protocol::gravity{}}));
  check_sound(local_protocol_report(archetype::local_protocol(0.5)));
  check_sound(global_protocol_report(archetype::global_protocol(10)));
}

TEST_CASE("the kit of local protocols finds a broken promise") {
  using enum bad_shares::mistake;
  const auto of = [](auto made) { return local_protocol_report(bad_shares{made}); };
  check_sound(of(none));
  CHECK(finds(of(twice), "the pulls of a grain must not exceed its film"));
  CHECK(finds(of(gives_back), "a pull must be finite and at least 0"));
  CHECK(finds(of(last_counts), "offers must merge in any order"));
  CHECK(finds(of(by_pairs), "offers must merge in any grouping"));
  CHECK(finds(of(divides_by_none), "a pull must be finite and at least 0"));
}

TEST_CASE("the kit of global protocols finds a broken promise") {
  using enum bad_global::mistake;
  const auto of = [](auto made) { return global_protocol_report(bad_global{made}); };
  check_sound(of(none));
  CHECK(finds(of(never), "the period must be at least 1"));
  CHECK(finds(of(takes_too_much), "it must not ask for what is not there"));
  CHECK(finds(of(by_storage), "what it does must not depend on how grains are stored"));
  CHECK(finds(of(drains), "a protocol must not bring liquid in or take it out"));
  CHECK(finds(of(at_the_wall), "it must not ask for what is not there"));
}

TEST_CASE("sources keep their promises, and the kit finds a broken one") {
  check_sound(source_report(source::evaporation{1e-7, 1e-7}));
  check_sound(source_report(source::evaporation{1e3, 1e3}));  // all at once
  check_sound(source_report(source::wetting{1e-13}));
  check_sound(source_report(source::wetting{1e-13, 10, [](const source::wettable_grain& g) { return g.id % 2 == 0; }}));
  check_sound(source_report(archetype::source(10)));
  using enum bad_source::mistake;
  const auto of = [](auto made) { return source_report(bad_source{made}); };
  check_sound(of(none));
  CHECK(finds(of(never), "the period must be at least 1"));
  CHECK(finds(of(nameless), "the account must have a name"));
  CHECK(finds(of(too_much), "it must not ask for what is not there"));
  CHECK(finds(of(nothing_real), "it must not ask for what is not there"));
  CHECK(finds(of(by_storage), "what it does must not depend on how grains are stored"));
}
