// SPDX-License-Identifier: BSD-3-Clause
// Protocols of films, in two and in three parts, and with a friction that counts contacts.
#include "in_parts.hpp"

using namespace in_parts;

namespace {

using any_local = protocol::one_of<protocol::neighbours, protocol::grain_films, protocol::gravity>;

template <class Options>
auto shake(const any_local& protocol, const Options& options) {
  pendular::system s{
      material{normal::linear{4e3}, damping::viscous{0.03}, friction::viscous_coulomb{1, 0.4}, energy_book{}},
      liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol}, dragged_box(),
      velocity_verlet{dt, sideways}, options};
  fill(s);
  s.run(300);
  s.distribute_liquid(1e-12 * 216);
  s.run(8000);
  return s;
}

void check_protocol(const any_local& protocol) {
  const auto live = [&](const auto& options) { return shake(protocol, options); };
  const record whole = in_one_piece(live);
  CHECK(whole.ruptures + whole.formations > 1000);
  check_parts(whole, live);
}

}  // namespace

TEST_CASE("protocol 0 does not see the parts of a scene") { check_protocol(any_local(protocol::neighbours{})); }
TEST_CASE("protocol 2 does not see the parts of a scene") { check_protocol(any_local(protocol::grain_films{})); }
TEST_CASE("protocol 3 does not see the parts of a scene") { check_protocol(any_local(protocol::gravity{})); }
