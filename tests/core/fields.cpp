// SPDX-License-Identifier: BSD-3-Clause
#include "../catch.hpp"

#include <pendular/core/fields.hpp>
#include <pendular/core/lanes.hpp>

#include <type_traits>
#include <vector>

using namespace pendular;

namespace {
struct nothing {};
struct one {
  double a;
};
struct two {
  double a;
  one b;
};
struct nested {
  Vec3<double> direction;
  double length;
  two rest;
};
struct eight {
  double a, b, c, d, e, f, g, h;
};
struct mixed {
  double a;
  int count;
  double b;
};
template <class T>
struct springs {
  Vec3<T> first;
  T second;
};

static_assert(detail::field_count<nothing>() == 0 && detail::field_count<one>() == 1);
static_assert(detail::field_count<two>() == 2 && detail::field_count<nested>() == 3);
static_assert(detail::field_count<eight>() == 8 && detail::field_count<mixed>() == 3);
static_assert(detail::field_count<springs<block>>() == 2);
static_assert(scalar_count<double, nothing> == 0 && scalar_count<double, nested> == 6);
static_assert(scalar_count<double, springs<double>> == 4 && scalar_count<block, springs<block>> == 4);

template <class S>
std::vector<double> scalars_of(S& s) {
  std::vector<double> found;
  for_each_scalar<double>(s, [&](auto& v) { found.push_back(v); });
  return found;
}
}  // namespace

TEST_CASE("the scalars of nested aggregates come in the order of declaration") {
  nested n{{1, 2, 3}, 4, {5, {6}}};
  CHECK(scalars_of(n) == std::vector<double>{1, 2, 3, 4, 5, 6});
  eight e{1, 2, 3, 4, 5, 6, 7, 8};
  CHECK(scalars_of(e) == std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8});
  double alone = 9;
  CHECK(scalars_of(alone) == std::vector<double>{9});
  nothing none;
  CHECK(scalars_of(none).empty());
}

TEST_CASE("scalars are visited by reference, and those of a constant cannot be changed") {
  nested n{{1, 2, 3}, 4, {5, {6}}};
  for_each_scalar<double>(n, [](double& v) { v *= 10; });
  CHECK((n.direction.z == 30 && n.length == 40 && n.rest.b.a == 60));
  const nested& fixed = n;
  for_each_scalar<double>(fixed, [](auto& v) { static_assert(std::is_const_v<std::remove_reference_t<decltype(v)>>); });
  CHECK(scalars_of(fixed).size() == 6);
}

TEST_CASE("members of an aggregate may be of different types") {
  mixed m{1.5, 2, 3.5};
  double sum = 0;
  int count = 0;
  for_each_field(m, [&](auto& member) {
    if constexpr (std::is_same_v<std::remove_reference_t<decltype(member)>, int>) {
      count += member;
    } else {
      sum += member;
    }
  });
  CHECK((sum == 5 && count == 2));
}

TEST_CASE("blocks in an aggregate are scalars of their own") {
  springs<block> s{{block(1), block(2), block(3)}, block(4)};
  std::vector<double> firsts;
  for_each_scalar<block>(s, [&](block& v) { firsts.push_back(v[0]); });
  CHECK(firsts == std::vector<double>{1, 2, 3, 4});
}
