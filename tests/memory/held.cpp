// SPDX-License-Identifier: BSD-3-Clause
// The bytes per pair, per grain and per grain at a wall that a composition says are those that a scene holds: a copy of
// it asks for no more memory than what is in its vectors, so that two scenes of which one has more pairs differ by
// theirs.
#include "../catch.hpp"

#include <pendular/law/capillary/willett_closed_form.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/friction/viscous_coulomb.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/rupture/willett.hpp>
#include <pendular/liquid/protocol/grain_films.hpp>
#include <pendular/observe/bytes.hpp>
#include <pendular/system.hpp>

#include <cstddef>
#include <cstdlib>
#include <new>
#include <string_view>

using namespace pendular;

namespace {
std::size_t asked_for = 0;  // bytes, by everybody

void* counted(std::size_t bytes, std::size_t alignment) {
  asked_for += bytes;
  const std::size_t whole = (bytes + alignment) / alignment * alignment;
  if (void* p = std::aligned_alloc(alignment, whole)) return p;
  throw std::bad_alloc{};
}
}  // namespace

void* operator new(std::size_t bytes) { return counted(bytes, alignof(std::max_align_t)); }
// std::stable_sort asks so; sanitizers have one of their own, which would not go with the `delete` below.
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  try {
    return operator new(bytes);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void* operator new(std::size_t bytes, std::align_val_t a) { return counted(bytes, static_cast<std::size_t>(a)); }
// Not inlined, where compilers would warn of `free` for what `new` has made.
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }

namespace {
constexpr double radius = 1e-3;  // m
constexpr run_options unchecked{.skin = 0.3, .force = true};

struct counts {
  int grains, pairs, near_floor;
};

/// Two rows of grains that are far from each other: some of the first have a partner, some of the second a floor.
template <class System>
System filled(System s, const counts& n) {
  const auto put = [&](int k, double y, double z) { s.add({{10 * k * radius, y, z * radius}, radius, 2500}); };
  for (int k = 0; k < n.pairs; ++k) put(k, 0, 10), put(k, 0, 12.05);
  for (int k = 0; k < n.near_floor; ++k) put(k, 1, 1.05);
  for (int k = 0; k < n.grains - 2 * n.pairs - n.near_floor; ++k) put(k, 2, 10);
  s.start();
  if constexpr (System::wet) s.distribute_liquid(1e-13 * n.pairs);
  s.run(2);
  REQUIRE(s.pairs().size() == static_cast<std::size_t>(n.pairs));
  return s;
}

template <class System>
std::size_t held(const System& empty, const counts& n) {
  const System s = filled(empty, n);
  const std::size_t before = asked_for;
  const System copy = s;
  return asked_for - before;
}

template <class System>
void expect_bytes(const System& empty) {
  const std::size_t some = held(empty, {96, 16, 8});
  CHECK(held(empty, {96, 40, 8}) - some == 24 * observe::bytes_per_pair<System> + 3);  // a byte per block of eight
  CHECK(held(empty, {128, 16, 8}) - some == 32 * observe::bytes_per_grain<System>);
  CHECK(held(empty, {96, 16, 24}) - some == 16 * observe::bytes_per_grain_at_wall<System> + 2);
}

const boundary::plane ground{{0, 0, 0}, {0, 0, 1}};
const velocity_verlet integrator{1e-7};
const normal::linear spring{1e3};
const damping::viscous dashpot{0.5};

struct temperature {
  using type = double;
  static constexpr std::string_view label = "temperature", unit = "K";
};
}  // namespace

TEST_CASE("a scene holds the bytes that its composition says") {
  const boundary::walls dry_floor{boundary::wall{ground}};
  expect_bytes(pendular::system{material{spring}, dry_floor, integrator, unchecked});
  expect_bytes(pendular::system{material{spring, dashpot}, dry_floor, integrator, unchecked});
  expect_bytes(pendular::system{material{spring, dashpot, friction::coulomb_spring{800, 0.4}, energy_book{}}, dry_floor,
                                integrator, tags<temperature>{}, unchecked});
}

TEST_CASE("a wet scene holds the bytes that its composition says, at walls that carry bridges, too") {
  const boundary::walls wet_floor{boundary::wall{ground, boundary::fixed{}, none{}, boundary::wettable{}}};
  expect_bytes(pendular::system{
      material{spring, dashpot, friction::viscous_coulomb{1, 0.4}},
      liquid{fluid::water(), capillary::willett_closed_form{}, rupture::willett{}, protocol::grain_films{}}, wet_floor,
      integrator, unchecked});
}
