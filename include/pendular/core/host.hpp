// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/copyable.hpp>
#include <pendular/core/expects.hpp>
#include <pendular/core/reproducible_sum.hpp>
#include <pendular/core/vec.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <span>
#include <vector>

namespace pendular {

// A scene may be one of several parts that run side by side: in threads, or as ranks of a distributed run. Every part keeps
// some of the grains, rows [0, kept), and has copies of those that are near them. It lists all pairs of the grains it keeps;
// a pair of a kept grain and a copy is evaluated on both sides, with the same bits. A grain is summed, moved and its film
// kept by its keeper alone, so numbers only go from keepers to copies, and every sum over the scene is exact: the results
// are those of a scene in one piece, to the last bit. All parts make the same calls in the same order.

/// What the parts of a scene tell each other. A host is a handle that is copied.
template <class H>
concept Host = Copyable<H> && requires(const H host, std::span<double> numbers, std::size_t width, bool flag,
                                       std::span<reproducible_sum> sums, double value) {
  // Of every copy, `width` numbers in its row become those of its keeper.
  host.update_copies(numbers, width);
  // Whether it is so on any part.
  { host.any(flag) } -> std::convertible_to<bool>;
  // Every sum becomes that over all parts.
  host.sum(sums);
  // The largest on any part.
  { host.most(value) } -> std::convertible_to<double>;
  // True on one of the parts: what belongs to the scene as a whole is counted there.
  { host.leads() } -> std::convertible_to<bool>;
};

/// A grain on its way from one part to another, with all that the rows of its contacts remember.
struct parcel {
  std::int64_t id;
  vector position;              // m
  double radius;                // m
  std::vector<double> numbers;  // for the part that takes it; of copies too
};

/// A host that also says who keeps a grain, and carries grains there.
template <class H>
concept DistributingHost = Host<H> && requires(const H host, const vector& position, std::vector<parcel>& parcels,
                                               double reach, std::span<const std::int64_t> ids, std::size_t kept) {
  // Whether a grain at this position is kept here; so on exactly one part.
  { host.keeps(position) } -> std::convertible_to<bool>;
  // From the grains that were kept here to those that are from now on. Answers how many; after them come copies of all
  // others whose centre is within `reach`, m, of that of a kept one, or of more.
  { host.exchange(parcels, reach) } -> std::convertible_to<std::size_t>;
  // In which rows these grains are now stored.
  host.know_rows(ids, kept);
};

/// The scene in one piece.
struct alone {
  void update_copies(std::span<double>, std::size_t) const {}
  bool any(bool flag) const { return flag; }
  void sum(std::span<reproducible_sum>) const {}
  double most(double value) const { return value; }
  bool leads() const { return true; }
};

template <class H>
inline constexpr bool is_distributed = !std::same_as<H, alone>;

namespace detail {
/// Another part has thrown while this one was in the middle of a check.
struct seen_stop {};

[[noreturn]] inline void throw_stopped() {
  throw run_error("another part of the scene has stopped (see docs/reference/host.md)");
}
}  // namespace detail

/// Within a check, before the parts tell each other something: those that come to it stop if another one has thrown, which
/// else would never come.
template <Host H>
void expect_all_go_on(const H& host) {
  if constexpr (is_distributed<H>) {
    if (host.any(false)) throw detail::seen_stop{};
  }
}

/// A check that may throw on some parts; if it does on one, all stop.
template <Host H, class Check>
void together(const H& host, const Check& check) {
  if constexpr (!is_distributed<H>) {
    check();
  } else {
    std::exception_ptr thrown;
    try {
      check();
    } catch (const detail::seen_stop&) {
      detail::throw_stopped();
    } catch (...) {
      thrown = std::current_exception();
    }
    if (!host.any(thrown != nullptr)) return;
    if (thrown) std::rethrow_exception(thrown);
    detail::throw_stopped();
  }
}

/// One sum over all parts.
template <Host H>
double total(const H& host, reproducible_sum here) {
  host.sum(std::span(&here, 1));
  return here.value();
}

}  // namespace pendular
