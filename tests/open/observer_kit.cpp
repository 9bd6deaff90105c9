// SPDX-License-Identifier: BSD-3-Clause
// Observers keep their promises, and the kit finds one that does not.
#include "../found.hpp"

#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/system.hpp>
#include <pendular/testing/observer.hpp>
#include <pendular/testing/role_archetypes.hpp>

#include <map>
#include <stdexcept>

using namespace pendular;
using testing::observer_report;

namespace {
/// Two wet grains that fly apart, so that their bridge breaks.
auto parting_pair() {
  pendular::system s{material{normal::linear{1e3}}, liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}},
                     boundary::walls{}, velocity_verlet{1e-6}};
  s.add({.position = {0, 0, 0}, .radius = 0.5e-3, .density = 2600});
  s.add({.position = {1.0001e-3, 0, 0}, .radius = 0.5e-3, .density = 2600, .velocity = {1, 0, 0}});
  s.distribute_liquid(1e-12);
  return s;
}
using scene = decltype(parting_pair());

struct watcher {
  enum class mistake { none, never, hasty, afraid, meddles } made;
  std::int64_t period = made == mistake::never ? 0 : 10;
  int events = 0;
  void operator()(const scene& s) {
    if (made == mistake::hasty) throw std::runtime_error("no grain is at rest");
    if (made == mistake::meddles) const_cast<scene&>(s).particles().get<column::velocity>()[0].x += 1e-6;
  }
  void notice(const bridge_event& e) {
    if (made == mistake::afraid && e.what == bridge_change::broke) throw std::runtime_error("a bridge broke");
    ++events;
  }
};
}  // namespace

TEST_CASE("observers keep their promises, and the kit finds a broken one") {
  const scene s = parting_pair();
  check_sound(observer_report(null_observer{}, s));
  check_sound(observer_report(every{7, [](const auto& seen) { (void)seen.time(); }}, s));
  std::int64_t count = 0;
  check_sound(observer_report(testing::archetype::observer(count), s, 300));
  CHECK(count == 300);
  using enum watcher::mistake;
  const auto of = [&](auto made) { return observer_report(watcher{made}, s, 300); };
  check_sound(of(none));
  CHECK(finds(of(never), "the period must be at least 1"));
  CHECK(finds(of(hasty), "an observer of a sound scene must not throw (no grain is at rest)"));
  CHECK(finds(of(afraid), "an observer of a sound scene must not throw (a bridge broke)"));
  CHECK(finds(of(meddles), "being watched must not change a bit"));
}
