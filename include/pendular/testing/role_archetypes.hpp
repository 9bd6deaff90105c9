// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pendular/boundary/concepts.hpp>
#include <pendular/core/none.hpp>
#include <pendular/liquid/liquid.hpp>
#include <pendular/motion/velocity_verlet.hpp>
#include <pendular/space/grains.hpp>

#include <cmath>
#include <cstdint>
#include <string_view>
#include <tuple>

namespace pendular::testing::archetype {

// The least that the concepts of roles other than laws ask for: no default constructor, no comparison, nothing optional.

class integrator {
 public:
  static constexpr double velocity_lag = 0;
  double time_step;  // s
  vector gravity;    // m/s2

  integrator(double step, const vector& g) : time_step(step), gravity(g) {}
  void predict(vector& position, vector& velocity, const vector& acceleration) const {
    velocity += time_step * acceleration;
    position += time_step * velocity;
  }
  void predict_spin(vector& spin, const vector& acceleration) const { spin += time_step * acceleration; }
  void correct(vector&, const vector&, const vector&) const {}
  static double stable_step(double omega2, double rate) { return 2 / (std::sqrt(omega2 + rate * rate) + rate); }
};

class geometry {
 public:
  explicit geometry(double height) : height_(height) {}
  template <Scalar T>
  boundary::meeting<T> meet(const Vec3<T>& centre, const T& radius) const {
    return {centre.z - T(height_) - radius, {T(0), T(0), T(-1)}};
  }
  void rise(double way) { height_ += way; }

 private:
  double height_;  // m
};

/// All points alike.
class drive {
 public:
  vector velocity;  // m/s

  explicit drive(double speed) : velocity{0, 0, speed} {}
  void move(geometry& floor, const vector&, double time_step) { floor.rise(time_step * velocity.z); }
};

/// Every point on its own.
class drive_of_points {
 public:
  explicit drive_of_points(double rate) : rate_(rate) {}
  template <Scalar T>
  Vec3<T> velocity_at(const Vec3<T>& p) const {
    return {T(-rate_) * p.y, T(rate_) * p.x, T(0)};
  }
  vector pivot() const { return {0, 0, 0}; }
  double approach_speed() const { return 0; }
  void move(geometry&, const boundary::wall_load&, double) {}

 private:
  double rate_;  // rad/s
};

template <class Drive>
class wall {
 public:
  static constexpr bool is_wettable = false;
  geometry shape;
  Drive drive;
  none material;
  vector force{0, 0, 0};  // N
  double work = 0;        // J

  wall(const geometry& s, const Drive& d) : shape(s), drive(d) {}
  double approach_speed() const { return boundary::approach_speed(drive); }
  void move(double time_step) {
    if constexpr (boundary::HasOneVelocity<Drive>) {
      drive.move(shape, force, time_step);
    } else {
      drive.move(shape, boundary::wall_load{}, time_step);
    }
  }
  void take(const boundary::wall_load& now, double time_step) {
    if constexpr (boundary::HasOneVelocity<Drive>) {
      work -= time_step * dot(now.force, drive.velocity);
    } else {
      work += time_step * now.power;
    }
    force = now.force;
  }
};

class boundary_of_two {
 public:
  explicit boundary_of_two(double height)
      : floor_(geometry(height), archetype::drive(0)), disc_(geometry(height - 1), drive_of_points(1)) {}
  auto parts() { return std::tie(floor_, disc_); }
  auto parts() const { return std::tie(floor_, disc_); }

 private:
  wall<archetype::drive> floor_;
  wall<drive_of_points> disc_;
};

class formation_rule {
 public:
  double minimum_volume;

  explicit formation_rule(double least) : minimum_volume(least) {}
  double reach(double rupture_distance) const { return 0.5 * rupture_distance; }
};

/// Gives a share of the film in equal parts.
class local_protocol {
 public:
  explicit local_protocol(double share) : share_(share) {}

  class offer_of_one {
   public:
    explicit offer_of_one(double bonds) : number(bonds) {}
    double number;
  };
  class grant {
   public:
    explicit grant(double each) : volume(each) {}
    double volume;  // m3
  };
  offer_of_one offer(const bond_side&) const { return offer_of_one(1); }
  offer_of_one merge(const offer_of_one& a, const offer_of_one& b) const { return offer_of_one(a.number + b.number); }
  grant settle(const offer_of_one& all, double film) const { return grant(share_ * film / all.number); }
  double pull(const bond_side&, const grant& g) const { return g.volume; }

 private:
  double share_;
};

class global_protocol {
 public:
  std::int64_t period;

  explicit global_protocol(std::int64_t steps) : period(steps) {}
  template <class Door>
  void redistribute(Door& door) const {
    door.for_each_bridge([&](std::size_t pair) { door.break_bridge(pair); });
  }
};

class source {
 public:
  static constexpr std::string_view account = "archetype";
  std::int64_t period;

  explicit source(std::int64_t steps) : period(steps) {}
  template <class Door>
  void act(Door& door) const {
    door.for_each_grain([&](std::size_t grain) { door.dry_grain(grain, door.film(grain)); });
  }
};

/// Looks at steps and nothing else.
class observer {
 public:
  explicit observer(std::int64_t& count) : count_(&count) {}
  template <class System>
  void operator()(const System&) {
    ++*count_;
  }

 private:
  std::int64_t* count_;
};

struct grain_tag {
  grain_tag() = delete;
  using type = double;
  static constexpr std::string_view label = "archetype", unit = "1";
};

}  // namespace pendular::testing::archetype
