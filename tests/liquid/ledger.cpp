// SPDX-License-Identifier: BSD-3-Clause
#include "../catch.hpp"

#include <pendular/liquid/ledger.hpp>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

using namespace pendular;

namespace {
constexpr auto reservoir = ledger::reservoir();

/// Films of 1, 2, 3, ... and no bonds.
ledger with_films(std::size_t count) {
  ledger l;
  l.resize_films(count);
  for (std::size_t k = 0; k < count; ++k) {
    l.introduce(static_cast<double>(k + 1));
    l.transfer(reservoir, ledger::film_of(k), static_cast<double>(k + 1));
  }
  return l;
}

ledger with_bonds(std::size_t count) {
  ledger l;
  l.carry_bonds({}, count);
  for (std::size_t k = 0; k < count; ++k) {
    l.introduce(static_cast<double>(k + 1));
    l.transfer(reservoir, ledger::bond_of(k), static_cast<double>(k + 1));
  }
  return l;
}
}  // namespace

TEST_CASE("liquid enters by the reservoir and moves from account to account") {
  ledger l;
  l.resize_films(2);
  l.carry_bonds({}, 1);
  l.introduce(8);
  CHECK((l.balance(reservoir) == 8 && l.total() == 8 && l.introduced() == 8));
  l.transfer(reservoir, ledger::film_of(1), 5);
  l.transfer(ledger::film_of(1), ledger::bond_of(0), 2);
  CHECK((l.films()[0] == 0 && l.films()[1] == 3 && l.bonds()[0] == 2 && l.balance(reservoir) == 3));
  CHECK((l.balance(ledger::film_of(1)) == 3 && l.balance(ledger::bond_of(0)) == 2));
  CHECK((l.total() == 8 && l.introduced() == 8));
}

TEST_CASE("no account gives more than it has") {
  ledger l = with_films(2);
  l.transfer(ledger::film_of(0), ledger::film_of(1), 100);
  CHECK((l.films()[0] == 0 && l.films()[1] == 3));
  l.transfer(ledger::film_of(0), ledger::film_of(1), 1);
  CHECK((l.films()[0] == 0 && l.films()[1] == 3 && l.total() == 3));
}

TEST_CASE("an account that is emptied holds exactly nothing") {
  ledger l = with_films(3);
  l.transfer(ledger::film_of(0), ledger::film_of(2), 0.1);
  l.empty(ledger::film_of(2), ledger::film_of(1));
  CHECK(l.films()[2] == 0);
  CHECK(l.films()[1] == within(1e-15, 5.1));
  l.empty(ledger::film_of(2), ledger::film_of(1));
  CHECK(l.total() == within(1e-15, 6));
}

TEST_CASE("a transfer to the same account changes nothing") {
  ledger l = with_films(2);
  l.transfer(ledger::film_of(1), ledger::film_of(1), 1.5);
  CHECK((l.films()[1] == 2 && l.total() == 3));
}

