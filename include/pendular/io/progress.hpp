// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <iostream>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace pendular::io {

/// Where and how often progress is shown. The default is standard error, as a terminal or a log file needs it.
struct progress_options {
  std::ostream* sink = &std::cerr;
  bool terminal = ::isatty(STDERR_FILENO) != 0;  // one line drawn over and over, else plain lines
  std::size_t width = 0;                         // characters in a line of the terminal; 0: as it says
  double refresh = 0.2;                          // between drawings on a terminal, s
  double interval = 10;                          // between plain lines, s
  std::function<double()> clock = [] {           // s, from any origin
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  };
};

/// Bar, percentage, stage, time gone, time left and a remark. update() may be called at every step: it reads the
/// clock and returns unless a drawing is due.
class progress {
 public:
  using options = progress_options;

  /// `total` in any unit of work (steps, s); `done` is what an earlier run has completed.
  explicit progress(std::string stage, double total, double done = 0, options chosen = {})
      : options_{std::move(chosen)} {
    begin(std::move(stage), total, done);
  }

  progress(const progress&) = delete;
  progress& operator=(const progress&) = delete;

  /// Ends the line; a stage left by an exception is shown as far as it came.
  ~progress() {
    try {
      if (open_) end();
    } catch (...) {  // a sink that throws must not end the program from here
    }
  }

  /// Ends the stage under way and starts another.
  void begin(std::string stage, double total, double done = 0) {
    if (open_) end();
    stage_ = std::move(stage);
    note_.clear();
    total_ = total;
    first_ = done_ = done;
    started_ = options_.clock();
    next_ = started_ + (options_.terminal ? 0 : options_.interval);
    open_ = true;
  }

  void update(double done) {
    update(done, [] { return std::string_view{}; });
  }

  void update(double done, std::string_view note) {
    update(done, [note] { return note; });
  }

  /// `note` makes the remark, for instance the stress; it is called only when a drawing is due.
  template <std::invocable F>
    requires std::convertible_to<std::invoke_result_t<F>, std::string_view>
  void update(double done, F note) {
    done_ = done;
    const double now = options_.clock();
    if (!open_ || now < next_) return;
    note_ = std::string{note()};
    next_ = now + (options_.terminal ? options_.refresh : options_.interval);
    draw(now);
  }

  /// Shows the stage as complete and ends the line.
  void finish() {
    if (!open_) return;
    done_ = total_;
    end();
  }

  void finish(std::string_view note) {
    note_ = note;
    finish();
  }

 private:
  options options_;
  std::string stage_;
  std::string note_;
  double total_ = 0;
  double done_ = 0;
  double first_ = 0;    // done_ when the stage began
  double started_ = 0;  // s
  double next_ = 0;     // time of the next drawing, s
  bool open_ = false;

  static constexpr std::size_t bar_width = 24;
  static constexpr std::size_t plain_width = 500;

  static std::string duration(double seconds) {
    if (!(seconds < 1e8)) return "--:--";
    const long whole = std::lround(seconds);
    std::array<char, 32> text;
    if (whole < 3600) std::snprintf(text.data(), text.size(), "%02ld:%02ld", whole / 60, whole % 60);
    else std::snprintf(text.data(), text.size(), "%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
    return text.data();
  }

  double fraction() const { return total_ > 0 ? std::clamp(done_ / total_, 0.0, 1.0) : 1.0; }

  std::string line(double now) const {
    const double elapsed = now - started_;
    const double left = done_ >= total_ ? 0 : elapsed * (total_ - done_) / std::max(done_ - first_, 0.0);
    const auto filled = static_cast<std::size_t>(fraction() * bar_width);
    std::string bar(bar_width, ' ');
    std::fill_n(bar.begin(), filled, '=');
    if (filled < bar_width) bar[filled] = '>';
    const std::string percent = std::to_string(static_cast<int>(100 * fraction()));
    return stage_ + " [" + bar + "] " + std::string(3 - percent.size(), ' ') + percent + " %  elapsed " +
           duration(elapsed) + "  left " + duration(left) + (note_.empty() ? "" : "  " + note_);
  }

  /// Characters of the terminal's line that can be used without wrapping.
  std::size_t terminal_width() const {
    if (options_.width > 0) return options_.width - 1;
    ::winsize size{};
    if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col < 2) return plain_width;
    return size.ws_col - std::size_t{1};
  }

  void draw(double now) {
    if (options_.terminal) *options_.sink << '\r' << line(now).substr(0, terminal_width()) << "\x1b[K" << std::flush;
    else *options_.sink << line(now) << std::endl;
  }

  void end() {
    open_ = false;
    draw(options_.clock());
    if (options_.terminal) *options_.sink << std::endl;
  }
};

}  // namespace pendular::io
