// The depth sorter (III.C – III.J): sample spans, depth comparator and decision processor for one line.
#pragma once

#include <type_traits>

#include "core/geom/facet.hpp"
#include "core/vsg/active_segment.hpp"
#include "core/vsg/depth.hpp"
#include "core/vsg/implied.hpp"
#include "core/vsg/layer_sorter.hpp"
#include "core/vsg/options.hpp"
#include "core/vsg/polygons.hpp"
#include "core/vsg/sample_space.hpp"
#include "core/vsg/statistics.hpp"
#include "core/vsg/visible_span.hpp"
#include "core/vsg/x_sort.hpp"

namespace spanline {

template <VsgOptions kOptions, typename XSort>
class DepthSorter {
 public:
  using Store = SegmentStore<kOptions.statistics>;
  using Layers = std::conditional_t<kOptions.layers, LayerSorter, NoLayerSorter>;
  struct Parts {
    Store* store;
    Polygons* polygons;
    XSort* x_sort;
    SampleSpace* samples;
    ImpliedEdges* implied;
    PoolRef<ActiveSegment> active;
    FacetReader* reader;
    Screen screen;
  };

  DepthSorter() = default;
  explicit DepthSorter(const Parts& parts, const LayerStorage& layers) : p_(parts), layers_(layers, parts.polygons) {}

  // Finds the visible segments of `line` and hands them to sink.span(const VisibleSpan&), or with VsgOptions::layers to
  // sink.layers(const LayeredSpan&); steps every segment to the next line.
  template <typename Sink>
  void run(std::uint16_t line, Sink& sink) {
    line_ = line;
    active_count_ = 0;
    left_out_ = 0;
    pending_ = {};
    pending_left_ = 0;
    p_.samples->begin_line(p_.screen.width);
    p_.x_sort->start();
    if constexpr (kOptions.layers) layers_.begin_line();
    std::int32_t left = 0;
    while (left < p_.screen.width) {
      const std::int32_t right = settle(left, p_.samples->right_of(left), sink);
      retire(right);
      left = right;
    }
    flush(left, sink);
    active_count_ = 0;
    while (p_.x_sort->key() != kNoKey) take(p_.active[0]);
    p_.implied->sweep(line);
  }

  Counters<kOptions.statistics>& statistics() { return counters_; }
  // How many segments the active list had no room for on the line made last.
  std::uint32_t left_out() const { return left_out_; }
  void clear_statistics() { counters_ = {}; }
  Layers& layers() { return layers_; }

  // Depths as the layers see them.
  Verdict compare(ActiveSegment& a, ActiveSegment& b, std::int32_t from, std::int32_t to) {
    return contest(a, b, from, to);
  }
  std::int32_t crossing(ActiveSegment& a, ActiveSegment& b, std::int32_t from, std::int32_t to) {
    return DepthComparator<kOptions.comparator>::crossing(make_contest(a, b, from, to), counters_.comparator_cycles);
  }
  const DepthRamp& ramp(ActiveSegment& entry) {
    if (entry.has_ramp == 0) {
      const bool triangle = ((*p_.polygons)[entry.polygon].flags & PolygonBlock::kTriangle) != 0;
      if (!triangle) look_at(entry);
      entry.ramp = ramp_of(entry);
      entry.has_ramp = 1;
    }
    return entry.ramp;
  }

 private:
  // What is known of a span: the nearest segment that covers all of it, and the visible box (III.G): those that are in
  // front of it somewhere.
  struct Box {
    ActiveSegment* cover = nullptr;
    ActiveSegment* first = nullptr;  // the first in the box
    std::int32_t count = 0;          // how many are in it
    std::int32_t edge = 0;           // the leftmost of their edges within the span; 0: none
    std::int32_t from = 0, to = 0;   // the first one, clipped to the span
  };

  // Emits [left, some column <= right) and returns that column.
  template <typename Sink>
  std::int32_t settle(std::int32_t left, std::int32_t right, Sink& sink) {
    for (;;) {
      Box box;
      if (!compare_all(left, right, box, sink)) continue;
      if (box.count <= 1) {
        decide(left, right, box, sink);
        return right;
      }
      right = box.edge != 0 ? box.edge : left + (right - left) / 2;
    }
  }

