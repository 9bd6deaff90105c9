// SPDX-License-Identifier: BSD-3-Clause
// The program of docs/how-to/own_protocol.md.
#include <pendular/pendular.hpp>
#include <pendular/testing/role_kits.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

// [protocol]
/// The film of a grain goes to its bonds in equal shares.
struct equal_shares {
  double offer(const pendular::bond_side&) const { return 1; }
  double merge(double a, double b) const { return a + b; }
  double settle(double bonds, double film) const { return film / bonds; }  // m3 per bond
  double pull(const pendular::bond_side&, double grant) const { return grant; }
};
static_assert(pendular::LocalProtocol<equal_shares>);
// [/protocol]

// [formation]
/// A bridge forms at a tenth of its rupture distance, if each R^3 gets a ten-thousandth of liquid.
struct early {
  double minimum_volume = 1e-4;  // V_b / R^3
  double reach(double rupture_distance) const { return 0.1 * rupture_distance; }
};
static_assert(pendular::FormationRule<early>);
// [/formation]

using namespace pendular;

int main() {
  // [kit]
  for (const std::string& broken : testing::local_protocol_report(equal_shares{})) std::printf("%s\n", broken.c_str());
  for (const std::string& broken : testing::formation_rule_report(early{})) std::printf("%s\n", broken.c_str());
  // [/kit]
  const bool sound =
      testing::local_protocol_report(equal_shares{}).empty() && testing::formation_rule_report(early{}).empty();
  // [chain]
  constexpr double radius = 0.5e-3, volume = 0.01 * radius * radius * radius;
  pendular::system chain{material{normal::linear{1e3}},
                         liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, equal_shares{}, early{}},
                         boundary::walls{}, velocity_verlet{1e-6}};
  chain.add({.position = {0, 0, 0}, .radius = radius, .density = 2600});
  chain.add({.position = {2 * radius, 0, 0}, .radius = radius, .density = 2600});
  chain.add({.position = {4 * radius, 0, 0}, .radius = radius, .density = 2600, .velocity = {0.5, 0, 0}});
  chain.distribute_liquid(2 * volume);
  chain.run(1000);
  // [/chain]
  const ledger& book = chain.bridges().book();
  const std::vector<std::size_t> rows = chain.particles().rows_by_id();
  std::printf("ruptures %lld, bridge %.3f, film of the free grain %.3f of a bridge, lost %.1e\n",
              static_cast<long long>(chain.events().ruptures), book.bonds()[0] / volume, book.films()[rows[2]] / volume,
              book.total() / (2 * volume) - 1);
  const auto near = [](double a, double b) { return std::abs(a - b) < 1e-12; };
  const bool as_expected = chain.events().ruptures == 1 && near(book.bonds()[0] / volume, 1.5) &&
                           near(book.films()[rows[2]] / volume, 0.5) && near(book.total() / (2 * volume), 1);
  return sound && as_expected ? EXIT_SUCCESS : EXIT_FAILURE;
}
