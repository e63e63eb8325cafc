#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/check.hpp"

namespace spanline {

// The view that algorithms take of somebody's static array: capacity is min(array, limit), so that a host option can
// shrink any pool at run time. Blocks are named by 16-bit indices 1 … capacity; element 0 is the sink: the null block
// of every list, writable so that no list operation needs a null test.
template <typename T>
class PoolRef {
 public:
  constexpr PoolRef() = default;
  constexpr PoolRef(T* data, std::uint16_t capacity) : data_(data), capacity_(capacity) {}

  constexpr std::uint16_t capacity() const { return capacity_; }
  constexpr T* sink() const { return data_; }  // null where there is no pool
  constexpr void limit(std::uint32_t most) {
    if (most < capacity_) capacity_ = static_cast<std::uint16_t>(most);
  }
  constexpr T& operator[](std::size_t index) const {
    CHECK(index <= capacity_);
    return data_[index];
  }

 private:
  T* data_ = nullptr;
  std::uint16_t capacity_ = 0;
};

// The owner: N blocks and the sink.
template <typename T, std::uint16_t N>
class Pool {
 public:
  constexpr PoolRef<T> ref() { return {items_, N}; }

 private:
  T items_[static_cast<std::size_t>(N) + 1] = {};
};

// Free storage over a pool, threaded through the block's own link field. Blocks never used before are handed out in
// order, so that clearing costs nothing.
template <typename T, std::uint16_t T::*kLink>
class FreeList {
 public:
  FreeList() = default;
  explicit FreeList(PoolRef<T> blocks) : blocks_(blocks) {}

  void clear() { free_ = fresh_ = used_ = 0; }

  // The index of a block with unspecified content, or 0 where none is left.
  std::uint16_t take() {
    std::uint16_t index = free_;
    if (index != 0) {
      free_ = blocks_[index].*kLink;
    } else {
      if (fresh_ == blocks_.capacity()) return 0;
      index = ++fresh_;
    }
    ++used_;
    return index;
  }

  void give(std::uint16_t index) {
    CHECK(index != 0 && used_ != 0);
    blocks_[index].*kLink = free_;
    free_ = index;
    --used_;
  }

  T& operator[](std::uint16_t index) const { return blocks_[index]; }
  std::uint16_t used() const { return used_; }
  std::uint16_t capacity() const { return blocks_.capacity(); }
  std::uint16_t ever_used() const { return fresh_; }  // indices above have never been handed out since clear()

 private:
  PoolRef<T> blocks_;
  std::uint16_t free_ = 0, fresh_ = 0, used_ = 0;
};

}  // namespace spanline