  // The depth comparator: every segment of the span, first the active ones, then those that begin in it. False where it
  // has to be done again because the active list was full: `right` is then further left, or the list is another.
  template <typename Sink>
  bool compare_all(std::int32_t left, std::int32_t& right, Box& box, Sink& sink) {
    for (std::int32_t i = 0; i < active_count_; ++i) {
      if constexpr (kOptions.statistics) ++counters_.active_references;
      consider(p_.active[static_cast<std::size_t>(i)], left, right, box);
    }
    for (std::int32_t key = p_.x_sort->key(); key < right; key = p_.x_sort->key()) {
      if (key > left && box.count > 1) break;  // what begins further on cannot cover the span any more
      if constexpr (kOptions.layers) {
        if (!has_room_aside(left, key, right, sink)) return false;
      }
      if (active_count_ == p_.active.capacity()) {
        if (key > left) {
          right = key;
        } else {
          ActiveSegment fresh;
          take(fresh);
          if (!put_aside(fresh)) leave_one_out(fresh);
        }
        return false;
      }
      ActiveSegment& slot = p_.active[static_cast<std::size_t>(active_count_)];
      take(slot);
      if (put_aside(slot) || slot.left >= slot.right) continue;
      ++active_count_;
      note_active();
      consider(slot, left, right, box);
    }
    return true;
  }

  void note_active() {
    if constexpr (kOptions.statistics) {
      const auto count = static_cast<std::uint32_t>(active_count_);
      if (count > counters_.max_active) counters_.max_active = count;
    }
  }

  // Before a segment that begins at `key` is taken: whether there is room to put it aside, be that needed or not. What
  // is finished up to `left` is shown first, then the span made to end where the segment begins; from there on, those
  // that it finds are over its first pixel all of them.
  template <typename Sink>
  bool has_room_aside(std::int32_t left, std::int32_t key, std::int32_t& right, Sink& sink) {
    if (!layers_.full()) return true;
    flush(left, sink);
    pending_left_ = left;
    layers_.retire(left);
    if (!layers_.full() || key <= left) return true;
    right = key;
    return false;
  }

  // Whether the segment is one that hides nothing: it is then among the layers.
  bool put_aside(ActiveSegment& entry) {
    if constexpr (kOptions.layers) {
      if (!LayerSorter::takes((*p_.polygons)[entry.polygon])) return false;
      entry.fresh = 0;
      layers_.put(entry);
      if constexpr (kOptions.statistics) {
        if (layers_.used() > counters_.max_layers) counters_.max_layers = layers_.used();
      }
      return true;
    }
    return false;
  }

  // More segments lie over one pixel than the active list holds: of them and the new one, the highest face is left out.
  void leave_one_out(const ActiveSegment& fresh) {
    if (fresh.left >= fresh.right) return;
    ++left_out_;
    const auto polygon = [this](const ActiveSegment& entry) -> const PolygonBlock& {
      return (*p_.polygons)[entry.polygon];
    };
    ActiveSegment* last = &p_.active[0];
    for (std::int32_t i = 1; i < active_count_; ++i) {
      ActiveSegment& entry = p_.active[static_cast<std::size_t>(i)];
      if (polygon(*last).before(polygon(entry))) last = &entry;
    }
    if (polygon(fresh).before(polygon(*last))) *last = fresh;
  }

  // Takes the next block off the X-sort list: notes in `entry` where it lies on this line, steps it to the next and
  // files it there.
  void take(ActiveSegment& entry) {
    const std::uint16_t index = p_.x_sort->pop();
    SegmentBlock& block = p_.store->held(index);
    entry.segment = index;
    entry.polygon = block.polygon;
    entry.left = static_cast<std::uint16_t>(on_screen(block.half[0].column)) & 0x7fffu;
    entry.fresh = 1;
    entry.right = static_cast<std::uint16_t>(on_screen(block.half[1].column)) & 0x7fffu;
    entry.has_ramp = 0;
    if constexpr (kOptions.statistics) counters_.edge_crossings += 2;
    block.half[0].step();
    block.half[1].step();
    const bool left_ends = block.half[0].empty(), right_ends = block.half[1].empty();
    PolygonBlock& polygon = (*p_.polygons)[block.polygon];
    const bool several = polygon.first_segment != index || block.polygon_next != 0;  // these may change places
    if (left_ends && right_ends && !several && polygon.waiting == 0) polygon.flags |= PolygonBlock::kFinished;
    if (left_ends || right_ends || several || block.half[1].column < block.half[0].column)
      p_.polygons->change(block.polygon);
    if (left_ends) {
      block.flags = SegmentBlock::kMoved;
    } else {
      const bool at_end = p_.x_sort->append(index);
      if constexpr (kOptions.statistics) ++(at_end ? counters_.appended : counters_.searched_back);
    }
    p_.store->store(index);
    p_.x_sort->next();
  }

