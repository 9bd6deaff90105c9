// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/none.hpp>
#include <pendular/law/concepts.hpp>

#include <boost/hana/ext/std/tuple.hpp>
#include <boost/hana/filter.hpp>
#include <boost/hana/transform.hpp>
#include <boost/hana/tuple.hpp>
#include <boost/hana/type.hpp>
#include <boost/hana/unpack.hpp>

namespace pendular {

namespace detail {

// Undefined for two policies that remember: the friction law is the only one that is handed a memory.
template <class T, class... Policies>
struct joined_memory;
template <class T>
struct joined_memory<T> {
  using record = no_memory;
};
template <class T, class Policy>
struct joined_memory<T, Policy> {
  using record = contact_memory_t<Policy, T>;
};

template <class T, class... Policies>
consteval auto remembering() {
  namespace hana = boost::hana;
  constexpr auto remembers = []<class P>(hana::basic_type<P>) { return hana::bool_c<Remembers<P, T>>; };
  constexpr auto join = []<class... P>(hana::basic_type<P>...) { return hana::type_c<joined_memory<T, P...>>; };
  return hana::unpack(hana::filter(hana::tuple_t<Policies...>, remembers), join);
}

}  // namespace detail

/// What a pair remembers under the given policies: the contact memory of the one that has any, else nothing.
template <class T, class... Policies>
using pair_memory = typename decltype(detail::remembering<T, Policies...>())::type::record;

}  // namespace pendular
