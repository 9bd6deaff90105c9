// SPDX-License-Identifier: BSD-3-Clause
// The kit of hosts passes those that keep their promises and names what others break.
#include "../catch.hpp"
#include "../open/slabs.hpp"

#include <pendular/testing/host.hpp>

#include <mutex>
#include <string>

using namespace pendular;

namespace {

constexpr vector lower{-1, 0, 0}, upper{2, 1, 0.5};

/// What the kit says of hosts made from slabs, all parts together.
template <class H>
testing::report reports(std::vector<double> borders) {
  slab_house house(std::move(borders));
  std::mutex one_at_a_time;
  testing::report all;
  in_slabs(house, [&](const slab& part) {
    const testing::report broken = testing::host_report(H(part), part.place(), lower, upper);
    const std::lock_guard guard(one_at_a_time);
    all.insert(all.end(), broken.begin(), broken.end());
  });
  return all;
}

bool mentions(const testing::report& broken, const std::string& text) {
  for (const std::string& line : broken) {
    if (line.find(text) != std::string::npos) return true;
  }
  return false;
}

struct all_lead : slab {
  explicit all_lead(const slab& s) : slab(s) {}
  bool leads() const { return true; }
};
struct asks_itself : slab {
  explicit asks_itself(const slab& s) : slab(s) {}
  bool any(bool flag) const { return flag; }
};
struct adds_rounded : slab {
  explicit adds_rounded(const slab& s) : slab(s) {}
  void sum(std::span<reproducible_sum> sums) const {
    for (reproducible_sum& s : sums) {
      const double rounded = s.value() + 1e-310;  // what is smaller is lost
      s = {};
      s.add(rounded - 1e-310);
    }
    slab::sum(sums);
    for (reproducible_sum& s : sums) {
      reproducible_sum whole;
      whole.add(std::abs(s.value()) < 1e-200 ? 0.0 : s.value());
      s = whole;
    }
  }
};
struct sees_too_near : slab {
  explicit sees_too_near(const slab& s) : slab(s) {}
  std::size_t exchange(std::vector<parcel>& parcels, double reach) const {
    return slab::exchange(parcels, 0.5 * reach);
  }
};
struct forgets_a_grain : slab {
  explicit forgets_a_grain(const slab& s) : slab(s) {}
  std::size_t exchange(std::vector<parcel>& parcels, double reach) const {
    std::erase_if(parcels, [](const parcel& p) { return p.id == 17; });
    return slab::exchange(parcels, reach);
  }
};
struct updates_one_number : slab {
  explicit updates_one_number(const slab& s) : slab(s) {}
  void update_copies(std::span<double> numbers, std::size_t width) const {
    const std::vector<double> before(numbers.begin(), numbers.end());
    slab::update_copies(numbers, width);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (k % width > 0) numbers[k] = before[k];
    }
  }
};

}  // namespace

TEST_CASE("slabs keep the promises of a host") {
  CHECK(reports<slab>({}).empty());
  CHECK(reports<slab>({0.3}).empty());
  CHECK(reports<slab>({0, 0.7, 1.1}).empty());
  CHECK(testing::host_report(alone{}, 0, lower, upper).empty());
}

TEST_CASE("the kit of hosts names what a host breaks") {
  CHECK(mentions(reports<all_lead>({0.3}), "exactly one part must lead"));
  CHECK(mentions(reports<asks_itself>({0.3}), "any must be true where it is so somewhere"));
  CHECK(mentions(reports<adds_rounded>({0.3}), "sums must be joined without an error"));
  CHECK(mentions(reports<sees_too_near>({0.3}), "a copy of every grain within reach"));
  CHECK(mentions(reports<forgets_a_grain>({0.3}), "kept on exactly one part"));
  CHECK(mentions(reports<updates_one_number>({0.3}), "copies must get the numbers"));
}