  std::int32_t on_screen(std::int32_t column) const {
    return column < 0 ? 0 : column > p_.screen.width ? p_.screen.width : column;
  }

  // Drops what ends at or before `left` from the active list. It was visited in the span that ends there, where the
  // seed moves it to the list of those that are out: no reference.
  void retire(std::int32_t left) {
    std::int32_t kept = 0;
    pending_.fresh = 0;
    for (std::int32_t i = 0; i < active_count_; ++i) {
      ActiveSegment entry = p_.active[static_cast<std::size_t>(i)];
      entry.fresh = 0;
      if (entry.right > left) p_.active[static_cast<std::size_t>(kept++)] = entry;
    }
    active_count_ = kept;
  }

  void consider(ActiveSegment& entry, std::int32_t left, std::int32_t right, Box& box) {
    const std::int32_t from = entry.left > left ? entry.left : left;
    const std::int32_t to = entry.right < right ? entry.right : right;
    if (from >= to) return;
    if constexpr (kOptions.statistics) {
      ++counters_.depth_tests;
      ++counters_.comparator_cycles;  // the load
    }
    const bool covers = from == left && to == right;
    const Verdict v = box.cover == nullptr ? Verdict::first : contest(entry, *box.cover, from, to);
    if (v == Verdict::second) return;
    if (v == Verdict::first && covers) {
      replace_cover(entry, box);
    } else {
      if (box.count++ == 0) {
        box.first = &entry;
        box.from = from;
        box.to = to;
      }
      const std::int32_t edge = from > left ? from : to < right ? to : 0;
      if (edge != 0 && (box.edge == 0 || edge < box.edge)) box.edge = edge;
    }
  }

  // A segment that covers the span and hides the cover so far; a single one in the box may be hidden now too.
  void replace_cover(ActiveSegment& entry, Box& box) {
    box.cover = &entry;
    if (box.count != 1) return;
    if (contest(*box.first, entry, box.from, box.to) == Verdict::second) box.count = box.edge = 0;
  }

  Verdict contest(ActiveSegment& a, ActiveSegment& b, std::int32_t from, std::int32_t to) {
    return DepthComparator<kOptions.comparator>::compare(make_contest(a, b, from, to), counters_.comparator_cycles);
  }
  Contest make_contest(ActiveSegment& a, ActiveSegment& b, std::int32_t from, std::int32_t to) {
    return {ramp(a), ramp(b), from, to, (*p_.polygons)[a.polygon].before((*p_.polygons)[b.polygon])};
  }

  const SegmentBlock& look_at(const ActiveSegment& entry) {
    return entry.fresh != 0 ? p_.store->held(entry.segment) : p_.store->fetch(entry.segment);
  }

  DepthRamp ramp_of(const ActiveSegment& entry) {
    PolygonBlock& polygon = (*p_.polygons)[entry.polygon];
    if ((polygon.flags & PolygonBlock::kTriangle) == 0) {
      const SegmentBlock& block = p_.store->held(entry.segment);
      return depth_between(block.half[0].stepped_back(), block.half[1].stepped_back());
    }
    if ((polygon.flags & PolygonBlock::kHasPlane) == 0) make_plane(polygon);
    return {polygon.ramp.at_zero + polygon.down * line_, polygon.ramp.slope};
  }

  void make_plane(PolygonBlock& polygon) {
    const DepthPlane plane = face_plane(*p_.reader, polygon.face, p_.screen);
    polygon.ramp = plane.ramp;
    polygon.down = plane.down;
    polygon.flags |= PolygonBlock::kHasPlane;
  }

