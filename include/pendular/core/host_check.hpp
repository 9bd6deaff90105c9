// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/copyable.hpp>
#include <pendular/core/host.hpp>
#include <pendular/core/never.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pendular::check {

// A ladder as those of laws (law/check.hpp): true, or one sentence for the first clause that is broken.

namespace detail {
using namespace pendular::detail;

template <class H>
concept UpdatesCopies = requires(const H host, std::span<double> numbers, std::size_t width) {
  host.update_copies(numbers, width);
};
template <class H>
concept AsksAll = requires(const H host, bool flag, double value) {
  { host.any(flag) } -> std::convertible_to<bool>;
  { host.most(value) } -> std::convertible_to<double>;
  { host.leads() } -> std::convertible_to<bool>;
};
template <class H>
concept AddsUp = requires(const H host, std::span<reproducible_sum> sums) {
  host.sum(sums);
};
template <class H>
concept KeepsGrains = requires(const H host, const vector& position) {
  { host.keeps(position) } -> std::convertible_to<bool>;
};
template <class H>
concept CarriesGrains = requires(const H host, std::vector<parcel>& parcels, double reach) {
  { host.exchange(parcels, reach) } -> std::convertible_to<std::size_t>;
};
template <class H>
concept KnowsRows = requires(const H host, std::span<const std::int64_t> ids, std::size_t kept) {
  host.know_rows(ids, kept);
};
}  // namespace detail

template <class H>
consteval bool is_host() {
  if constexpr (!Copyable<H>) {
    static_assert(detail::never<H>, "a host must be copyable: make it a handle of what the parts of a scene share "
                                    "(docs/reference/host.md)");
  } else if constexpr (!detail::UpdatesCopies<H>) {
    static_assert(detail::never<H>,
                  "a host needs `void update_copies(std::span<double> numbers, std::size_t width) const` "
                  "(docs/reference/host.md)");
  } else if constexpr (!detail::AsksAll<H>) {
    static_assert(detail::never<H>, "a host needs `bool any(bool) const`, `double most(double) const` and `bool "
                                    "leads() const` (docs/reference/host.md)");
  } else if constexpr (!detail::AddsUp<H>) {
    static_assert(detail::never<H>,
                  "a host needs `void sum(std::span<reproducible_sum>) const` (docs/reference/host.md)");
  }
  return true;
}

template <class H>
inline constexpr bool host = is_host<H>();

template <class H>
consteval bool is_distributing_host() {
  if constexpr (!Host<H>) {
    static_assert(host<H>);
  } else if constexpr (!detail::KeepsGrains<H>) {
    static_assert(detail::never<H>,
                  "a host of a system says who keeps a grain: `bool keeps(const vector& position) const` "
                  "(docs/reference/host.md)");
  } else if constexpr (!detail::CarriesGrains<H>) {
    static_assert(
        detail::never<H>,
        "a host of a system carries grains: `std::size_t exchange(std::vector<parcel>&, double reach) const`, "
        "which answers how many are kept (docs/reference/host.md)");
  } else if constexpr (!detail::KnowsRows<H>) {
    static_assert(
        detail::never<H>,
        "a host of a system is told rows: `void know_rows(std::span<const std::int64_t> ids, std::size_t kept) "
        "const` (docs/reference/host.md)");
  }
  return true;
}

template <class H>
inline constexpr bool distributing_host = is_distributing_host<H>();

}  // namespace pendular::check
