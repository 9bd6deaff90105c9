// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// For a system that is one of several parts of a scene: docs/reference/host.md.
#include <pendular/boundary/luggage.hpp>
#include <pendular/core/host_check.hpp>
#include <pendular/motion/run_options.hpp>
#include <pendular/space/copies.hpp>
#include <pendular/system.hpp>

namespace pendular {

/// Options of a system that is one part of a scene: run_on{host}, or run_on{host, {.skin = 0.2}}.
template <class H>
struct run_on : run_options {
  static_assert(check::distributing_host<H>);
  H host;
  explicit run_on(const H& h, const run_options& numbers = {}) : run_options(numbers), host(h) {}
};

template <class... M, LiquidOrNone L, class Boundary, class Integration, class H>
system(const material<M...>&, const L&, const Boundary&, const Integration&, const run_on<H>&)
    -> system<material<M...>, L, Boundary, Integration, H>;
template <class... M, class Boundary, class Integration, class H>
system(const material<M...>&, const Boundary&, const Integration&, const run_on<H>&)
    -> system<material<M...>, dry, Boundary, Integration, H>;
template <class... M, LiquidOrNone L, class Boundary, class Integration, class... Tags, class H>
system(const material<M...>&, const L&, const Boundary&, const Integration&, tags<Tags...>, const run_on<H>&)
    -> system<material<M...>, L, Boundary, Integration, H, Tags...>;
template <class... M, class Boundary, class Integration, class... Tags, class H>
system(const material<M...>&, const Boundary&, const Integration&, tags<Tags...>, const run_on<H>&)
    -> system<material<M...>, dry, Boundary, Integration, H, Tags...>;

}  // namespace pendular
