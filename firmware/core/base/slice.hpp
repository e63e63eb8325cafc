#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/check.hpp"

namespace spanline {

// A memory view: pointer and count, nothing owned. Called Slice because *span* means a run of pixels in this house.
template <typename T>
class Slice {
 public:
  constexpr Slice() = default;
  constexpr Slice(T* data, std::uint32_t size) : data_(data), size_(size) {}
  template <std::size_t N>
  constexpr Slice(T (&array)[N]) : data_(array), size_(N) {}  // NOLINT: implicit on purpose, as for any view

  constexpr T* data() const { return data_; }
  constexpr std::uint32_t size() const { return size_; }
  constexpr bool empty() const { return size_ == 0; }
  constexpr T& operator[](std::uint32_t index) const {
    CHECK(index < size_);
    return data_[index];
  }
  constexpr T* begin() const { return data_; }
  constexpr T* end() const { return data_ + size_; }

 private:
  T* data_ = nullptr;
  std::uint32_t size_ = 0;
};

}  // namespace spanline
