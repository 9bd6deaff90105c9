// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A user's host, written from outside: a packing cut into slabs along x, one thread each, which tell each other by plain
// function calls what ranks of a distributed run would send.

#include <pendular/core/host.hpp>

#include <algorithm>
#include <array>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <mutex>
#include <span>
#include <thread>
#include <unordered_map>
#include <utility>
#include <vector>

/// Where threads wait until all have come. (std::barrier of g++ 12 polls, which takes long on a busy machine.)
class meeting_place {
 public:
  explicit meeting_place(std::size_t threads) : threads_(threads) {}
  void wait_for_all() {
    std::unique_lock lock(mutex_);
    const std::size_t round = round_;
    if (++came_ == threads_) {
      came_ = 0;
      ++round_;
      all_came_.notify_all();
    } else {
      all_came_.wait(lock, [&] { return round_ != round; });
    }
  }

 private:
  std::mutex mutex_;
  std::condition_variable all_came_;
  std::size_t threads_, came_ = 0, round_ = 0;
};

/// What the slabs share.
class slab_house {
 public:
  /// Where slabs meet, in ascending order, m.
  explicit slab_house(std::vector<double> borders)
      : borders_(std::move(borders)), shown_(size()), said_{std::vector<double>(size()), std::vector<double>(size())},
        rooms_(size()), gate_(size()) {}

  std::size_t size() const { return borders_.size() + 1; }
  double begin(std::size_t slab) const {
    return slab == 0 ? -std::numeric_limits<double>::infinity() : borders_[slab - 1];
  }
  double end(std::size_t slab) const { return slab + 1 == size() ? -begin(0) : borders_[slab]; }
  /// How many grains have changed their slab.
  std::size_t migrations() const { return migrations_; }

 private:
  friend class slab;
  struct room {
    std::unordered_map<std::int64_t, std::size_t> row_of;  // of the kept grains
    std::size_t questions = 0;
    std::vector<std::size_t> copies, keepers, keeper_rows;  // row of every copy, who keeps it, and in which row
  };

  std::vector<double> borders_;
  std::vector<const void*> shown_;
  std::array<std::vector<double>, 2> said_;
  std::vector<room> rooms_;
  meeting_place gate_;
  std::size_t migrations_ = 0;
};

/// One of them, as pendular sees it.
class slab {
 public:
  slab(slab_house& house, std::size_t place) : house_(&house), place_(place) {}

  std::size_t place() const { return place_; }
  bool leads() const { return place_ == 0; }
  bool any(bool flag) const { return most(flag ? 1 : 0) > 0; }
  /// One gate is enough: nobody can be two questions ahead, and the next one is asked in the other bank.
  double most(double value) const {
    auto& room = house_->rooms_[place_];
    auto& bank = house_->said_[room.questions++ % 2];
    bank[place_] = value;
    house_->gate_.wait_for_all();
    return *std::max_element(bank.begin(), bank.end());
  }
  void sum(std::span<pendular::reproducible_sum> sums) const {
    const std::vector<pendular::reproducible_sum> own(sums.begin(), sums.end());
    look_at_all(own, [&](std::size_t from, const auto& other) {
      for (std::size_t k = 0; k < sums.size(); ++k) {
        if (from != place_) sums[k].join(other[k]);
      }
    });
  }

  void update_copies(std::span<double> numbers, std::size_t width) const {
    const auto& room = house_->rooms_[place_];
    const double* const own = numbers.data();
    std::vector<double> received(width * room.copies.size());
    const auto copy = [&](std::size_t from, const double* const& other) {
      for (std::size_t k = 0; k < room.copies.size(); ++k) {
        if (room.keepers[k] != from) continue;
        std::memcpy(&received[k * width], other + room.keeper_rows[k] * width, width * sizeof(double));
      }
    };
    look_at_all(own, copy);
    for (std::size_t k = 0; k < room.copies.size(); ++k) {
      std::memcpy(&numbers[room.copies[k] * width], &received[k * width], width * sizeof(double));
    }
  }

  bool keeps(const pendular::vector& x) const { return house_->begin(place_) <= x.x && x.x < house_->end(place_); }

  std::size_t exchange(std::vector<pendular::parcel>& parcels, double reach) const {
    std::vector<pendular::parcel> kept, copies;
    std::size_t arrived = 0;
    look_at_all(parcels, [&](std::size_t from, const std::vector<pendular::parcel>& all) {
      for (const pendular::parcel& p : all) {
        const bool near = house_->begin(place_) - reach <= p.position.x && p.position.x <= house_->end(place_) + reach;
        if (keeps(p.position)) kept.push_back(p);
        else if (near) copies.push_back(p);
        if (keeps(p.position) && from != place_) ++arrived;
      }
    });
    look_at_all(arrived, [&](std::size_t, std::size_t count) {
      if (place_ == 0) house_->migrations_ += count;
    });
    parcels = kept;
    parcels.insert(parcels.end(), copies.begin(), copies.end());
    return kept.size();
  }

  void know_rows(std::span<const std::int64_t> ids, std::size_t kept) const {
    auto& room = house_->rooms_[place_];
    room.row_of.clear(), room.copies.clear(), room.keepers.clear(), room.keeper_rows.clear();
    for (std::size_t row = 0; row < kept; ++row) room.row_of[ids[row]] = row;
    look_at_all(room.row_of, [&](std::size_t from, const auto& rows) {
      for (std::size_t row = kept; row < ids.size(); ++row) {
        const auto found = rows.find(ids[row]);
        if (found == rows.end()) continue;
        room.copies.push_back(row);
        room.keepers.push_back(from);
        room.keeper_rows.push_back(found->second);
      }
    });
  }

 private:
  /// Shows one's own, looks at that of every slab, and goes on when all have looked.
  template <class T, class Look>
  void look_at_all(const T& own, const Look& look) const {
    house_->shown_[place_] = &own;
    house_->gate_.wait_for_all();
    for (std::size_t from = 0; from < house_->size(); ++from) look(from, *static_cast<const T*>(house_->shown_[from]));
    house_->gate_.wait_for_all();
  }

  slab_house* house_;
  std::size_t place_;
};
static_assert(pendular::DistributingHost<slab>);

/// live(slab) in a thread for each; throws what the first of them threw.
template <class Live>
void in_slabs(slab_house& house, const Live& live) {
  std::vector<std::exception_ptr> thrown(house.size());
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < house.size(); ++k) {
    threads.emplace_back([&, k] {
      try {
        live(slab(house, k));
      } catch (...) {
        thrown[k] = std::current_exception();
      }
    });
  }
  for (std::thread& t : threads) t.join();
  for (const std::exception_ptr& t : thrown) {
    if (t) std::rethrow_exception(t);
  }
}
