// SPDX-License-Identifier: BSD-3-Clause
// Every knock-out breaks one clause of its concept and must be refused; the twin without the mistake must be accepted.
#include "none_of.hpp"

#include <pendular/law/every_scalar.hpp>
#include <pendular/testing/knock_outs.hpp>
#include <pendular/testing/scalar_knock_outs.hpp>

using namespace pendular;
namespace knock_out = pendular::testing::knock_out;

namespace {

static_assert(none_of(knock_out::normal_laws, []<class L>(L) { return NormalLaw<type_of<L>>; }));
static_assert(none_of(knock_out::damping_laws, []<class L>(L) { return DampingLaw<type_of<L>>; }));
static_assert(none_of(knock_out::friction_laws, []<class L>(L) { return FrictionLaw<type_of<L>>; }));
static_assert(none_of(knock_out::capillary_laws, []<class L>(L) { return CapillaryLaw<type_of<L>>; }));
static_assert(none_of(knock_out::rupture_laws, []<class L>(L) { return RuptureLaw<type_of<L>>; }));
static_assert(none_of(knock_out::mean_radii, []<class L>(L) { return MeanRadius<type_of<L>>; }));
static_assert(none_of(knock_out::viscous_bridge_laws, []<class L>(L) { return ViscousBridgeLaw<type_of<L>>; }));
static_assert(none_of(knock_out::capillary_energies, []<class L>(L) { return HasCapillaryEnergy<type_of<L>>; }));

// The twins: what the knock-outs are with their one mistake mended.
struct normal_twin {
  double repulsion(const approach<double>& a) const { return -a.gap; }
};
struct damping_twin {
  double resistance(const approach<double>& a, double k) const { return k * a.closing_speed; }
};
struct damping_twin_beside_spring {
  double resistance(const approach<double>& a, const elastic<double>& e) const { return e.push * a.closing_speed; }
};
struct damping_twin_with_memory {
  template <class T>
  struct contact_memory {
    T fastest;
  };
  double resistance(const approach<double>&, double k, contact_memory<double>& m) const { return k * m.fastest; }
};
struct normal_twin_with_memory {
  template <class T>
  struct contact_memory {
    T deepest;
  };
  double repulsion(const approach<double>& a, contact_memory<double>& m) const { return m.deepest - a.gap; }
};
struct friction_twin {
  Vec3<double> traction(const slip<double>& s, double) const { return -s.velocity; }
};
struct friction_twin_with_memory {
  template <class T>
  struct contact_memory {
    Vec3<T> force;
  };
  Vec3<double> traction(const slip<double>&, double, contact_memory<double>& memory) const { return memory.force; }
};
struct capillary_twin {
  double attraction(const bridge<double>& b, const fluid&) const { return b.radius_i; }
  double energy(const bridge<double>&, const fluid&, double) const { return 0; }
};
struct prepared_twin {
  template <class T>
  using coefficients = T;
  double prepare(const bridge<double>& b, const fluid&) const { return b.radius_i; }
  double attraction(double, double c) const { return c; }
};
struct rupture_twin {
  double distance(const bridge<double>& b, const fluid&) const { return b.radius_i; }
};
struct mean_twin {
  double of(const bridge<double>& b) const { return b.radius_i; }
};
static_assert(MeanRadius<mean_twin>);
struct viscous_twin {
  bridge_resistance<double> resistance(const bridge<double>&, const fluid&) const { return {}; }
};
static_assert(NormalLaw<normal_twin> && DampingLaw<damping_twin> && FrictionLaw<friction_twin>);
static_assert(FrictionLaw<friction_twin_with_memory> && RuptureLaw<rupture_twin>);
static_assert(CapillaryLaw<capillary_twin> && HasCapillaryEnergy<capillary_twin> && CapillaryLaw<prepared_twin>);
static_assert(ViscousBridgeLaw<viscous_twin> && DampingLaw<damping_twin_beside_spring>);
static_assert(DampingLaw<damping_twin_with_memory> && NormalLaw<normal_twin_with_memory>);

// Laws in double only model their concept and are found by the ladder.
namespace narrow = knock_out::in_double_only;
static_assert(NormalLaw<narrow::normal_law> && !detail::repels_in_every_scalar<narrow::normal_law>);
static_assert(DampingLaw<narrow::damping_law> && !detail::resists_in_every_scalar<narrow::damping_law>);
static_assert(DampingLaw<narrow::damping_law_by_its_preparation> &&
              !detail::resists_in_every_scalar<narrow::damping_law_by_its_preparation>);
static_assert(DampingLaw<narrow::damping_law_beside_spring> &&
              !detail::resists_in_every_scalar<narrow::damping_law_beside_spring>);
static_assert(NormalLaw<narrow::normal_law_with_memory> &&
              !detail::repels_in_every_scalar<narrow::normal_law_with_memory>);
static_assert(FrictionLaw<narrow::friction_law> && !detail::rubs_in_every_scalar<narrow::friction_law>);
static_assert(FrictionLaw<narrow::friction_law_with_memory> &&
              !detail::rubs_in_every_scalar<narrow::friction_law_with_memory>);
static_assert(CapillaryLaw<narrow::capillary_law> && !detail::attracts_in_every_scalar<narrow::capillary_law>);
static_assert(CapillaryLaw<narrow::capillary_law_by_its_preparation> &&
              !detail::attracts_in_every_scalar<narrow::capillary_law_by_its_preparation>);
static_assert(RuptureLaw<narrow::rupture_law> && !detail::breaks_in_every_scalar<narrow::rupture_law>);
static_assert(ViscousBridgeLaw<narrow::viscous_bridge_law> &&
              !detail::drags_in_every_scalar<narrow::viscous_bridge_law>);

static_assert(MeanRadius<narrow::mean_radius> && !detail::averages_in_every_scalar<narrow::mean_radius>);

// So are laws that answer with an expression.
namespace loose = knock_out::returns_an_expression;
static_assert(NormalLaw<loose::normal_law> && detail::repels_in_every_scalar<loose::normal_law> &&
              !detail::repels_exactly<loose::normal_law>);
static_assert(DampingLaw<loose::damping_law> && detail::resists_in_every_scalar<loose::damping_law> &&
              !detail::resists_exactly<loose::damping_law>);
static_assert(DampingLaw<loose::damping_law_by_its_preparation> &&
              detail::resists_in_every_scalar<loose::damping_law_by_its_preparation> &&
              !detail::resists_exactly<loose::damping_law_by_its_preparation>);
static_assert(DampingLaw<loose::damping_law_beside_spring> &&
              detail::resists_in_every_scalar<loose::damping_law_beside_spring> &&
              !detail::resists_exactly<loose::damping_law_beside_spring>);
static_assert(FrictionLaw<loose::friction_law> && detail::rubs_in_every_scalar<loose::friction_law> &&
              !detail::rubs_exactly<loose::friction_law>);
static_assert(CapillaryLaw<loose::capillary_law> && detail::attracts_in_every_scalar<loose::capillary_law> &&
              !detail::attracts_exactly<loose::capillary_law>);
static_assert(CapillaryLaw<loose::capillary_law_by_its_preparation> &&
              detail::attracts_in_every_scalar<loose::capillary_law_by_its_preparation> &&
              !detail::attracts_exactly<loose::capillary_law_by_its_preparation>);
static_assert(MeanRadius<loose::mean_radius> && detail::averages_in_every_scalar<loose::mean_radius> &&
              !detail::averages_exactly<loose::mean_radius>);
static_assert(RuptureLaw<loose::rupture_law> && detail::breaks_in_every_scalar<loose::rupture_law> &&
              !detail::breaks_exactly<loose::rupture_law>);

}  // namespace
