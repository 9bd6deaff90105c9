// SPDX-License-Identifier: BSD-3-Clause
// expect 1: a formation rule must be copyable
// expect 2: a formation rule needs `double reach(double rupture_distance) const`
// expect 3: a formation rule needs a member `double minimum_volume`
// expect 4: a local protocol needs `offer(const bond_side&) const`
// expect 5: a local protocol needs `merge(a, b) const`, which makes one offer of two
// expect 6: a local protocol needs `settle(offer, double film) const`
// expect 7: a local protocol needs `double pull(const bond_side&, grant) const`
// expect 8: a global protocol needs a member `std::int64_t period`
// expect 9: a global protocol needs `template <class Door> void redistribute(Door& door) const`
// expect 10: a source needs a member `std::int64_t period`
// expect 11: a source needs `static constexpr std::string_view account`
// expect 12: a source needs `template <class Door> void act(Door& door) const`
// expect 13: a source must be copyable
// expect 14: a protocol must be copyable
// expect 15: a protocol must be copyable
#include <pendular/liquid/check.hpp>

#include <memory>
#include <string_view>

using namespace pendular;

struct early {
#if PENDULAR_MISTAKE == 1
  std::unique_ptr<double> table = nullptr;
#endif
#if PENDULAR_MISTAKE != 3
  double minimum_volume = 1e-4;
#endif
#if PENDULAR_MISTAKE == 2
  double reach(double rupture_distance) { return 0.1 * rupture_distance; }
#else
  double reach(double rupture_distance) const { return 0.1 * rupture_distance; }
#endif
};
static_assert(check::formation_rule<early>);

struct equal_shares {
#if PENDULAR_MISTAKE == 14
  std::unique_ptr<double> table = nullptr;
#endif
#if PENDULAR_MISTAKE == 4
  double offer(std::int64_t) const { return 1; }
#else
  double offer(const bond_side&) const { return 1; }
#endif
#if PENDULAR_MISTAKE == 5
  void merge(double, double) const {}
#else
  double merge(double a, double b) const { return a + b; }
#endif
#if PENDULAR_MISTAKE == 6
  double settle(double bonds) const { return 1 / bonds; }
#else
  double settle(double bonds, double film) const { return film / bonds; }
#endif
#if PENDULAR_MISTAKE == 7
  void pull(const bond_side&, double) const {}
#else
  double pull(const bond_side&, double grant) const { return grant; }
#endif
};
static_assert(check::local_protocol<equal_shares>);

struct drain_all {
#if PENDULAR_MISTAKE == 15
  std::unique_ptr<double> table = nullptr;
#endif
#if PENDULAR_MISTAKE != 8
  std::int64_t period = 10;
#endif
#if PENDULAR_MISTAKE == 9
  void redistribute(double) const {}
#else
  template <class Door>
  void redistribute(Door& door) const {
    door.for_each_bridge([&](std::size_t pair) { door.break_bridge(pair); });
  }
#endif
};
static_assert(check::global_protocol<drain_all>);

struct pump {
#if PENDULAR_MISTAKE == 13
  std::unique_ptr<double> table = nullptr;
#endif
#if PENDULAR_MISTAKE != 11
  static constexpr std::string_view account = "pump";
#endif
#if PENDULAR_MISTAKE != 10
  std::int64_t period = 10;
#endif
#if PENDULAR_MISTAKE == 12
  void act() const {}
#else
  template <class Door>
  void act(Door& door) const {
    door.for_each_bridge([&](std::size_t pair) { door.drain_bridge(pair, 0); });
  }
#endif
};
static_assert(check::source<pump>);
