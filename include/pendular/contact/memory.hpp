// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/none.hpp>
#include <pendular/law/concepts.hpp>

#include <boost/hana/filter.hpp>
#include <boost/hana/fold_right.hpp>
#include <boost/hana/tuple.hpp>
#include <boost/hana/type.hpp>

#include <type_traits>

namespace pendular {

namespace detail {

/// Two who remember: a policy, and one policy or such a pair.
template <class Policy, class Others>
struct both {};

/// Of the policies those that remember: one of them is itself, several are `both`s, none is `none`.
template <class... Policies>
consteval auto remembering() {
  namespace hana = boost::hana;
  constexpr auto remembers = []<class P>(hana::basic_type<P>) { return hana::bool_c<Remembers<P, double>>; };
  constexpr auto join = []<class P, class Others>(hana::basic_type<P>, hana::basic_type<Others>) {
    return hana::type_c<std::conditional_t<std::is_same_v<Others, none>, P, both<P, Others>>>;
  };
  return hana::fold_right(hana::filter(hana::tuple_t<Policies...>, remembers), hana::type_c<none>, join);
}

/// The record of one who remembers is its own, without anything around it.
template <class T, class Who>
struct record_of {
  using type = contact_memory_t<Who, T>;
};
template <class T, class Policy, class Others>
struct joined_memory {
  contact_memory_t<Policy, T> own;
  typename record_of<T, Others>::type others;
};
template <class T, class Policy, class Others>
struct record_of<T, both<Policy, Others>> {
  using type = joined_memory<T, Policy, Others>;
};
}  // namespace detail

/// What a pair remembers under the given policies: the contact memories of all that have one, side by side.
template <class T, class... Policies>
using pair_memory = typename detail::record_of<T, typename decltype(detail::remembering<Policies...>())::type>::type;

namespace detail {
template <class Record>
inline constexpr bool is_joined = false;
template <class T, class Policy, class Others>
inline constexpr bool is_joined<joined_memory<T, Policy, Others>> = true;
template <class Record, class Policy>
inline constexpr bool begins_with = false;
template <class T, class Policy, class Others>
inline constexpr bool begins_with<joined_memory<T, Policy, Others>, Policy> = true;
}  // namespace detail

/// What one of the policies remembers, of the record of all; the record itself for a policy that remembers nothing.
template <class Policy, class Record>
auto& part_of(Record& all) {
  using record = std::remove_const_t<Record>;
  if constexpr (!detail::is_joined<record> || !detail::Remembers<Policy, double>) {
    return all;
  } else if constexpr (detail::begins_with<record, Policy>) {
    return all.own;
  } else {
    return part_of<Policy>(all.others);
  }
}

}  // namespace pendular
