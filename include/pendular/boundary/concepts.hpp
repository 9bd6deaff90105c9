// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/drive.hpp>
#include <pendular/core/copyable.hpp>
#include <pendular/core/none.hpp>

#include <concepts>
#include <tuple>
#include <type_traits>
#include <utility>

namespace pendular::boundary {

/// Shape of a wall.
template <class G>
concept Geometry = Copyable<G> && requires(const G geometry, const vector centre, const double radius) {
  { geometry.meet(centre, radius) } -> std::convertible_to<meeting<double>>;
};

/// What a system asks of a wall: where it meets a grain, what moves it, what it is made of, whether it carries bridges, and
/// what it is told. `wall` is one; a wall of one's own may know more.
template <class W>
concept Wall = Copyable<W> && requires(W wall, const W seen, const wall_load& load) {
  requires Geometry<std::remove_cvref_t<decltype(seen.shape)>>;
  requires HasOneVelocity<std::remove_cvref_t<decltype(seen.drive)>> ||
      HasVelocityField<std::remove_cvref_t<decltype(seen.drive)>>;
  requires std::is_same_v<decltype(W::material), none> || requires { decltype(W::material)::has_friction; };
  { W::is_wettable } -> std::convertible_to<bool>;
  { seen.force } -> std::convertible_to<vector>;
  { seen.work } -> std::convertible_to<double>;
  { seen.approach_speed() } -> std::convertible_to<double>;
  wall.move(1e-6);
  wall.take(load, 1e-6);
};

namespace detail {
template <class Tuple>
struct types_in {
  static constexpr bool are_a_tuple = false;
};
template <class... Parts>
struct types_in<std::tuple<Parts...>> {
  static constexpr bool are_a_tuple = true;
  static constexpr bool are_walls = (Wall<std::remove_cvref_t<Parts>> && ...);
  static constexpr bool are_references = (std::is_lvalue_reference_v<Parts> && ...);
  static constexpr bool are_writable = (!std::is_const_v<std::remove_reference_t<Parts>> && ...);
  using type = std::tuple<std::remove_cvref_t<Parts>...>;
};

/// What `parts()` of a boundary that may be written to, and of one that may not, answers.
template <class B>
using parts_t = decltype(std::declval<B&>().parts());
template <class B>
using seen_parts_t = decltype(std::declval<const B&>().parts());

template <class Answer>
using parts_in = types_in<std::remove_cvref_t<Answer>>;

template <class B>
concept HasParts = requires {
  requires parts_in<parts_t<B>>::are_a_tuple;
  requires parts_in<seen_parts_t<B>>::are_a_tuple;
};

/// The walls themselves and not copies of them: a tuple that stays where it is, or one of references.
template <class Answer>
inline constexpr bool stay = std::is_lvalue_reference_v<Answer> || parts_in<Answer>::are_references;
template <class Answer>
inline constexpr bool may_be_written =
    parts_in<Answer>::are_writable &&
    !(std::is_const_v<std::remove_reference_t<Answer>> && !parts_in<Answer>::are_references);
template <class B>
inline constexpr bool parts_are_its_own = stay<parts_t<B>>&& stay<seen_parts_t<B>>&& may_be_written<parts_t<B>>&&
    std::is_same_v<typename parts_in<parts_t<B>>::type, typename parts_in<seen_parts_t<B>>::type>;
}  // namespace detail

/// All walls of a scene: `parts()`, of a boundary that is const and of one that is not, is a tuple of them, kept by the
/// boundary, or made of references to them.
template <class B>
concept Boundary = Copyable<B> && detail::HasParts<B> && requires {
  requires detail::parts_in<detail::parts_t<B>>::are_walls;
  requires detail::parts_are_its_own<B>;
};

}  // namespace pendular::boundary
