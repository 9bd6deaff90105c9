// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/io/checkpoint.hpp>
#include <pendular/observe/energy.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pendular::scene {

namespace detail {
template <class Energies, class Visit>
void for_each_energy(Energies& e, const Visit& visit) {
  for (auto* v : {&e.kinetic, &e.gravity, &e.elastic, &e.friction_springs, &e.capillary, &e.damping, &e.friction,
                  &e.liquid, &e.walls}) {
    visit(*v);
  }
}

/// The lists of a result whose lengths are not known beforehand.
template <class Result, class Visit>
void for_each_list(Result& r, const Visit& visit) {
  visit(r.reference);
  visit(r.records);
  if constexpr (requires { r.relaxation; }) visit(r.relaxation);
}
template <class Result>
std::size_t count_numbers(Result& r) {
  std::size_t count = 0;
  for_each_number(r, [&](const double&) { ++count; });
  return count;
}

/// The lengths of the lists, which make exactly so many numbers; asked before there is room for them.
template <class Result>
std::vector<std::int64_t> lengths_in(const io::checkpoint_reader& in, std::size_t numbers) {
  Result one{};
  std::size_t lists = 0, n = 0;
  for_each_list(one, [&](auto&) { ++lists; });
  const auto lengths = in.get<std::vector<std::int64_t>>("scene.lengths", lists);
  const std::size_t fixed = count_numbers(one);
  std::size_t left = numbers - std::min(numbers, fixed);
  for_each_list(one, [&](auto& list) {
    list.resize(1);
    const std::size_t each = count_numbers(one) - fixed;
    list.clear();
    const std::int64_t length = lengths[n++];
    in.require(length >= 0 && static_cast<std::size_t>(length) <= left / each, "scene.lengths",
               static_cast<double>(length), "at least 0 and not more than 'scene.numbers' has");
    left -= static_cast<std::size_t>(length) * each;
  });
  if (numbers < fixed || left != 0) {
    in.refuse("holds " + std::to_string(numbers) +
              " values in 'scene.numbers', which are not those of the lists in 'scene.lengths'; it may come from "
              "another scene or release");
  }
  return lengths;
}
}  // namespace detail

/// What a scene has found so far, in its checkpoint. A result has `reference`, `records`, perhaps `relaxation`, and a
/// `for_each_number` beside it.
template <class Result>
void save(io::checkpoint_writer& out, const Result& r) requires requires {
  r.records;
}
{
  std::vector<double> numbers;
  for_each_number(r, [&](const double& v) { numbers.push_back(v); });
  std::vector<std::int64_t> lengths;
  detail::for_each_list(r, [&](const auto& list) { lengths.push_back(static_cast<std::int64_t>(list.size())); });
  out.put("scene.lengths", lengths);
  out.put("scene.numbers", numbers);
}

/// Errors: std::runtime_error for another number of numbers than the lists' lengths make.
template <class Result>
void load(const io::checkpoint_reader& in, Result& r) requires requires {
  r.records;
}
{
  const auto numbers = in.get<std::vector<double>>("scene.numbers");
  const auto lengths = detail::lengths_in<Result>(in, numbers.size());
  std::size_t n = 0, k = 0;
  detail::for_each_list(r, [&](auto& list) { list.resize(static_cast<std::size_t>(lengths[n++])); });
  for_each_number(r, [&](double& v) { v = numbers[k++]; });
}

}  // namespace pendular::scene
