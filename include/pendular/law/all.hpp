// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/capillary/bagheri.hpp>
#include <pendular/law/capillary/constant.hpp>
#include <pendular/law/capillary/huppmann_riegger.hpp>
#include <pendular/law/capillary/lambert.hpp>
#include <pendular/law/capillary/lian_seville.hpp>
#include <pendular/law/capillary/mikami.hpp>
#include <pendular/law/capillary/rabinovich.hpp>
#include <pendular/law/capillary/richefeu.hpp>
#include <pendular/law/capillary/richefeu_harmonic.hpp>
#include <pendular/law/capillary/soulie.hpp>
#include <pendular/law/capillary/weigert_ripperger.hpp>
#include <pendular/law/capillary/willett.hpp>
#include <pendular/law/capillary/willett_closed_form.hpp>
#include <pendular/law/damping/clamped.hpp>
#include <pendular/law/damping/none.hpp>
#include <pendular/law/damping/viscous.hpp>
#include <pendular/law/damping/viscous_on_approach.hpp>
#include <pendular/law/friction/coulomb_spring.hpp>
#include <pendular/law/friction/none.hpp>
#include <pendular/law/friction/viscous_coulomb.hpp>
#include <pendular/law/friction/viscous_coulomb_explicit.hpp>
#include <pendular/law/mean_radius/geometric.hpp>
#include <pendular/law/mean_radius/harmonic.hpp>
#include <pendular/law/normal/hertz.hpp>
#include <pendular/law/normal/linear.hpp>
#include <pendular/law/rupture/lian.hpp>
#include <pendular/law/rupture/mikami.hpp>
#include <pendular/law/rupture/willett.hpp>
#include <pendular/law/rupture/willett_equal.hpp>
#include <pendular/law/viscous/lubrication.hpp>

#include <boost/hana/tuple.hpp>
#include <boost/hana/type.hpp>

namespace pendular::law {

// Every shipped law, so that tests and reports iterate them; a new law is added by one line here.
inline constexpr auto normal_laws = boost::hana::tuple_t<normal::linear, normal::hertz>;
inline constexpr auto damping_laws =
    boost::hana::tuple_t<damping::viscous, damping::viscous_on_approach, damping::clamped<damping::viscous>>;
inline constexpr auto friction_laws =
    boost::hana::tuple_t<friction::viscous_coulomb, friction::viscous_coulomb_explicit, friction::coulomb_spring>;
inline constexpr auto capillary_laws =
    boost::hana::tuple_t<capillary::richefeu, capillary::richefeu_harmonic, capillary::soulie, capillary::mikami,
                         capillary::willett, capillary::willett_closed_form, capillary::rabinovich, capillary::lambert,
                         capillary::weigert_ripperger, capillary::huppmann_riegger, capillary::lian_seville,
                         capillary::bagheri, capillary::constant>;
inline constexpr auto rupture_laws =
    boost::hana::tuple_t<rupture::lian, rupture::willett, rupture::willett_equal, rupture::mikami>;
inline constexpr auto mean_radii = boost::hana::tuple_t<mean_radius::geometric, mean_radius::harmonic>;
inline constexpr auto viscous_bridge_laws = boost::hana::tuple_t<viscous::lubrication>;

}  // namespace pendular::law