TEST_CASE("volumes that are negative or not finite are refused and change nothing") {
  ledger l = with_films(2);
  for (const double bad : {-1e-300, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(l.introduce(bad), input_error);
    CHECK_THROWS_AS(l.transfer(ledger::film_of(0), ledger::film_of(1), bad), input_error);
    CHECK_THROWS_AS(l.transfer(reservoir, ledger::film_of(1), bad), input_error);
  }
  CHECK((l.films()[0] == 1 && l.films()[1] == 2 && l.total() == 3 && l.introduced() == 3));
}

TEST_CASE("the total keeps drops that a plain sum would lose") {
  // 1 + 4096 * 2^-53: every single addition to 1 is lost, the sum is not.
  ledger l;
  l.resize_films(4097);
  l.introduce(1);
  l.transfer(reservoir, ledger::film_of(0), 1);
  for (std::size_t k = 1; k <= 4096; ++k) {
    l.introduce(0x1p-53);
    l.transfer(reservoir, ledger::film_of(k), 0x1p-53);
  }
  CHECK(l.total() == 1 + 0x1p-41);
}

TEST_CASE("the reservoir does not lose drops either") {
  ledger l;
  l.introduce(1);
  for (int k = 0; k < 4096; ++k) l.introduce(0x1p-53);
  CHECK(l.balance(reservoir) == 1 + 0x1p-41);
}

TEST_CASE("the reservoir lets a full distribution overdraw it by round-off and still sums to zero") {
  ledger l;
  l.resize_films(49);
  l.introduce(1);
  for (std::size_t k = 0; k < 49; ++k) l.transfer(reservoir, ledger::film_of(k), 1.0 / 49);
  CHECK(std::abs(l.balance(reservoir)) < 2e-16);
  CHECK(l.total() == 1);
  for (std::size_t k = 0; k < 49; ++k) l.empty(ledger::film_of(k), reservoir);
  CHECK(l.balance(reservoir) == within(1e-15, 1));
}

TEST_CASE("films follow their grains") {
  ledger l = with_films(4);
  l.permute_films(std::array<std::size_t, 4>{2, 0, 3, 1});
  CHECK((l.films()[0] == 3 && l.films()[1] == 1 && l.films()[2] == 4 && l.films()[3] == 2));
}

TEST_CASE("bonds follow their pairs, and what has no pair any more is named and kept") {
  ledger l = with_bonds(5);
  // Rows 3 and 1 go on, row 0 of the new list is new; 0, 2 and 4 are not in it.
  const auto lost = l.carry_bonds(std::array<std::int32_t, 3>{-1, 3, 1}, 8);
  CHECK(lost == std::vector<std::size_t>{0, 2, 4});
  CHECK((l.bonds().size() == 8 && l.bonds()[0] == 0 && l.bonds()[1] == 4 && l.bonds()[2] == 2 && l.bonds()[3] == 0));
  CHECK(l.balance(reservoir) == 1 + 3 + 5);
  CHECK(l.total() == 15);
  CHECK(l.carry_bonds(std::array<std::int32_t, 3>{2, 1, 0}, 8).empty());
  CHECK((l.bonds()[0] == 2 && l.bonds()[1] == 4));
}

TEST_CASE("the books can be put back account by account") {
  ledger l = with_films(2);
  l.transfer(ledger::film_of(1), reservoir, 0.7);
  ledger again;
  again.resize_films(2);
  again.restore(l.keep());
  for (const std::size_t k : {0u, 1u}) again.restore(ledger::film_of(k), l.films()[k]);
  CHECK((again.total() == l.total() && again.introduced() == 3 && again.balance(reservoir) == l.balance(reservoir)));
  CHECK_THROWS_AS(again.restore(ledger::film_of(0), 1), input_error);
}

TEST_CASE("a hundred thousand random transfers between films and bonds of all sizes conserve the liquid") {
  boost::random::mt19937_64 random(7);
  boost::random::uniform_int_distribution<std::size_t> row(0, 39);
  boost::random::uniform_real_distribution<double> power(-12, 0);
  ledger l;
  l.resize_films(40);
  l.carry_bonds({}, 40);
  l.introduce(1);
  for (std::size_t k = 0; k < 40; ++k) l.transfer(reservoir, ledger::film_of(k), 0.025);
  const auto any = [&] {
    const std::size_t k = row(random);
    return k == 0 ? reservoir : k % 2 == 0 ? ledger::film_of(row(random)) : ledger::bond_of(row(random));
  };
  double lowest = 0;
  for (int k = 0; k < 100000; ++k) {
    const auto from = any(), to = any();
    const double wanted = std::pow(10.0, power(random));
    const bool gives = from.what != ledger::kind::reservoir;
    l.transfer(from, to, gives ? wanted : std::min(wanted, std::max(l.balance(from), 0.0)));
    if (gives) lowest = std::min(lowest, l.balance(from));
  }
  CHECK(lowest == 0);
  CHECK(std::abs(l.total() - 1) < 1e-13);
  CHECK(l.introduced() == 1);
}

TEST_CASE("the name of an account outside is one line, of which another opens nothing") {
  ledger l;
  l.resize_films(1);
  CHECK_THROWS_WITH(l.open_outside("rain\nsnow"),
                    "the name of an account outside of the scene, \"rain\nsnow\", must be "
                    "on one line (see docs/reference/liquid.md)");
  CHECK(l.outside().empty());
  l.open_outside("rain and snow");
  CHECK(l.outside().size() == 1);
}
