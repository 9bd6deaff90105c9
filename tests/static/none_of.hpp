// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/hana/unpack.hpp>

/// Whether a predicate of a hana type holds for none of a list of them.
template <class List, class Predicate>
consteval bool none_of(List types, Predicate holds) {
  return boost::hana::unpack(types, [holds](auto... type) { return (!holds(type) && ...); });
}
template <class Type>
using type_of = typename Type::type;
