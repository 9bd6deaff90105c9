// SPDX-License-Identifier: BSD-3-Clause
#include <pendular/io/progress.hpp>

#include <algorithm>
#include <chrono>
#include <sstream>
#include <string>

#include "scratch.hpp"

using pendular::io::progress;

namespace {

/// A sink and a clock set by hand.
struct bench {
  std::ostringstream text;
  double now = 1000;  // s

  progress::options options(bool terminal) {
    progress::options chosen;
    chosen.sink = &text;
    chosen.terminal = terminal;
    chosen.width = 100;
    chosen.clock = [this] { return now; };
    return chosen;
  }

  auto count(char c) const {
    const std::string all = text.str();
    return std::count(all.begin(), all.end(), c);
  }
};

}  // namespace

TEST_CASE("a log file gets one plain line per interval", "[io][progress]") {
  bench b;
  {
    progress shown{"shear", 1000, 0, b.options(false)};
    for (int step = 1; step <= 250; ++step) {
      b.now += 0.1;
      shown.update(step, "stress 101 Pa");
    }
    CHECK(b.count('\n') == 2);
    CHECK(b.count('\r') == 0);
    CHECK(b.text.str().find("shear [==>") == 0);
    CHECK(scratch::mentions(b.text.str(), {" 10 %  elapsed 00:10  left 01:30  stress 101 Pa\n"}));
    shown.finish("done");
    shown.finish();
  }
  CHECK(b.count('\n') == 3);
  CHECK(scratch::mentions(b.text.str(), {"[========================] 100 %  elapsed 00:25  left 00:00  done\n"}));
}

TEST_CASE("a terminal gets one line drawn over and over, and its end", "[io][progress]") {
  bench b;
  {
    progress shown{"pack", 10, 0, b.options(true)};
    for (int step = 1; step <= 5; ++step) {
      b.now += 1;
      shown.update(step);
    }
    CHECK(b.count('\r') == 5);
    CHECK(b.count('\n') == 0);
  }
  CHECK(b.count('\n') == 1);
  CHECK(b.text.str().back() == '\n');
  CHECK(scratch::mentions(b.text.str(), {" 50 %  elapsed 00:05  left 00:05"}));
  CHECK(b.text.str().find("100 %") == std::string::npos);
}

TEST_CASE("a terminal's line does not wrap", "[io][progress]") {
  bench b;
  progress::options chosen = b.options(true);
  chosen.width = 20;
  progress shown{"pack", 10, 0, chosen};
  shown.update(5, "a long remark");
  CHECK(b.text.str() == "\rpack [============>\x1b[K");
}

TEST_CASE("the time left of a resumed stage counts only what this run has done", "[io][progress]") {
  bench b;
  progress shown{"shear", 100'000, 90'000, b.options(false)};
  b.now += 20;
  shown.update(90'020);
  CHECK(scratch::mentions(b.text.str(), {" 90 %  elapsed 00:20  left 2:46:20"}));
  shown.begin("unload", 10);
  b.now += 15;
  shown.update(0);
  CHECK(scratch::mentions(b.text.str(), {"unload [>", "  0 %  elapsed 00:15  left --:--\n"}));
}

TEST_CASE("the remark is made only when it is drawn, and an update is cheap", "[io][progress]") {
  bench b;
  int made = 0;
  progress::options chosen = b.options(false);
  chosen.clock = progress::options{}.clock;
  progress shown{"shear", 1e6, 0, chosen};
  const auto start = std::chrono::steady_clock::now();
  for (int step = 0; step < 100'000; ++step)
    shown.update(step, [&] {
      ++made;
      return std::string{"stress"};
    });
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds{2});
  CHECK(made == 0);
}
