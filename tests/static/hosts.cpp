// SPDX-License-Identifier: BSD-3-Clause
// Every knock-out of a host breaks one clause and must be refused; the archetypes, which are them mended, are accepted.
#include "none_of.hpp"

#include <pendular/core/host_check.hpp>
#include <pendular/testing/host_archetypes.hpp>

#include <boost/hana/unpack.hpp>

namespace hana = boost::hana;
using namespace pendular;
namespace knock_out = pendular::testing::knock_out;
namespace archetype = pendular::testing::archetype;

namespace {
static_assert(none_of(knock_out::hosts, []<class H>(H) { return Host<type_of<H>>; }));
static_assert(none_of(knock_out::distributing_hosts, []<class H>(H) { return DistributingHost<type_of<H>>; }));
static_assert(hana::unpack(knock_out::distributing_hosts, []<class... H>(H...) { return (Host<type_of<H>> && ...); }));

static_assert(Host<alone> && !DistributingHost<alone> && !is_distributed<alone>);
static_assert(Host<archetype::host> && !DistributingHost<archetype::host> && is_distributed<archetype::host>);
static_assert(DistributingHost<archetype::distributing_host>);
static_assert(check::host<alone> && check::host<archetype::host> &&
              check::distributing_host<archetype::distributing_host>);
}  // namespace
