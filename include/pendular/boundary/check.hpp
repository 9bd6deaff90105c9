// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/concepts.hpp>
#include <pendular/core/copyable.hpp>
#include <pendular/core/lanes.hpp>
#include <pendular/core/never.hpp>

#include <concepts>
#include <tuple>
#include <type_traits>
#include <utility>

namespace pendular::check {

// Ladders as those of laws (law/check.hpp): true, or one sentence for the first clause that is broken.

namespace detail {
using namespace pendular::detail;

template <class G, class T>
using meeting_t = decltype(std::declval<const G>().meet(std::declval<const Vec3<T>&>(), std::declval<const T&>()));
template <class D, class T>
using velocity_t = decltype(std::declval<const D>().velocity_at(std::declval<const Vec3<T>&>()));

template <class W>
concept IsMovedAndTold = requires(W wall, const boundary::wall_load& load) {
  wall.move(1e-6);
  wall.take(load, 1e-6);
};
template <class W>
concept IsMadeOfSomething = requires(const W wall) {
  requires std::is_same_v<decltype(W::material), none> || requires { decltype(W::material)::has_friction; };
  { W::is_wettable } -> std::convertible_to<bool>;
};
}  // namespace detail

template <class G>
consteval bool is_geometry() {
  if constexpr (!Copyable<G>) {
    static_assert(detail::never<G>, "a wall's shape must be copyable: make it a struct of parameters "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!requires { typename detail::meeting_t<G, double>; }) {
    static_assert(detail::never<G>,
                  "a wall's shape needs `template <Scalar T> meeting<T> meet(const Vec3<T>& centre, const T& radius) "
                  "const` (docs/reference/boundary.md)");
  } else if constexpr (!requires { typename detail::meeting_t<G, block>; }) {
    static_assert(detail::never<G>,
                  "a wall's shape must take every scalar, not double alone, because walls are met in lanes of eight: "
                  "write `template <Scalar T>` before `meeting<T> meet` (docs/reference/concepts.md)");
  } else if constexpr (!std::is_same_v<detail::meeting_t<G, double>, boundary::meeting<double>> ||
                       !std::is_same_v<detail::meeting_t<G, block>, boundary::meeting<block>>) {
    static_assert(detail::never<G>,
                  "meet must return a boundary::meeting of the scalar type of its radius: write boundary::meeting<T> "
                  "(docs/reference/concepts.md)");
  }
  return true;
}

template <class D, class Shape>
consteval bool is_drive() {
  if constexpr (!Copyable<D>) {
    static_assert(detail::never<D>, "a wall's drive must be copyable: make it a struct of parameters "
                                    "(docs/reference/concepts.md)");
  } else if constexpr (!boundary::HasOneVelocity<D> && !boundary::HasVelocityField<D>) {
    static_assert(detail::never<D>,
                  "a wall's drive needs a `velocity`, or `velocity_at(point)`, `pivot()` and `approach_speed()` "
                  "(docs/reference/boundary.md)");
  } else if constexpr (!boundary::Drive<D, Shape>) {
    static_assert(detail::never<D>,
                  "a wall's drive needs `void move(shape, load, time_step)` for the shape of its wall; the load is a "
                  "`const boundary::wall_load&` or its force alone, a `const vector&` (docs/reference/boundary.md)");
  } else if constexpr (!boundary::HasOneVelocity<D>) {
    if constexpr (!requires { typename detail::velocity_t<D, block>; }) {
      static_assert(detail::never<D>,
                    "a drive's velocity_at must take every scalar, not double alone, because walls are met in lanes of "
                    "eight: write `template <Scalar T> Vec3<T> velocity_at(const Vec3<T>&) const` "
                    "(docs/reference/concepts.md)");
    } else if constexpr (!std::is_same_v<detail::velocity_t<D, block>, Vec3<block>>) {
      static_assert(detail::never<D>, "velocity_at must return a Vec3 of the scalar type of its point: "
                                      "write Vec3<T> (docs/reference/concepts.md)");
    }
  }
  return true;
}

template <class G>
inline constexpr bool geometry = is_geometry<G>();
template <class D, class Shape>
inline constexpr bool drive = is_drive<D, Shape>();

template <class W>
consteval bool is_wall() {
  if constexpr (!Copyable<W>) {
    static_assert(detail::never<W>, "a wall must be copyable (docs/reference/concepts.md)");
  } else if constexpr (!requires(const W w) { w.shape, w.drive; }) {
    static_assert(detail::never<W>,
                  "a part of a boundary must be a wall, with the members `shape` and `drive` of boundary::wall "
                  "(docs/reference/concepts.md)");
  } else if constexpr (!detail::IsMadeOfSomething<W>) {
    static_assert(detail::never<W>,
                  "a wall needs a member `material`, none{} for that of the grains, and `static constexpr bool "
                  "is_wettable` (docs/reference/concepts.md)");
  } else if constexpr (!requires(const W w) { w.force, w.work, w.approach_speed(); }) {
    static_assert(detail::never<W>,
                  "a wall needs the members `vector force` and `double work`, and `double approach_speed() const` "
                  "(docs/reference/concepts.md)");
  } else if constexpr (!detail::IsMovedAndTold<W>) {
    static_assert(detail::never<W>,
                  "a wall needs `void move(double time_step)` and `void take(const boundary::wall_load&, double "
                  "time_step)` (docs/reference/concepts.md)");
  } else {
    using shape = std::remove_cvref_t<decltype(W::shape)>;
    static_assert(geometry<shape> && (boundary::Wall<W> || drive<std::remove_cvref_t<decltype(W::drive)>, shape>));
    static_assert(boundary::Wall<W>, "the members of a wall must have the types of those of boundary::wall "
                                     "(docs/reference/concepts.md)");
  }
  return true;
}
template <class W>
inline constexpr bool wall = is_wall<W>();

template <class... Parts>
consteval bool are_walls(std::type_identity<std::tuple<Parts...>>) {
  return (wall<Parts> && ...);
}

template <class B>
consteval bool is_boundary() {
  if constexpr (!Copyable<B>) {
    static_assert(detail::never<B>, "a boundary must be copyable (docs/reference/concepts.md)");
  } else if constexpr (!boundary::detail::HasParts<B>) {
    static_assert(detail::never<B>,
                  "a system needs its walls between material or liquid and integrator, such as boundary::walls{}, or a "
                  "boundary of your own with `auto parts()` and `auto parts() const`, which return std::tie(all its "
                  "walls) (docs/reference/boundary.md)");
  } else if constexpr (!boundary::detail::parts_are_its_own<B>) {
    static_assert(detail::never<B>,
                  "parts of a boundary must be its walls themselves, the same in `parts()` and `parts() const`, and "
                  "not copies: return std::tie(all its walls) from both (docs/reference/boundary.md)");
  } else {
    using parts = typename boundary::detail::parts_in<boundary::detail::parts_t<B>>::type;
    static_assert(are_walls(std::type_identity<parts>{}));
  }
  return true;
}
template <class B>
inline constexpr bool boundary = is_boundary<B>();

}  // namespace pendular::check
