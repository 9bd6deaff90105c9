// SPDX-License-Identifier: BSD-3-Clause
// Protocols of films, in two and in three parts, with bridges that form across gaps, another liquid on the way, and a
// friction that counts contacts.
#include "in_parts.hpp"

using namespace in_parts;

namespace {

using any_local = protocol::one_of<protocol::neighbours, protocol::grain_films, protocol::gravity>;

/// Beyond an angle of 1.0472 the rupture distance is not valid.
auto wet_under(double contact_angle, const any_local& protocol) {
  return liquid{fluid{0.072, contact_angle, 998, 1e-3}, capillary::richefeu{}, rupture::lian{}, protocol,
                formation::within_rupture_distance{}};
}

template <class Options>
auto shake(const any_local& protocol, const Options& options) {
  pendular::system s{
      material{normal::linear{4e3}, damping::viscous{0.03}, friction::viscous_coulomb{1, 0.4}, energy_book{}},
      wet_under(0, protocol), dragged_box(), velocity_verlet{dt, sideways}, options};
  fill(s);
  s.run(300);
  s.distribute_liquid(1e-12 * 216);
  s.run(6000);
  s.change_liquid(wet_under(1.1, protocol));  // bridges reach farther: a list is made while all that acts stands
  s.run(2000);
  return s;
}

void check_protocol(const any_local& protocol) {
  const auto live = [&](const auto& options) { return shake(protocol, options); };
  const record whole = in_one_piece(live);
  CHECK(whole.ruptures + whole.formations > 1000);
  CHECK(whole.outside > 50);
  check_parts(whole, live);
}

}  // namespace

TEST_CASE("protocol 0 does not see the parts of a scene") { check_protocol(any_local(protocol::neighbours{})); }
TEST_CASE("protocol 2 does not see the parts of a scene") { check_protocol(any_local(protocol::grain_films{})); }
TEST_CASE("protocol 3 does not see the parts of a scene") { check_protocol(any_local(protocol::gravity{})); }
