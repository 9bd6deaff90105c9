// SPDX-License-Identifier: BSD-3-Clause
#include "../catch.hpp"

#include <pendular/core/strided.hpp>

#include <algorithm>
#include <array>
#include <iterator>
#include <type_traits>
#include <vector>

using namespace pendular;

namespace {
struct row {
  int key;
  double value;
  char mark;
};
static_assert(std::random_access_iterator<strided<double>::iterator>);
static_assert(std::random_access_iterator<strided<const double>::iterator>);
static_assert(std::is_convertible_v<strided<double>, strided<const double>>);
static_assert(!std::is_convertible_v<strided<const double>, strided<double>>);
static_assert(!std::is_convertible_v<const std::vector<double>&, strided<double>>);

strided<double> values_of(std::vector<row>& rows) { return {&rows[0].value, rows.size(), sizeof(row)}; }
}  // namespace

TEST_CASE("a member of every row is read and written as a column") {
  std::vector<row> rows{{1, 0.5, 'a'}, {2, -3, 'b'}, {3, 7, 'c'}, {4, 2, 'd'}};
  const auto values = values_of(rows);
  CHECK((values.size() == 4 && !values.empty() && values[1] == -3));
  values[1] = 9;
  for (double& v : values) v *= 2;
  CHECK((rows[0].value == 1 && rows[1].value == 18 && rows[3].value == 4));
  CHECK((rows[1].key == 2 && rows[1].mark == 'b'));
  const strided<const double> read = values;
  CHECK((&read[2] == &rows[2].value && read.stride() == sizeof(row)));
}

TEST_CASE("its iterators do what algorithms ask of them") {
  std::vector<row> rows{{1, 0.5, 'a'}, {2, -3, 'b'}, {3, 7, 'c'}, {4, 2, 'd'}};
  const auto values = values_of(rows);
  CHECK(std::min_element(values.begin(), values.end()) - values.begin() == 1);
  CHECK((values.end() - values.begin() == 4 && values.begin()[2] == 7 && *(values.end() - 1) == 2));
  CHECK((values.begin() < values.end() && values.begin() + 4 == values.end()));
  std::sort(values.begin(), values.end());
  CHECK((rows[0].value == -3 && rows[3].value == 7 && rows[0].key == 1));
}

TEST_CASE("what follows each other is a column too, and so is nothing") {
  std::vector<double> numbers{1, 2, 3};
  const std::array<double, 2> fixed{4, 5};
  const strided<double> own = numbers;
  const strided<const double> other = fixed;
  own[2] = 6;
  CHECK((numbers[2] == 6 && other[1] == 5 && own.size() == 3));
  const strided<const double> none;
  CHECK((none.empty() && none.begin() == none.end()));
  const strided<const double> of_none = strided<double>{};
  CHECK(of_none.empty());
}
