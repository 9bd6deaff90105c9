// SPDX-License-Identifier: BSD-3-Clause
#include <pendular/io/table.hpp>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "scratch.hpp"

namespace io = pendular::io;

TEST_CASE("a table comes back to the last bit", "[io][table]") {
  const scratch::folder folder;
  using limits = std::numeric_limits<double>;
  const std::vector<double> odd{0.1,
                                limits::denorm_min(),
                                -limits::max(),
                                limits::infinity(),
                                -limits::infinity(),
                                -0.0,
                                1.0 / 3,
                                limits::quiet_NaN(),
                                1e23};
  std::vector<double> count(odd.size(), 2.5);
  io::write_table(folder / "t.csv", io::table{std::vector<io::column>{{"stress, \"normal\" (Pa)", odd}, {"n", count}}});
  const io::table back = io::read_table(folder / "t.csv");
  REQUIRE(back.rows() == odd.size());
  CHECK(back["n"] == count);
  const auto& stress = back["stress, \"normal\" (Pa)"];
  for (std::size_t i = 0; i < odd.size(); ++i) {
    INFO(i);
    CHECK((std::isnan(odd[i]) ? std::isnan(stress[i]) : std::memcmp(&odd[i], &stress[i], sizeof(double)) == 0));
  }
}

TEST_CASE("a table is plain text with the shortest numbers", "[io][table]") {
  const scratch::folder folder;
  io::table data{"time (s)", "stress (Pa)"};
  data.add_row({0.1, 100});
  data.add_row({0.2, 1e-7});
  io::write_table(folder / "t.csv", data);
  CHECK(scratch::content(folder / "t.csv") == "time (s),stress (Pa)\n0.1,100\n0.2,1e-07\n");
}

TEST_CASE("tables of other programs are read", "[io][table]") {
  const scratch::folder folder;
  scratch::write(folder / "t.csv", "\xEF\xBB\xBF\"a, b\",c\r\n +1.5 ,-2e3\r\n3,NaN\r\n\n");
  const io::table data = io::read_table(folder / "t.csv");
  CHECK(data.rows() == 2);
  CHECK(data["a, b"] == std::vector<double>{1.5, 3});
  CHECK(data["c"][0] == -2000);
  CHECK(std::isnan(data["c"][1]));
  CHECK(data.has("c"));
  CHECK_FALSE(data.has("C"));
  scratch::write(folder / "h.csv", "a,b");
  CHECK(io::read_table(folder / "h.csv").rows() == 0);
}

TEST_CASE("a table that cannot be read says where", "[io][table]") {
  const scratch::folder folder;
  const auto said = [&](const std::string& text) {
    scratch::write(folder / "t.csv", text);
    return scratch::message<std::runtime_error>([&] { io::read_table(folder / "t.csv"); });
  };
  CHECK(scratch::mentions(said("a,b\n1,2\n3\n"), {"t.csv", "1 values in line 3", "2 columns"}));
  CHECK(scratch::mentions(said("a,b\n1,2,3\n"), {"3 values in line 2"}));
  CHECK(scratch::mentions(said("a\n1\n\n2\n"), {"line 3"}));
  CHECK(scratch::mentions(said("a,b\n1,2\n3,four\n"), {"'four'", "line 3", "column 'b'"}));
  CHECK(scratch::mentions(said("a,b\n1,2x\n"), {"'2x'"}));
  CHECK(scratch::mentions(said("a,b\n1,\n"), {"''", "column 'b'"}));
  CHECK(scratch::mentions(said("a,a\n"), {"two columns 'a'"}));
  CHECK(scratch::mentions(said("a,,c\n"), {"column 2"}));
  CHECK(scratch::mentions(said(""), {"cannot be read"}));
  CHECK(scratch::mentions(scratch::message<std::runtime_error>([&] { io::read_table(folder / "no.csv"); }),
                          {"no.csv", "cannot be read"}));
}

TEST_CASE("a wrong table is not written", "[io][table]") {
  const scratch::folder folder;
  const auto said = [&](std::vector<io::column> columns) {
    return scratch::message<std::runtime_error>([&] { io::write_table(folder / "t.csv", io::table{columns}); });
  };
  CHECK(scratch::mentions(said({{"a", {1, 2}}, {"b", {1}}}), {"1 values in 'b'", "2 in 'a'"}));
  CHECK(scratch::mentions(said({{"a", {}}, {"a", {}}}), {"two columns"}));
  CHECK(scratch::mentions(said({{"a\nb", {}}}), {"name"}));
  CHECK(scratch::mentions(said({}), {"no columns"}));
  CHECK(folder.files() == 0);

  io::table data{"a", "b"};
  CHECK(scratch::mentions(scratch::message<std::invalid_argument>([&] { data.add_row({1}); }), {"1 values", "2"}));
  CHECK(scratch::mentions(scratch::message<std::out_of_range>([&] { data["c"]; }), {"'c'", "'a', 'b'"}));
}
