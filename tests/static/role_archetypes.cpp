// SPDX-License-Identifier: BSD-3-Clause
// The concepts of roles that are no laws accept the least they ask for, and a system can be made of it.
#include <pendular/boundary/check.hpp>
#include <pendular/liquid/check.hpp>
#include <pendular/motion/check.hpp>
#include <pendular/space/check.hpp>
#include <pendular/system.hpp>
#include <pendular/testing/archetypes.hpp>
#include <pendular/testing/role_archetypes.hpp>

#include <concepts>

using namespace pendular;
namespace archetype = pendular::testing::archetype;

namespace {

static_assert(check::integrator<archetype::integrator> && check::geometry<archetype::geometry>);
static_assert(check::drive<archetype::drive, archetype::geometry>);
static_assert(check::drive<archetype::drive_of_points, archetype::geometry>);
static_assert(check::wall<archetype::wall<archetype::drive>> && check::boundary<archetype::boundary_of_two>);
static_assert(check::formation_rule<archetype::formation_rule>);
static_assert(check::local_protocol<archetype::local_protocol> && check::global_protocol<archetype::global_protocol>);
static_assert(check::source<archetype::source> && check::grain_tag<archetype::grain_tag>);
static_assert(check::observer<archetype::observer, int>);

template <class Model>
inline constexpr bool bare = !std::default_initializable<Model> && !std::equality_comparable<Model>;
static_assert(bare<archetype::integrator> && bare<archetype::geometry> && bare<archetype::drive>);
static_assert(bare<archetype::drive_of_points> && bare<archetype::boundary_of_two> && bare<archetype::formation_rule>);
static_assert(bare<archetype::local_protocol> && bare<archetype::global_protocol> && bare<archetype::source>);
static_assert(bare<archetype::local_protocol::grant> && bare<archetype::observer>);

template <class Protocol>
std::int64_t looks_at_a_scene_of(const Protocol& protocol) {
  pendular::system s{material{archetype::normal_law(1e3), archetype::friction_law(0.4)},
                     liquid{fluid::water(), archetype::capillary_law(1), archetype::rupture_law(1), protocol,
                            archetype::formation_rule(1e-6), archetype::source(10)},
                     archetype::boundary_of_two(0), archetype::integrator(1e-6, {0, 0, -9.81}),
                     tags<archetype::grain_tag>{}};
  s.add({.position = {0, 0, 1e-3}, .radius = 0.5e-3, .density = 2600});
  std::int64_t count = 0;
  archetype::observer looking(count);
  s.run(10, looking);
  return count;
}
[[maybe_unused]] std::int64_t looks() {
  return looks_at_a_scene_of(archetype::local_protocol(0.5)) + looks_at_a_scene_of(archetype::global_protocol(5));
}

}  // namespace
