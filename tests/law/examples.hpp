// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/law/all.hpp>

#include <boost/hana/drop_front.hpp>
#include <boost/hana/integral_constant.hpp>
#include <boost/hana/take_front.hpp>

// One set of parameters per shipped law, those of glass beads of a millimetre in the reference papers. A law that is
// added to law/all.hpp does not compile in these tests before it has one.
namespace examples {
using namespace pendular;

template <class Law>
struct of {
  static_assert(std::is_empty_v<Law>, "a new law with parameters needs a line in tests/law/examples.hpp");
  static constexpr Law value{};
};
template <>
struct of<normal::linear> {
  static constexpr normal::linear value{1e3};
};
template <>
struct of<normal::hertz> {
  static constexpr normal::hertz value{7e10, 0.22};
};
template <>
struct of<damping::viscous> {
  static constexpr damping::viscous value{0.8};
};
template <>
struct of<damping::viscous_on_approach> {
  static constexpr damping::viscous_on_approach value{0.8};
};
template <>
struct of<damping::clamped<damping::viscous>> {
  static constexpr damping::clamped value{damping::viscous{0.8}};
};
template <>
struct of<friction::viscous_coulomb> {
  static constexpr friction::viscous_coulomb value{1.0, 0.4};
};
template <>
struct of<friction::viscous_coulomb_explicit> {
  static constexpr friction::viscous_coulomb_explicit value{1.0, 0.4};
};
template <>
struct of<friction::coulomb_spring> {
  static constexpr friction::coulomb_spring value{800.0, 0.4};
};
template <>
struct of<capillary::richefeu> {
  static constexpr capillary::richefeu value{};
};
template <>
struct of<capillary::richefeu_harmonic> {
  static constexpr capillary::richefeu_harmonic value{};
};
template <>
struct of<viscous::lubrication> {
  static constexpr viscous::lubrication value{};
};

/// Some laws of a list, for sources that must not take long to compile.
template <std::size_t First, std::size_t Count, class List>
constexpr auto some_of(List laws) {
  namespace hana = boost::hana;
  return hana::take_front(hana::drop_front(laws, hana::size_c<First>), hana::size_c<Count>);
}

inline constexpr fluid tilted_water{0.0728, 0.5, 998.2, 1.002e-3};

}  // namespace examples
