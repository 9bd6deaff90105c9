// SPDX-License-Identifier: BSD-3-Clause
#include "../catch.hpp"

#include <pendular/core/quad.hpp>

#include <array>
#include <vector>

using namespace pendular;

namespace {
quad numbers_of(int row) {
  const double n = row;
  return {n, n + 0.25, n + 0.5, n + 0.75};
}
}  // namespace

TEST_CASE("rows are gathered number by number, whatever their order") {
  std::vector<quad> rows;
  for (int k = 0; k < 20; ++k) rows.push_back(numbers_of(k));
  const std::array<std::int32_t, 8> wanted{3, 19, 0, 7, 7, 12, 1, 18};
  const quad_block found = gather(rows.data(), wanted.data());
  for (int lane = 0; lane < lane_count; ++lane) {
    const quad expected = numbers_of(wanted[static_cast<std::size_t>(lane)]);
    CHECK((found.a[lane] == expected.a && found.b[lane] == expected.b));
    CHECK((found.c[lane] == expected.c && found.d[lane] == expected.d));
  }
}

TEST_CASE("lanes are stored as rows that follow each other, and nothing beside them") {
  std::vector<quad> rows(10, quad{-1, -1, -1, -1});
  quad_block values;
  for (int lane = 0; lane < lane_count; ++lane) {
    const quad q = numbers_of(10 * lane);
    values.a.set(lane, q.a), values.b.set(lane, q.b), values.c.set(lane, q.c), values.d.set(lane, q.d);
  }
  store(rows.data() + 1, values);
  for (int lane = 0; lane < lane_count; ++lane) {
    const quad found = rows[static_cast<std::size_t>(lane) + 1], expected = numbers_of(10 * lane);
    CHECK((found.a == expected.a && found.b == expected.b && found.c == expected.c && found.d == expected.d));
  }
  CHECK((rows[0].a == -1 && rows[0].d == -1 && rows[9].a == -1 && rows[9].d == -1));
}

TEST_CASE("two quads of every lane become one row of eight numbers") {
  std::vector<octet> rows(9);
  quad_block low, high;
  for (int lane = 0; lane < lane_count; ++lane) {
    const quad l = numbers_of(lane), h = numbers_of(100 + lane);
    low.a.set(lane, l.a), low.b.set(lane, l.b), low.c.set(lane, l.c), low.d.set(lane, l.d);
    high.a.set(lane, h.a), high.b.set(lane, h.b), high.c.set(lane, h.c), high.d.set(lane, h.d);
  }
  store(rows.data() + 1, low, high);
  for (int lane = 0; lane < lane_count; ++lane) {
    const octet& found = rows[static_cast<std::size_t>(lane) + 1];
    const quad l = numbers_of(lane), h = numbers_of(100 + lane);
    CHECK((found.low.a == l.a && found.low.b == l.b && found.low.c == l.c && found.low.d == l.d));
    CHECK((found.high.a == h.a && found.high.b == h.b && found.high.c == h.c && found.high.d == h.d));
  }
  CHECK((rows[0].low.a == 0 && rows[0].high.d == 0));
}
