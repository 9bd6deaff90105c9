// SPDX-License-Identifier: BSD-3-Clause
// Every shipped law models its concept, climbs its ladder and weighs no more than its parameters.
#include <pendular/law/all.hpp>
#include <pendular/law/check.hpp>

#include <boost/hana/unpack.hpp>

#include <type_traits>

namespace hana = boost::hana;
using namespace pendular;

namespace {

template <class Law>
inline constexpr bool plain =
    std::is_aggregate_v<Law>&& std::is_trivially_copyable_v<Law>&& std::is_standard_layout_v<Law>;

template <class List, class Predicate>
consteval bool all(List laws, Predicate holds) {
  return hana::unpack(laws, [holds](auto... law) { return (holds(law) && ...); });
}
template <class Type>
using type_of = typename Type::type;

static_assert(all(law::normal_laws, []<class L>(L) {
  return NormalLaw<type_of<L>> && plain<type_of<L>> && check::normal_law<type_of<L>>;
}));
static_assert(all(law::damping_laws, []<class L>(L) {
  return DampingLaw<type_of<L>> && plain<type_of<L>> && check::damping_law<type_of<L>>;
}));
static_assert(all(law::friction_laws, []<class L>(L) {
  return FrictionLaw<type_of<L>> && plain<type_of<L>> && check::friction_law<type_of<L>>;
}));
static_assert(all(law::capillary_laws, []<class L>(L) {
  return CapillaryLaw<type_of<L>> && plain<type_of<L>> && check::capillary_law<type_of<L>>;
}));
static_assert(all(law::rupture_laws, []<class L>(L) {
  return RuptureLaw<type_of<L>> && plain<type_of<L>> && check::rupture_law<type_of<L>>;
}));

static_assert(all(law::mean_radii, []<class L>(L) {
  return MeanRadius<type_of<L>> && std::is_empty_v<type_of<L>> && check::mean_radius<type_of<L>>;
}));
static_assert(all(law::viscous_bridge_laws, []<class L>(L) {
  return ViscousBridgeLaw<type_of<L>> && plain<type_of<L>> && check::viscous_bridge_law<type_of<L>>;
}));

static_assert(sizeof(normal::linear) == 8 && sizeof(normal::hertz) == 16);
static_assert(sizeof(damping::viscous) == 8 && sizeof(damping::viscous_on_approach) == 8);
static_assert(sizeof(friction::viscous_coulomb) == 16 && sizeof(friction::viscous_coulomb_explicit) == 16);
static_assert(sizeof(friction::coulomb_spring) == 16);
static_assert(sizeof(capillary::richefeu) == 8 && sizeof(capillary::richefeu_harmonic) == 8);
static_assert(std::is_empty_v<rupture::lian> && std::is_empty_v<rupture::willett> && std::is_empty_v<none>);

// What is kept per contact and per bond.
static_assert(sizeof(contact_memory_t<friction::coulomb_spring, double>) == 24);
static_assert(sizeof(contact_memory_t<friction::viscous_coulomb, float>) == 12);
static_assert(std::is_empty_v<contact_memory_t<friction::viscous_coulomb_explicit, double>>);
static_assert(std::is_empty_v<contact_memory_t<none, double>>);
static_assert(sizeof(capillary::richefeu::coefficients<double>) == 16);

static_assert(HasCapillaryEnergy<capillary::richefeu> && HasCapillaryEnergy<capillary::richefeu_harmonic>);

// The null policy plays no role.
static_assert(!NormalLaw<none> && !DampingLaw<none> && !FrictionLaw<none> && !CapillaryLaw<none> && !RuptureLaw<none> &&
              !ViscousBridgeLaw<none>);

// No law plays two roles, so that a bundle may take them in any order.
constexpr auto plays_one_role = []<class L>(L) {
  using law = type_of<L>;
  return NormalLaw<law> + DampingLaw<law> + FrictionLaw<law> + CapillaryLaw<law> + RuptureLaw<law> +
             ViscousBridgeLaw<law> ==
         1;
};
static_assert(all(law::normal_laws, plays_one_role) && all(law::damping_laws, plays_one_role));
static_assert(all(law::friction_laws, plays_one_role) && all(law::capillary_laws, plays_one_role));
static_assert(all(law::rupture_laws, plays_one_role) && all(law::viscous_bridge_laws, plays_one_role));

static_assert(fluid::water().surface_tension == 0.0728 && fluid::water().contact_angle == 0);

}  // namespace
