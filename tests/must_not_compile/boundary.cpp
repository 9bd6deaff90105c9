// SPDX-License-Identifier: BSD-3-Clause
// expect 1: or a boundary of your own with `auto parts()` and `auto parts() const`, which return std::tie(all its walls)
// expect 2: or a boundary of your own with `auto parts()` and `auto parts() const`, which return std::tie(all its walls)
// expect 3: parts of a boundary must be its walls themselves, the same in `parts()` and `parts() const`, and not copies
// expect 4: parts of a boundary must be its walls themselves, the same in `parts()` and `parts() const`, and not copies
// expect 5: a part of a boundary must be a wall, with the members `shape` and `drive` of boundary::wall
// expect 6: a wall needs a member `material`, none{} for that of the grains, and `static constexpr bool is_wettable`
// expect 7: a wall needs the members `vector force` and `double work`, and `double approach_speed() const`
// expect 8: a wall needs `void move(double time_step)` and `void take(const boundary::wall_load&, double time_step)`
// expect 9: the members of a wall must have the types of those of boundary::wall
// expect 10: a boundary must be copyable
// expect 11: a wall must be copyable
#include <pendular/boundary/wall.hpp>
#if !defined(PENDULAR_MISTAKE)
#include <pendular/law/normal/linear.hpp>
#include <pendular/system.hpp>
#endif

#include <memory>
#include <tuple>

using namespace pendular;

struct lid {
#if PENDULAR_MISTAKE != 6
  static constexpr bool is_wettable = false;
#endif
  boundary::plane shape;
  boundary::fixed drive;
  none material;
  vector force{0, 0, 0};
#if PENDULAR_MISTAKE == 9
  vector work{0, 0, 0};
#else
  double work = 0;
#endif
#if PENDULAR_MISTAKE == 11
  std::unique_ptr<double> hardest = nullptr;
#endif
#if PENDULAR_MISTAKE != 7
  double approach_speed() const { return 0; }
#endif
  void move(double) {}
#if PENDULAR_MISTAKE != 8
  void take(const boundary::wall_load& now, double) { force = now.force; }
#endif
};

static_assert(check::wall<lid>);

struct room {
#if PENDULAR_MISTAKE == 5
  boundary::plane floor;
#else
  boundary::wall<boundary::plane> floor;
#endif
  lid top;
#if PENDULAR_MISTAKE == 10
  std::unique_ptr<double> height = nullptr;
#endif

#if PENDULAR_MISTAKE == 1
  auto walls() { return std::tie(floor, top); }
#elif PENDULAR_MISTAKE == 2
  auto parts() { return std::tie(floor, top); }
#elif PENDULAR_MISTAKE == 3
  auto parts() { return std::tuple(floor, top); }
  auto parts() const { return std::tuple(floor, top); }
#elif PENDULAR_MISTAKE == 4
  auto parts() { return std::tie(floor, top); }
  auto parts() const { return std::tie(top, floor); }
#else
  auto parts() { return std::tie(floor, top); }
  auto parts() const { return std::tie(floor, top); }
#endif
};

static_assert(check::boundary<room>);

#if !defined(PENDULAR_MISTAKE)
std::int64_t grains_in(const room& r) {
  pendular::system scene{material{normal::linear{1e3}}, r, velocity_verlet{1e-6}};
  scene.run(10);
  return scene.step_count();
}
#endif
