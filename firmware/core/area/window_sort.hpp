// Screen subdivision (seed 2): the screen is quartered until no window holds more than so many polygons, and each
// window is sorted by itself. What grows with the square of the polygons then does so within a window only. A window
// that does not fit the pools is quartered as well, so small pools cost time and not the picture.
#pragma once

#include "core/area/area_sort.hpp"

namespace spanline::area {

struct WindowCounts {
  SortCounts sort;                 // sums over the windows; block counts: the most of any
  std::uint32_t windows = 0;       // solved
  std::uint32_t window_tests = 0;  // polygons held against a window
};

// `Scene` is asked for polygons by number, 0 … count() - 1: count(), bounds(i), put(i, AreaSort&).
template <typename Scene>
class WindowSort {
 public:
  // `names`: lists of the polygons in a window and the windows around it; about twice the polygons of the scene. A
  // window with at most `most` polygons is sorted as it is; 0: only what does not fit the pools is quartered.
  WindowSort(AreaSort& sort, PoolRef<std::uint16_t> names, std::uint32_t most)
      : sort_(sort), names_(names), most_(most != 0 ? most : UINT32_MAX) {}

  // Hands the visible pieces of each window to `sink` as AreaSort::read() does, when the window is finished. Fails with
  // the status of the window that does not fit even when it is kLeastSide wide, or pool "names" (index: the polygon's
  // number in the scene); all windows handed out before are complete, and nothing of that one or later ones is.
  template <typename Sink>
  Status solve(const Scene& scene, const Box& screen, Sink& sink);

  const WindowCounts& counts() const { return counts_; }

 private:
  static constexpr std::int32_t kLeastSide = 32;  // of a window, units
  static constexpr unsigned kMostLevels = 14;     // from 65534 units down to fewer than kLeastSide
  static_assert((2 * kMaxCoordinate >> (kMostLevels - 1)) < kLeastSide);

  struct Window {
    Box box;
    std::uint32_t first, end;  // its list in names_
    unsigned quarter = 0;      // next to be solved
  };

  bool fill_all(const Scene& scene, Window& window);
  bool fill(const Scene& scene, const Window& around, Window& window);
  bool quartering_pays(const Scene& scene, const Window& window);
  Status sort(const Scene& scene, const Window& window);
  static bool divisible(const Box& box);
  static Box quarter_of(const Box& box, unsigned quarter);
  bool full(std::uint32_t polygon) {
    status_ = {Code::pool_exhausted, "names", "polygon", polygon, 0, names_.capacity() + 1u, names_.capacity()};
    return false;
  }

  AreaSort& sort_;
  PoolRef<std::uint16_t> names_;
  std::uint32_t most_;
  Status status_;
  WindowCounts counts_;
};

template <typename Scene>
template <typename Sink>
Status WindowSort<Scene>::solve(const Scene& scene, const Box& screen, Sink& sink) {
  Window windows[kMostLevels];
  unsigned level = 0;
  counts_ = {};
  status_ = {};
  windows[0] = {screen, 0, 0};
  if (!fill_all(scene, windows[0])) return status_;
  for (;;) {
    Window& window = windows[level];
    if (window.quarter == 0 && window.first != window.end) {
      const bool few = window.end - window.first <= most_ || !quartering_pays(scene, window);
      if (few) {
        const Status status = sort(scene, window);
        if (status.ok()) {
          sort_.read(sink);
          window.quarter = 4;
        } else if (status.code != Code::pool_exhausted || !divisible(window.box)) {
          return status;
        }
      }
    }
    if (window.quarter == 4 || window.first == window.end) {
      if (level == 0) return {};
      --level;
      continue;
    }
    const Box box = quarter_of(window.box, window.quarter++);
    windows[++level] = {box, window.end, window.end};
    if (!fill(scene, window, windows[level])) return status_;
  }
}

template <typename Scene>
bool WindowSort<Scene>::fill_all(const Scene& scene, Window& window) {
  for (std::uint32_t i = 0; i < scene.count(); ++i) {
    ++counts_.window_tests;
    if (!scene.bounds(static_cast<std::uint16_t>(i)).overlaps(window.box)) continue;
    if (window.end == names_.capacity()) return full(i);
    names_[++window.end] = static_cast<std::uint16_t>(i);
  }
  return true;
}

template <typename Scene>
bool WindowSort<Scene>::fill(const Scene& scene, const Window& around, Window& window) {
  for (std::uint32_t i = around.first + 1; i <= around.end; ++i) {
    ++counts_.window_tests;
    if (!scene.bounds(names_[i]).overlaps(window.box)) continue;
    if (window.end == names_.capacity()) return full(names_[i]);
    names_[++window.end] = names_[i];
  }
  return true;
}

// Not where most polygons reach into most quarters: they would be sorted over and over.
template <typename Scene>
bool WindowSort<Scene>::quartering_pays(const Scene& scene, const Window& window) {
  if (!divisible(window.box)) return false;
  std::uint32_t total = 0;
  for (unsigned quarter = 0; quarter < 4; ++quarter) {
    const Box box = quarter_of(window.box, quarter);
    for (std::uint32_t i = window.first + 1; i <= window.end; ++i) {
      ++counts_.window_tests;
      if (scene.bounds(names_[i]).overlaps(box)) ++total;
    }
  }
  return total < 3 * (window.end - window.first);
}

template <typename Scene>
Status WindowSort<Scene>::sort(const Scene& scene, const Window& window) {
  sort_.clear(window.box);
  for (std::uint32_t i = window.first + 1; i <= window.end; ++i) scene.put(names_[i], sort_);
  const Status status = sort_.solve();
  ++counts_.windows;
  counts_.sort.add(sort_.counts());
  return status;
}

template <typename Scene>
bool WindowSort<Scene>::divisible(const Box& box) {
  return box.high.x - box.low.x >= kLeastSide && box.high.y - box.low.y >= kLeastSide;
}

template <typename Scene>
Box WindowSort<Scene>::quarter_of(const Box& box, unsigned quarter) {
  const auto x = static_cast<std::int16_t>((box.low.x + box.high.x) >> 1);
  const auto y = static_cast<std::int16_t>((box.low.y + box.high.y) >> 1);
  Box part = box;
  ((quarter & 1) != 0 ? part.low.x : part.high.x) = x;
  ((quarter & 2) != 0 ? part.low.y : part.high.y) = y;
  return part;
}

}  // namespace spanline::area
