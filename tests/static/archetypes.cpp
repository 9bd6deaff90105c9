// SPDX-License-Identifier: BSD-3-Clause
// The concepts accept the least they ask for.
#include <pendular/law/check.hpp>
#include <pendular/law/damping/viscous_on_approach.hpp>
#include <pendular/law/prepared.hpp>
#include <pendular/law/stiffness.hpp>
#include <pendular/testing/archetypes.hpp>

#include <concepts>

using namespace pendular;
using namespace pendular::testing;

namespace {

static_assert(check::normal_law<archetype::normal_law> && NormalLaw<archetype::normal_law>);
static_assert(check::damping_law<archetype::damping_law> && DampingLaw<archetype::damping_law>);
static_assert(check::damping_law<archetype::damping_law_beside_spring>);
static_assert(check::damping_law<archetype::damping_law_with_memory>);
static_assert(check::normal_law<archetype::normal_law_with_memory>);
static_assert(check::friction_law<archetype::friction_law> && FrictionLaw<archetype::friction_law>);
static_assert(check::friction_law<archetype::friction_law_with_memory>);
static_assert(FrictionLaw<archetype::friction_law_with_memory>);
static_assert(check::capillary_law<archetype::capillary_law> && CapillaryLaw<archetype::capillary_law>);
static_assert(check::capillary_law<archetype::prepared_capillary_law>);
static_assert(CapillaryLaw<archetype::prepared_capillary_law>);
static_assert(check::rupture_law<archetype::rupture_law> && RuptureLaw<archetype::rupture_law>);
static_assert(check::mean_radius<archetype::mean_radius> && MeanRadius<archetype::mean_radius>);
static_assert(check::viscous_bridge_law<archetype::viscous_bridge_law>);
static_assert(ViscousBridgeLaw<archetype::viscous_bridge_law>);

// Each offers one form only, and nothing optional.
static_assert(!detail::Prepares<archetype::capillary_law, double> &&
              !detail::Attracts<archetype::prepared_capillary_law, double>);
static_assert(!HasCapillaryEnergy<archetype::capillary_law> && !HasCapillaryEnergy<archetype::prepared_capillary_law>);
static_assert(!detail::KnowsStiffness<archetype::normal_law, double>);

template <class Law>
inline constexpr bool bare = !std::default_initializable<Law> && !std::equality_comparable<Law>;
static_assert(bare<archetype::normal_law> && bare<archetype::damping_law> && bare<archetype::friction_law>);
static_assert(bare<archetype::friction_law_with_memory> && bare<archetype::capillary_law>);
static_assert(bare<archetype::prepared_capillary_law> && bare<archetype::rupture_law>);
static_assert(bare<archetype::viscous_bridge_law> && bare<archetype::damping_law_beside_spring>);
static_assert(bare<archetype::damping_law_with_memory> && bare<archetype::normal_law_with_memory>);

// A second argument of any type takes a stiffness, and is handed one.
static_assert(!detail::ResistsBeside<damping::viscous_on_approach, double> &&
              !detail::ResistsBeside<archetype::damping_law, double> &&
              detail::ResistsBeside<archetype::damping_law_beside_spring, double>);

// The adapters must compile with no more than that.
[[maybe_unused]] double adapted(const archetype::normal_law& normal, const archetype::capillary_law& simple,
                                const archetype::prepared_capillary_law& prepared, const bridge<double>& b,
                                const fluid& f) {
  const double slopes =
      stiffness(normal, approach<double>{b.gap, 0, 1, 1, 1}) + slope(simple, b, f) + slope(prepared, b, f);
  return slopes + attraction(simple, b.gap, prepare(simple, b, f), f) +
         attraction(prepared, b.gap, prepare(prepared, b, f), f);
}

}  // namespace
