// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/liquid/protocol/grain_films.hpp>
#include <pendular/liquid/protocol/gravity.hpp>
#include <pendular/liquid/protocol/homogeneous.hpp>
#include <pendular/liquid/protocol/neighbours.hpp>
#include <pendular/liquid/protocol/none.hpp>

#include <boost/hana/tuple.hpp>
#include <boost/hana/type.hpp>

namespace pendular::protocol {

// Every shipped protocol; a new one is added by one line here.
inline constexpr auto all = boost::hana::tuple_t<neighbours, homogeneous, grain_films, gravity, none>;

}  // namespace pendular::protocol
