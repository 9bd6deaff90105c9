// SPDX-License-Identifier: BSD-3-Clause
#include "../catch.hpp"

#include <pendular/core/bundle.hpp>

#include <type_traits>

using namespace pendular;

namespace {
struct singer {
  int voice;
};
struct dancer {
  int step;
};
struct star {
  int voice;
  int step;
};  // plays both roles

inline constexpr auto sings = []<class P>() {
  return requires(P p) { p.voice; };
};
inline constexpr auto dances = []<class P>() {
  return requires(P p) { p.step; };
};
inline constexpr auto paints = []<class P>() {
  return requires(P p) { p.brush; };
};

static_assert(detail::players<sings, singer, dancer, none>() == 1 && detail::players<sings>() == 0);
static_assert(detail::players<sings, singer, star, singer>() == 3);
static_assert(detail::index_of_player<dances, none, singer, dancer>() == 2);
static_assert(detail::index_of_player<dances, star, singer, dancer>() == 0);
static_assert(detail::index_of_player<paints, singer, dancer>() == 2);
static_assert(std::is_same_v<detail::player_t<dances, singer, dancer>, dancer>);
static_assert(std::is_same_v<detail::player_t<paints, singer, dancer>, none>);
static_assert(std::is_same_v<detail::player_t<paints>, none>);
}  // namespace

TEST_CASE("the player of a role is found wherever it stands in a bundle") {
  CHECK(detail::player<sings>(std::tuple{dancer{1}, none{}, singer{2}}).voice == 2);
  CHECK(detail::player<sings>(std::tuple{singer{3}, dancer{1}}).voice == 3);
  CHECK(detail::player<dances>(std::tuple{none{}, star{4, 5}}).step == 5);
}

TEST_CASE("a bundle hands out its own policy and not a copy") {
  const std::tuple bundle{dancer{1}, singer{2}};
  CHECK(&detail::player<sings>(bundle) == &std::get<1>(bundle));
}
