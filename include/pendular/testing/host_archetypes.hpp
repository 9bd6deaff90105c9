// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/host.hpp>

#include <boost/hana/tuple.hpp>
#include <boost/hana/type.hpp>

namespace pendular::testing {

namespace archetype {
/// The least that a host is; it is the only part.
class host {
 public:
  explicit host(int) {}
  void update_copies(std::span<double>, std::size_t) const {}
  bool any(bool flag) const { return flag; }
  void sum(std::span<reproducible_sum>) const {}
  double most(double value) const { return value; }
  bool leads() const { return true; }
};
/// The least that a host of a system is.
class distributing_host : public host {
 public:
  explicit distributing_host(int) : host(0) {}
  bool keeps(const vector&) const { return true; }
  std::size_t exchange(std::vector<parcel>& parcels, double) const { return parcels.size(); }
  void know_rows(std::span<const std::int64_t>, std::size_t) const {}
};
}  // namespace archetype

// Each breaks one clause.
namespace knock_out::host {
struct not_copyable : archetype::host {
  using archetype::host::host;
  not_copyable(const not_copyable&) = delete;
};
struct without_update : archetype::host {
  void update_copies(std::span<double>, std::size_t) const = delete;
};
struct updates_when_not_const : archetype::host {
  void update_copies(std::span<double>, std::size_t) {}
};
struct without_any : archetype::host {
  bool any(bool) const = delete;
};
struct any_of_nothing : archetype::host {
  void any(bool) const {}
};
struct without_sum : archetype::host {
  void sum(std::span<reproducible_sum>) const = delete;
};
struct sums_doubles : archetype::host {
  void sum(std::span<double>) const {}
};
struct without_most : archetype::host {
  double most(double) const = delete;
};
struct without_leader : archetype::host {
  bool leads() const = delete;
};
struct without_keeper : archetype::distributing_host {
  bool keeps(const vector&) const = delete;
};
struct without_exchange : archetype::distributing_host {
  std::size_t exchange(std::vector<parcel>&, double) const = delete;
};
struct exchanges_without_count : archetype::distributing_host {
  void exchange(std::vector<parcel>&, double) const {}
};
struct knows_no_rows : archetype::distributing_host {
  void know_rows(std::span<const std::int64_t>, std::size_t) const = delete;
};
}  // namespace knock_out::host

namespace knock_out {
inline constexpr auto hosts =
    boost::hana::tuple_t<host::not_copyable, host::without_update, host::updates_when_not_const, host::without_any,
                         host::any_of_nothing, host::without_sum, host::sums_doubles, host::without_most,
                         host::without_leader>;
inline constexpr auto distributing_hosts = boost::hana::tuple_t<host::without_keeper, host::without_exchange,
                                                                host::exchanges_without_count, host::knows_no_rows>;
}  // namespace knock_out

}  // namespace pendular::testing
