// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/core/expects.hpp>
#include <pendular/laplace_young/continuation.hpp>

namespace pendular::laplace_young::detail {

/// A bridge between touching bodies, followed in volume from one so small that the bodies are nearly parallel there.
inline std::optional<vector6> touching(const geometry<double>& g, double volume) {
  const double pi = boost::math::constants::pi<double>();
  const double bend = g.curvature_i + g.curvature_j;
  const double cube = 1 / (bend * bend * bend);
  double now = std::min(std::log(volume), std::log(1e-4 * cube));
  const double line = std::pow(4 * std::exp(now) / (pi * bend), 0.25), height = 0.5 * bend * line * line;
  const double opening = pi - 2 * g.contact_angle;
  vector6 z;
  z << std::log(line), std::log(line), opening - bend * line - height / line,
      std::log(height * 0.5 * opening / std::cos(g.contact_angle)), now, 0;
  const corrector newton(g, held::volume);
  const auto closed = corrector::at(gap, 0);
  auto found = newton.solve(z, now, closed);
  double step = 2;
  while (found && now < std::log(volume)) {
    vector6 larger = *found;
    const point here = newton.with_tangent(*found, closed);
    if (here.singularity == 0) return std::nullopt;
    const double next = std::min(now + step, std::log(volume));
    larger[log_arc_i] += 0.25 * (next - now);
    larger[log_arc_j] += 0.25 * (next - now);
    larger[log_length] += 0.5 * (next - now);
    larger[log_volume] = next;
    if (const auto z_next = newton.solve(larger, next, closed)) {
      found = z_next;
      now = next;
      step = std::min(2.0, 1.5 * step);
    } else if ((step *= 0.5) < 1e-3) {
      return std::nullopt;
    }
  }
  return found;
}

/// The bridges of one pair at one volume or suction, from contact to where they lose their stability at a fixed gap.
/// Points are made as they are asked for.
class branch {
 public:
  branch(const geometry<double>& g, held h, const vector6& start) : newton_(g, h) {
    held_value_ = newton_.hold(start);
    points_.push_back(newton_.with_tangent(start, corrector::at(gap, 0)));
    sign_ = points_.front().singularity > 0 ? 1 : -1;
  }

  /// The bridge at this gap, or nothing beyond the end of the branch.
  std::optional<vector6> at(double distance) {
    while (!ended_ && points_.back().z[gap] < distance) advance();
    const double end = points_.back().z[gap];
    if (distance > end * (1 + 1e-15)) return std::nullopt;
    if (distance >= end) return points_.back().z;
    if (distance == points_.front().z[gap]) return points_.front().z;
    const auto above = [&] {
      return std::upper_bound(points_.begin() + 1, points_.end() - 1, distance,
                              [](double d, const point& p) { return d < p.z[gap]; });
    };
    for (int halvings = 0; halvings < 50; ++halvings) {
      const auto next = above();
      const auto [inside, predicted] = predict(*(next - 1), *next, distance);
      if (const auto z = newton_.solve(predicted, held_value_, corrector::at(gap, distance));
          z && is_near(*z, predicted)) {
        return z;
      }
      if (!insert(next, inside)) return next->z;  // as near as a double can tell
    }
    throw run_error("the Laplace-Young solver does not converge at a gap of " + pendular::detail::number(distance) +
                    " times the smaller radius (see docs/reference/laplace_young.md)");
  }

  /// The last stable bridge.
  const vector6& last() {
    while (!ended_) advance();
    return points_.back().z;
  }

 private:
  bool stable(const point& p) const { return p.singularity * sign_ > 0 && p.ahead[gap] > 0; }

  static bool is_near(const vector6& a, const vector6& b) { return (a - b).cwiseAbs().maxCoeff() < 0.3; }

  std::optional<point> step_from(const point& p, double step) const {
    const vector6 guess = p.z + step * p.ahead;
    const auto z = newton_.solve(guess, held_value_, {p.ahead, p.ahead.dot(p.z) + step});
    if (!z) return std::nullopt;
    const point next = newton_.with_tangent(*z, {p.ahead, 0});
    const double cosine = next.ahead.dot(p.ahead);
    if (cosine < 0.95) return std::nullopt;
    // A smooth curve turns by twice the angle under which it leaves its tangent: else this is another branch.
    const double turned = std::sqrt(2 * std::max(1 - cosine, 0.0));
    if ((*z - guess).norm() > step * (0.75 * turned + 0.05 * step + 1e-8) + 1e-11) return std::nullopt;
    return next;
  }

  void advance() {
    const point from = points_.back();
    while (step_ > 1e-9) {
      const auto next = step_from(from, step_);
      if (!next) {
        step_ *= 0.5;
      } else if (stable(*next)) {
        points_.push_back(*next);
        step_ = std::min(1.5 * step_, 0.6);
        return;
      } else if (next->singularity * sign_ <= 0) {
        end_within(from, step_);
        if (ended_ || points_.back().z[gap] > from.z[gap]) return;
      } else {
        step_ *= 0.5;  // more than one singular point passed
      }
    }
    ended_ = true;
  }

  void end_within(const point& from, double step) {
    const auto f = [&](double s) {
      const auto p = step_from(from, s);
      return p ? p->singularity * sign_ : -1.0;
    };
    std::uintmax_t iterations = 80;
    const auto tight = [](double a, double b) { return std::abs(b - a) < 1e-14; };
    const auto [low, high] =
        boost::math::tools::toms748_solve(f, 0.0, step, from.singularity * sign_, f(step), tight, iterations);
    const auto p = step_from(from, low);
    const bool ahead = p && p->z[gap] > from.z[gap];
    if (p && std::abs(p->singularity) <= 1e-6 * std::abs(from.singularity)) {
      if (ahead) points_.push_back(*p);
      ended_ = true;
      return;
    }
    // Nearly equal bodies: a step can cross to the branch beyond a sharp turn. Go up to the turn and take it slowly.
    if (ahead && stable(*p)) points_.push_back(*p);
    step_ = 0.02 * step;
  }

  struct prediction {
    double inside;  // part of the way from a to b
    vector6 z;
  };

  /// Cubic through a and b along their tangents, where it has the gap.
  static prediction predict(const point& a, const point& b, double distance) {
    const double chord = (b.z - a.z).norm();
    const auto curve = [&](double t) {
      const double h = t * t * (3 - 2 * t);
      return vector6(a.z + h * (b.z - a.z) + chord * t * (1 - t) * ((1 - t) * a.ahead - t * b.ahead));
    };
    double low = 0, high = 1;
    for (int k = 0; k < 50; ++k) {
      const double middle = 0.5 * (low + high);
      (curve(middle)[gap] < distance ? low : high) = middle;
    }
    return {low, curve(low)};
  }

  bool insert(std::vector<point>::iterator next, double inside) {
    const point& a = *(next - 1);
    const double span = a.ahead.dot(next->z - a.z);
    if (span < 1e-12) return false;
    const auto middle = step_from(a, span * std::clamp(inside, 0.05, 0.95));
    if (!middle) return false;
    points_.insert(next, *middle);
    return true;
  }

  corrector newton_;
  double held_value_ = 0, sign_ = 1, step_ = 0.1;
  std::vector<point> points_;
  bool ended_ = false;
};

}  // namespace pendular::laplace_young::detail
