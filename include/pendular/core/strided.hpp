// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <compare>
#include <cstddef>
#include <iterator>
#include <span>
#include <type_traits>

namespace pendular {

/// One member of every row of a table, seen as a column: a span whose elements lie a fixed number of bytes apart.
template <class T>
class strided {
  using byte = std::conditional_t<std::is_const_v<T>, const std::byte, std::byte>;

 public:
  class iterator {
   public:
    using value_type = std::remove_const_t<T>;
    using difference_type = std::ptrdiff_t;
    using reference = T&;
    using pointer = T*;
    using iterator_category = std::random_access_iterator_tag;

    iterator() = default;
    iterator(byte* at, difference_type stride) : at_(at), stride_(stride) {}

    T& operator*() const { return *reinterpret_cast<T*>(at_); }
    T* operator->() const { return reinterpret_cast<T*>(at_); }
    T& operator[](difference_type k) const { return *(*this + k); }
    iterator& operator+=(difference_type k) {
      at_ += k * stride_;
      return *this;
    }
    iterator& operator-=(difference_type k) { return *this += -k; }
    iterator& operator++() { return *this += 1; }
    iterator& operator--() { return *this += -1; }
    iterator operator++(int) { return (*this += 1) - 1; }
    iterator operator--(int) { return (*this += -1) + 1; }
    friend iterator operator+(iterator i, difference_type k) { return i += k; }
    friend iterator operator+(difference_type k, iterator i) { return i += k; }
    friend iterator operator-(iterator i, difference_type k) { return i -= k; }
    friend difference_type operator-(const iterator& a, const iterator& b) { return (a.at_ - b.at_) / a.stride_; }
    friend bool operator==(const iterator& a, const iterator& b) { return a.at_ == b.at_; }
    friend auto operator<=>(const iterator& a, const iterator& b) { return a.at_ <=> b.at_; }

   private:
    byte* at_ = nullptr;
    difference_type stride_ = sizeof(T);
  };

  strided() = default;
  strided(T* first, std::size_t size, std::size_t stride)
      : first_(reinterpret_cast<byte*>(first)), size_(size), stride_(stride) {}
  /// Elements that follow each other.
  template <class Range>
    requires std::is_convertible_v<Range&&, std::span<T>> strided(Range&& range) : strided(std::span<T>(range)) {}
    strided(std::span<T> elements) : strided(elements.data(), elements.size(), sizeof(T)) {}
    /// What may be written may be read.
    template <class U>
      requires(std::is_same_v<const U, T>)
    strided(const strided<U>& other) : strided(other.empty() ? nullptr : &other[0], other.size(), other.stride()) {}

    T& operator[](std::size_t k) const { return *reinterpret_cast<T*>(first_ + k * stride_); }
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    strided first(std::size_t count) const { return {reinterpret_cast<T*>(first_), count, stride_}; }
    std::size_t stride() const { return stride_; }  // bytes
    iterator begin() const { return {first_, static_cast<std::ptrdiff_t>(stride_)}; }
    iterator end() const { return begin() + static_cast<std::ptrdiff_t>(size_); }

   private:
    byte* first_ = nullptr;
    std::size_t size_ = 0, stride_ = sizeof(T);
};

}  // namespace pendular
