// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/liquid/source/evaporation.hpp>
#include <pendular/liquid/source/wetting.hpp>

#include <boost/hana/tuple.hpp>
#include <boost/hana/type.hpp>

namespace pendular::source {

// Every shipped source and sink; a new one is added by one line here.
inline constexpr auto all = boost::hana::tuple_t<evaporation, wetting<>>;

}  // namespace pendular::source
