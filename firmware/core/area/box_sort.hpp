// Z subdivision (seed 2): space is divided by depth into boxes of so many polygons each, which are solved from back to
// front. Either each solution is overlaid on those before, by whoever draws them; or it becomes the detail of a
// backdrop plane that the next box is solved with, and the last solution is the whole picture in polygons.
#pragma once

#include "core/area/area_sort.hpp"
#include "core/area/sort.hpp"

namespace spanline::area {

// A piece of the solution so far.
struct SolvedPiece {
  Border border;
  Plane plane;
  std::uint16_t source;
};

struct BoxPools {
  PoolRef<std::int32_t> depths;   // as many as the scene has polygons
  PoolRef<SolvedPiece> solution;  // with a backdrop: the pieces of one solution
  PoolRef<BorderEdge> borders;    // theirs
};

// `Scene` as for WindowSort, and nearest(i): the largest depth of a polygon.
template <typename Scene>
class BoxSort {
 public:
  // At most `most` polygons begin in a box; those that reach through several are cut where boxes meet.
  BoxSort(AreaSort& sort, const BoxPools& pools, std::uint32_t most)
      : sort_(sort), pools_(pools), borders_(pools.borders), most_(most) {}

  // Boxes from back to front, each to `sink` as AreaSort::read() does, after begin_box(). What comes later covers what
  // came before. Fails with the status of the box that does not fit, after those behind it; or pool "depths" (index:
  // the polygon's number in the scene).
  template <typename Sink>
  Status overlay(const Scene& scene, const Box& window, Sink& sink);

  // One picture, as if it had been solved at once, and nothing where it fails: pools as above, "solution", "borders".
  template <typename Sink>
  Status with_backdrop(const Scene& scene, const Box& window, Sink& sink);

  std::uint32_t boxes() const { return boxes_; }
  const SortCounts& counts() const { return counts_; }

 private:
  // Reads a solution from the sort, and hands one out in the same form.
  struct Keeper {
    BoxSort& boxes;
    GridPoint start, last;
    std::uint16_t asked = 0;  // the polygon of the last piece that was kept, or for which there was no room
    bool open = false, fits = true;

    void begin_piece(std::uint16_t source, const Plane& plane) {
      if (!fits || boxes.borders_.full()) return;
      asked = source;
      fits = boxes.solved_ < boxes.pools_.solution.capacity();
      if (fits) boxes.pools_.solution[++boxes.solved_] = {{}, plane, source};
    }
    void film(std::uint16_t) {}
    void begin_contour() { open = false; }
    void vertex(GridPoint p) {
      if (open) append(last, p);
      if (!open) start = p;
      open = true;
      last = p;
    }
    void end_contour() { append(last, start); }
    void end_piece() {}
    void append(GridPoint a, GridPoint b) {
      if (fits) boxes.borders_.append(boxes.pools_.solution[boxes.solved_].border, a, b);
    }
  };

  bool find_boxes(const Scene& scene);
  Slab slab(std::uint32_t box) const;
  Status solve(const Scene& scene);
  void put_backdrop();
  Status keep();

  AreaSort& sort_;
  BoxPools pools_;
  Borders borders_;
  std::uint32_t most_, boxes_ = 0;
  std::uint16_t count_ = 0, solved_ = 0;  // depths, pieces of the solution
  SortCounts counts_;
  Status status_;
};

// The depths at which polygons begin, ascending; every most_-th one bounds a box.
template <typename Scene>
bool BoxSort<Scene>::find_boxes(const Scene& scene) {
  counts_ = {};
  count_ = solved_ = 0;
  for (std::uint32_t i = 0; i < scene.count(); ++i) {
    if (count_ == pools_.depths.capacity()) {
      status_ = {Code::pool_exhausted, "depths", "polygon", i, 0, count_ + 1u, count_};
      return false;
    }
    pools_.depths[++count_] = scene.nearest(static_cast<std::uint16_t>(i));
  }
  sort_blocks(pools_.depths, count_, [](std::int32_t a, std::int32_t b) { return a < b; });
  boxes_ = (count_ + most_ - 1) / most_;
  return true;
}

template <typename Scene>
Slab BoxSort<Scene>::slab(std::uint32_t box) const {
  Slab slab;
  if (box > 0) slab.low = pools_.depths[box * most_] + 1;
  if (box + 1 < boxes_) slab.high = pools_.depths[(box + 1) * most_] + 1;
  return slab;
}

template <typename Scene>
Status BoxSort<Scene>::solve(const Scene& scene) {
  for (std::uint32_t i = 0; i < scene.count(); ++i) scene.put(static_cast<std::uint16_t>(i), sort_);
  const Status status = sort_.solve();
  counts_.add(sort_.counts());
  return status;
}

template <typename Scene>
template <typename Sink>
Status BoxSort<Scene>::overlay(const Scene& scene, const Box& window, Sink& sink) {
  if (!find_boxes(scene)) return status_;
  for (std::uint32_t box = 0; box < boxes_; ++box) {
    sort_.clear(window, slab(box));
    if (const Status status = solve(scene); !status.ok()) return status;
    sink.begin_box();
    sort_.read(sink);
  }
  return {};
}

template <typename Scene>
template <typename Sink>
Status BoxSort<Scene>::with_backdrop(const Scene& scene, const Box& window, Sink& sink) {
  if (!find_boxes(scene)) return status_;
  for (std::uint32_t box = 0; box < boxes_; ++box) {
    sort_.clear(window, slab(box));
    if (box > 0) put_backdrop();
    if (const Status status = solve(scene); !status.ok()) return status;
    if (box + 1 == boxes_) break;
    if (const Status status = keep(); !status.ok()) return status;
  }
  if (boxes_ > 0) sort_.read(sink);
  return {};
}

template <typename Scene>
void BoxSort<Scene>::put_backdrop() {
  sort_.begin_backdrop();
  for (std::uint16_t i = 1; i <= solved_; ++i) {
    const SolvedPiece& piece = pools_.solution[i];
    sort_.begin_polygon(piece.source, piece.plane);
    bool open = false;
    GridPoint start;
    borders_.each(piece.border, [&](const BorderEdge& edge) {
      if (!open) {
        sort_.begin_contour();
        start = edge.from;
      }
      sort_.vertex(edge.from.x, edge.from.y, 0);
      open = !(edge.to == start);
      if (!open) sort_.end_contour();
    });
    sort_.end_polygon();
  }
  sort_.end_backdrop();
}

template <typename Scene>
Status BoxSort<Scene>::keep() {
  borders_.clear();
  solved_ = 0;
  Keeper keeper{*this, {}, {}};
  sort_.read(keeper);
  const auto full = [&](const char* pool, std::uint16_t capacity) {
    return Status{Code::pool_exhausted, pool, "polygon", keeper.asked, 0, capacity + 1u, capacity};
  };
  if (!keeper.fits) return full("solution", solved_);
  if (borders_.full()) return full("borders", borders_.capacity());
  return {};
}

}  // namespace spanline::area
