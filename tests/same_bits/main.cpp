// SPDX-License-Identifier: BSD-3-Clause
// One line per law and scene: its name and a number made of all bits of its results. Built for several instruction sets,
// the program must print the same everywhere. Ends with 77 on a machine without the instructions.
#include "../instruction_set.hpp"
#include "../law/examples.hpp"

#include <pendular/boundary/cylinder.hpp>
#include <pendular/boundary/plane.hpp>
#include <pendular/liquid/protocol/all.hpp>
#include <pendular/observe/energy.hpp>
#include <pendular/system.hpp>
#include <pendular/testing/law_kits.hpp>

#include <boost/hana/for_each.hpp>

#include <bit>
#include <cstdint>
#include <cstdio>
#include <typeinfo>

using namespace pendular;

namespace {

/// FNV-1a over the bytes of what is put in.
class digest {
 public:
  void put(double v) {
    auto bits = std::bit_cast<std::uint64_t>(v);
    for (int byte = 0; byte < 8; ++byte, bits >>= 8) value_ = (value_ ^ (bits & 0xff)) * 1099511628211u;
  }
  void put(const block& v) {
    for (int k = 0; k < lane_count; ++k) put(v[k]);
  }
  void put(const vector& v) { put(v.x), put(v.y), put(v.z); }
  void print(const char* name) const { std::printf("%-50s %016llx\n", name, static_cast<unsigned long long>(value_)); }

 private:
  std::uint64_t value_ = 14695981039346656037u;
};

template <class Samples, class Evaluate>
void digest_law(const char* name, const Samples& samples, const Evaluate& evaluate) {
  digest d;
  for (std::size_t first = 0; first < samples.size(); first += lane_count) {
    d.put(block(evaluate(testing::gathered<block>(samples, first))));
  }
  d.print(name);
}

template <class List, class Use>
void for_each_law(const List& laws, const Use& use) {
  boost::hana::for_each(laws, [&]<class L>(L) { use(examples::of<typename L::type>::value); });
}

void digest_laws() {
  for_each_law(law::normal_laws, []<class L>(const L& law) {
    digest_law(typeid(L).name(), testing::approach_samples(), [&](const auto& a) { return law.repulsion(a); });
  });
  for_each_law(law::damping_laws, []<class L>(const L& law) {
    digest_law(typeid(L).name(), testing::approach_samples(), [&](const auto& a) {
      return resistance(law, a, elastic<block>{block(1e3) * max(block(-a.gap), block(0)), block(1e3)});
    });
  });
  for_each_law(law::capillary_laws, []<class L>(const L& law) {
    digest_law(typeid(L).name(), testing::bridge_samples(validity_of<L>()),
               [&](const auto& b) { return testing::pull(law, b, examples::tilted_water); });
  });
  for_each_law(law::rupture_laws, []<class L>(const L& law) {
    digest_law(typeid(L).name(), testing::bridge_samples(validity_of<L>()),
               [&](const auto& b) { return law.distance(b, examples::tilted_water); });
  });
}

template <class System>
void digest_scene(const char* name, System s) {
  std::uint64_t state = 88172645463325252u;
  const auto random = [&] {
    state ^= state << 13, state ^= state >> 7, state ^= state << 17;
    return static_cast<double>(state >> 11) * 0x1p-52 - 1;
  };
  constexpr int edge = 5;
  constexpr double spacing = 1.05e-3;
  for (int k = 0; k < edge * edge * edge; ++k) {
    const vector place{k % edge - 2.0, k / edge % edge - 2.0, k / (edge * edge) + 0.6};
    s.add({spacing * place, 0.5e-3 * (1 + 0.05 * random()), 2600, 0.2 * vector{random(), random(), random()}});
  }
  if constexpr (System::wet) s.distribute_liquid(4e-10);
  s.run(2500);
  digest d;
  for (const std::size_t row : s.particles().rows_by_id()) {
    d.put(s.particles().template get<column::position>()[row]);
    d.put(s.particles().template get<column::velocity>()[row]);
    d.put(s.particles().template get<column::force>()[row]);
  }
  const auto e = observe::energies_of(s);
  d.put(e.balance()), d.put(e.friction), d.put(e.damping);
  s.for_each_wall([&](const auto& wall, const auto&) { d.put(wall.force); });
  if constexpr (System::wet) {
    d.put(static_cast<double>(s.events().ruptures)), d.put(static_cast<double>(s.events().formations));
    std::fprintf(stderr, "%s: %ld ruptures\n", name, static_cast<long>(s.events().ruptures));
  }
  d.print(name);
}

void digest_scenes() {
  using boundary::wall;
  const auto can = boundary::walls{wall{boundary::plane{{0, 0, 0}, {0, 0, 1}}},
                                   wall{boundary::cylinder{{0, 0, 0}, {0, 0, 1}, 4e-3}}};
  const half_step_velocity_verlet half_step{2e-6, {0, 0, -9.81}};
  const velocity_verlet verlet{2e-6, {0, 0, -9.81}};
  const run_options forced{.force = true};
  const material rubbing{normal::linear{1e3}, damping::viscous{0.3}, friction::coulomb_spring{800, 0.4}, energy_book{}};
  const material creeping{normal::hertz{1e8, 0.22}, damping::viscous{0.3}, friction::viscous_coulomb{1, 0.4},
                          energy_book{}};
  digest_scene("dry, spring", pendular::system{rubbing, can, verlet, forced});
  digest_scene("wet, spring",
               pendular::system{rubbing,
                                liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, protocol::grain_films{}},
                                can, verlet, forced});
  digest_scene("wet, Hertz, Eq. 12",
               pendular::system{
                   creeping, liquid{fluid::water(), capillary::willett{}, rupture::willett{}, protocol::neighbours{}},
                   can, half_step, forced});
}

}  // namespace

int main() {
  if (!has_instructions_of_build()) return not_on_this_machine;
  digest_laws();
  digest_scenes();
}
