// SPDX-License-Identifier: BSD-3-Clause
// expect 1: an observer is called with `const system&`, or has a `notice(const bridge_event&)`, or both
// expect 2: an observer looks at a scene and does not change it: take the system by a reference to const
// expect 3: the period of an observer is a number of steps
#include <pendular/motion/check.hpp>

#include <string>

using namespace pendular;

struct scene {
  double time() const { return 0; }
};

struct clock_reader {
#if PENDULAR_MISTAKE == 3
  std::string period = "10 s";
#else
  std::int64_t period = 10;
#endif
  double last = 0;

#if PENDULAR_MISTAKE == 1
  void operator()(double time) { last = time; }
#elif PENDULAR_MISTAKE == 2
  void operator()(scene& s) { last = s.time(); }
#else
  void operator()(const scene& s) { last = s.time(); }
#endif
};

static_assert(check::observer<clock_reader, scene> && check::observer<null_observer, scene>);
