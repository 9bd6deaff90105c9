// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/capillary/richefeu_harmonic.hpp>
#include <pendular/law/damping/none.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/damping/viscous_on_approach.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/friction/none.hpp>
#include <pendular/law/friction/viscous_coulomb.hpp>
#include <pendular/law/friction/viscous_coulomb_explicit.hpp>
#include <pendular/law/normal/hertz.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/law/rupture/willett.hpp>

#include <boost/hana/tuple.hpp>
#include <boost/hana/type.hpp>

namespace pendular::law {

// Every shipped law, so that tests and reports iterate them; a new law is added by one line here.
inline constexpr auto normal_laws = boost::hana::tuple_t<normal::linear, normal::hertz>;
inline constexpr auto damping_laws = boost::hana::tuple_t<damping::viscous, damping::viscous_on_approach>;
inline constexpr auto friction_laws =
    boost::hana::tuple_t<friction::viscous_coulomb, friction::viscous_coulomb_explicit, friction::coulomb_spring>;
inline constexpr auto capillary_laws = boost::hana::tuple_t<capillary::richefeu, capillary::richefeu_harmonic>;
inline constexpr auto rupture_laws = boost::hana::tuple_t<rupture::lian, rupture::willett>;

}  // namespace pendular::law
