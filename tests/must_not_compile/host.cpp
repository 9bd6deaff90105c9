// SPDX-License-Identifier: BSD-3-Clause
// expect 1: a host must be copyable: make it a handle of what the parts of a scene share
// expect 2: a host needs `void update_copies(std::span<double> numbers, std::size_t width) const`
// expect 3: a host needs `bool any(bool) const`, `double most(double) const` and `bool leads() const`
// expect 4: a host needs `void sum(std::span<reproducible_sum>) const`
// expect 5: a host of a system says who keeps a grain
// expect 6: a host of a system carries grains
// expect 7: a host of a system is told rows
// expect 8: what a protocol's `settle` answers is sent to other parts of the scene and must be trivially copyable
// expect 9: observers look at a scene in one piece
// expect 10: a checkpoint keeps a scene in one piece, not a part of it
#include <pendular/core/host_check.hpp>
#include <pendular/io/system_state.hpp>
#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/observe/coordination.hpp>
#include <pendular/parts.hpp>
#include <pendular/testing/host_archetypes.hpp>

#include <vector>

using namespace pendular;
namespace knock_out = pendular::testing::knock_out;

#if PENDULAR_MISTAKE == 1
using mine = knock_out::host::not_copyable;
#elif PENDULAR_MISTAKE == 2
using mine = knock_out::host::without_update;
#elif PENDULAR_MISTAKE == 3
using mine = knock_out::host::without_most;
#elif PENDULAR_MISTAKE == 4
using mine = knock_out::host::sums_doubles;
#elif PENDULAR_MISTAKE == 5
using mine = knock_out::host::without_keeper;
#elif PENDULAR_MISTAKE == 6
using mine = knock_out::host::exchanges_without_count;
#elif PENDULAR_MISTAKE == 7
using mine = knock_out::host::knows_no_rows;
#else
using mine = testing::archetype::distributing_host;
#endif
static_assert(check::distributing_host<mine>);

struct by_lot {
#if PENDULAR_MISTAKE == 8
  using grant = std::vector<double>;
#else
  using grant = double;
#endif
  double offer(const bond_side&) const { return 1; }
  double merge(double a, double b) const { return a + b; }
  grant settle(double, double) const { return {}; }
  double pull(const bond_side&, const grant&) const { return 0; }
};

template <class H>
void run(const H& host) {
  pendular::system s{material{normal::linear{1e3}},
                     liquid{fluid::water(), capillary::richefeu{}, rupture::lian{}, by_lot{}}, boundary::walls{},
                     velocity_verlet{1e-6}, run_on{host}};
  s.run(1);
#if PENDULAR_MISTAKE == 9
  (void)observe::coordination_of(s);
#elif PENDULAR_MISTAKE == 10
  io::checkpoint_writer out("checkpoint");
  io::save(out, s);
#endif
}

int main() {
#if !defined(PENDULAR_MISTAKE) || PENDULAR_MISTAKE >= 8
  run(mine(0));
#endif
}