  // The decision processor (III.H) for a span with at most one segment in the box.
  template <typename Sink>
  void decide(std::int32_t left, std::int32_t right, Box& box, Sink& sink) {
    const ActiveSegment behind = box.cover == nullptr ? ActiveSegment{} : *box.cover;
    if (box.count == 0) return emit(left, behind, sink);
    std::int32_t from = box.from, to = box.to;
    const Verdict v = box.cover == nullptr ? Verdict::first : contest(*box.first, *box.cover, from, to);
    if (v == Verdict::second) {
      to = from;
    } else if (v != Verdict::first) {
      const Contest pair = make_contest(*box.first, *box.cover, from, to);
      (v == Verdict::first_then_second ? to : from) =
          DepthComparator<kOptions.comparator>::crossing(pair, counters_.comparator_cycles);
    }
    if (left < from) emit(left, behind, sink);
    if (from < to) emit(from, *box.first, sink);
    if (to < right) emit(to, behind, sink);
  }

  std::int32_t note_crossing(std::uint16_t left, std::uint16_t right, std::int32_t column) {
    const ImpliedEdges::Prediction next = p_.implied->note(left, right, column, line_);
    if constexpr (kOptions.statistics) {
      counters_.implied_edges += next.created;
      counters_.implied_dropped += next.dropped;
      if (p_.implied->used() > counters_.max_implied) counters_.max_implied = p_.implied->used();
    }
    return next.column;
  }

  static constexpr std::int32_t kNoSample = INT32_MIN;

  // Lengthens the pending visible segment or begins the next one.
  template <typename Sink>
  void emit(std::int32_t left, const ActiveSegment& segment, Sink& sink) {
    if (left != 0 && segment.segment == pending_.segment) return;
    if (left != 0) {
      flush(left, sink);
      keep(boundary(segment, left));
    }
    pending_ = segment;
    pending_left_ = left;
  }

  // Where the visible edge between the pending segment and the next one, at `column`, is on the next line (III.J). An
  // edge between two pieces of one polygon is none; where neither segment has an edge, they intersect.
  std::int32_t boundary(const ActiveSegment& next, std::int32_t column) {
    if (next.polygon == pending_.polygon) return kNoSample;
    const bool begins = next.segment != 0 && next.left == column;
    const bool ends = pending_.segment != 0 && pending_.right == column;
    if (!begins && !ends) return note_crossing(pending_.segment, next.segment, column);
    std::int32_t sample = kNoSample;
    if (begins) sample = next_column(next, 0);
    if (sample == kNoSample && ends) sample = next_column(pending_, 1);
    return sample;
  }
  std::int32_t next_column(const ActiveSegment& entry, unsigned side) {
    const SegmentHalf& half = look_at(entry).half[side];
    return half.empty() ? kNoSample : half.column;
  }
  void keep(std::int32_t sample) {
    if (sample == kNoSample) return;
    const bool kept = p_.samples->keep(sample);
    if constexpr (kOptions.statistics) {
      counters_.samples_dropped += !kept;
      if (p_.samples->kept() > counters_.max_samples) counters_.max_samples = p_.samples->kept();
    }
  }

  template <typename Sink>
  void flush(std::int32_t right, Sink& sink) {
    if constexpr (kOptions.layers) {
      if (pending_left_ == right) return;  // shown already, to make room aside
    }
    if constexpr (kOptions.statistics) ++counters_.output_segments;
    VisibleSpan span;
    span.line = line_;
    span.left = static_cast<std::uint16_t>(pending_left_);
    span.right = static_cast<std::uint16_t>(right);
    if (pending_.segment != 0) {
      const PolygonBlock& polygon = (*p_.polygons)[pending_.polygon];
      span.face = polygon.face;
      span.payload = polygon.payload;
      span.gouraud = (polygon.flags & PolygonBlock::kGouraud) != 0;
      span.smooth = (polygon.flags & PolygonBlock::kSmooth) != 0;
      span.segment = &p_.store->held(pending_.segment);
      if (span.gouraud) span.shade = &p_.store->shade(pending_.segment);
      if constexpr (kOptions.taps || kOptions.points) span.depth = ramp_of(pending_);
    }
    if constexpr (kOptions.layers) {
      if (!layers_.empty()) return layers_.template show<kOptions.taps>(span, pending_, *this, *p_.store, sink);
    }
    sink.span(span);
  }

  Parts p_{};
  [[no_unique_address]] Layers layers_;
  Counters<kOptions.statistics> counters_;
  std::uint16_t line_ = 0, left_out_ = 0;
  std::int32_t active_count_ = 0;
  ActiveSegment pending_{};
  std::int32_t pending_left_ = 0;
};

}  // namespace spanline
