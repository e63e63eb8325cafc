// Surface detail and see-through polygons. Neither takes part in finding the visible segments: what they lie over, or
// let through, is an opaque segment or the background. They are put aside as their segments come off the X-sort list,
// and when a visible segment is finished they cut it up: detail where its edges lie over a surface that is seen,
// see-through segments where they begin, end, or intersect what lies behind. So a scene pays for them by the piece, and
// coherence, which guides the search for visible segments, is the same with and without them.
#pragma once

#include "core/vsg/comparator.hpp"
#include "core/vsg/layer.hpp"
#include "core/vsg/polygons.hpp"
#include "core/vsg/visible_span.hpp"

namespace spanline {

class LayerSorter {
 public:
  LayerSorter() = default;
  LayerSorter(const LayerStorage& storage, const Polygons* polygons)
      : looks_(storage.looks), aside_(storage.aside), stack_(storage.stack), polygons_(polygons) {}

  PolygonLook& look(std::uint16_t polygon) { return looks_[polygon]; }

  static bool takes(const PolygonBlock& polygon) { return (polygon.flags & PolygonBlock::kAside) != 0; }

  void begin_line() { count_ = left_out_ = 0; }
  bool full() const { return count_ == aside_.capacity(); }
  bool empty() const { return count_ == 0; }
  std::uint16_t used() const { return count_; }
  std::uint16_t capacity() const { return aside_.capacity(); }

  // Puts aside a segment that begins at or after those before it. Where there is no room for it, as many lie over one
  // pixel as the pool holds, and of them and the new one the highest face is left out.
  void put(const ActiveSegment& entry) {
    if (entry.left >= entry.right) return;
    if (full()) {
      ++left_out_;
      if (!drop_face_above(face(entry))) return;
    }
    aside_[count_++] = entry;
  }
  // How many were left out on the line made last.
  std::uint16_t left_out() const { return left_out_; }

  // Forgets what ends at or before `column`.
  void retire(std::int32_t column) {
    std::uint16_t kept = 0;
    for (std::uint16_t i = 0; i < count_; ++i) {
      if (aside_[i].right > column) aside_[kept++] = aside_[i];
    }
    count_ = kept;
  }

  // Shows the visible segment `base`, which covers `span`, with what was put aside: sink.span(const VisibleSpan&) where
  // one surface is seen, sink.layers(const LayeredSpan&) where several are; left to right. Forgets what ends within the
  // span. `duel` judges depths: compare(a, b, from, to) and crossing(a, b, from, to) of two segments, and ramp(a).
  template <bool kTaps, typename Duel, typename Store, typename Sink>
  void show(const VisibleSpan& span, ActiveSegment& base, Duel& duel, Store& store, Sink& sink);

 private:
  // A piece of the span in hand: over [from, to) the same surfaces are seen in the same order.
  struct Piece {
    std::int32_t from, to;
    std::uint16_t layers = 0;

    void end_at(std::int32_t column) {
      if (column < to) to = column;
    }
  };

  std::uint16_t face(const ActiveSegment& entry) const { return (*polygons_)[entry.polygon].face; }
  bool is_detail(const ActiveSegment& entry) const { return looks_[entry.polygon].parent != kNoFace; }

  bool drop_face_above(std::uint16_t fresh);
  template <typename Duel>
  void pile_up(Piece& piece, ActiveSegment& base, Duel& duel);
  template <typename Duel>
  void insert(Piece& piece, ActiveSegment& pane, Duel& duel);
  void lay_detail(Piece& piece);
  Layer* layer_of_face(const Piece& piece, std::uint16_t parent);
  template <typename Store>
  void look_up(Piece& piece, Store& store);
  template <typename Duel>
  static bool is_ahead(Piece& piece, ActiveSegment& a, ActiveSegment& b, Duel& duel);

  PoolRef<PolygonLook> looks_;
  PoolRef<ActiveSegment> aside_;  // [0, count_), in order of their left columns
  PoolRef<Layer> stack_;          // [0, Piece::layers)
  const Polygons* polygons_ = nullptr;
  std::uint16_t count_ = 0, left_out_ = 0;
};

// Takes the entry with the highest face out, if that is above `fresh`.
inline bool LayerSorter::drop_face_above(std::uint16_t fresh) {
  std::uint16_t last = 0;
  for (std::uint16_t i = 1; i < count_; ++i) {
    if (face(aside_[i]) > face(aside_[last])) last = i;
  }
  if (count_ == 0 || face(aside_[last]) < fresh) return false;
  --count_;
  for (std::uint16_t i = last; i < count_; ++i) aside_[i] = aside_[i + 1u];
  return true;
}

template <bool kTaps, typename Duel, typename Store, typename Sink>
void LayerSorter::show(const VisibleSpan& span, ActiveSegment& base, Duel& duel, Store& store, Sink& sink) {
  for (std::int32_t column = span.left; column < span.right;) {
    Piece piece{column, span.right};
    pile_up(piece, base, duel);
    lay_detail(piece);
    look_up(piece, store);
    const Layer& nearest = stack_[0];
    const auto left = static_cast<std::uint16_t>(column), right = static_cast<std::uint16_t>(piece.to);
    VisibleSpan part = span;
    if (kTaps && piece.layers != 0) part.depth = duel.ramp(*nearest.surface);
    if (piece.layers == 0 || (piece.layers == 1 && nearest.transmission == Rgb8{})) {
      part.left = left;
      part.right = right;
      if (piece.layers != 0) {
        const PolygonBlock& polygon = (*polygons_)[nearest.shown->polygon];
        part.face = polygon.face;
        part.gouraud = nearest.shade != nullptr;
        part.payload = polygon.payload;
        part.segment = nearest.segment;
        part.shade = nearest.shade;
      }
      sink.span(part);
    } else {
      sink.layers(LayeredSpan{span.line, left, right, {&stack_[0], piece.layers}, part.depth});
    }
    column = piece.to;
    retire(column);
  }
}

// The surfaces over the first pixel of the piece, the nearest first and the visible segment last; ends the piece where
// another begins, one ends, or two of them intersect.
template <typename Duel>
void LayerSorter::pile_up(Piece& piece, ActiveSegment& base, Duel& duel) {
  for (std::uint16_t i = 0; i < count_ && aside_[i].left < piece.to; ++i) {
    ActiveSegment& entry = aside_[i];
    if (is_detail(entry)) continue;
    if (entry.left > piece.from) {
      piece.to = entry.left;
      break;
    }
    piece.end_at(entry.right);
    if (base.segment == 0 || is_ahead(piece, entry, base, duel)) insert(piece, entry, duel);
  }
  if (base.segment != 0) stack_[piece.layers++].surface = &base;
  for (std::uint16_t i = 0; i < piece.layers; ++i) stack_[i].shown = stack_[i].surface;
}

template <typename Duel>
void LayerSorter::insert(Piece& piece, ActiveSegment& pane, Duel& duel) {
  std::uint16_t place = piece.layers++;
  for (; place != 0 && is_ahead(piece, pane, *stack_[place - 1u].surface, duel); --place) {
    stack_[place].surface = stack_[place - 1u].surface;
  }
  stack_[place].surface = &pane;
}

// Whether `a` is in front of `b` at the first pixel of the piece, which ends before that changes.
template <typename Duel>
bool LayerSorter::is_ahead(Piece& piece, ActiveSegment& a, ActiveSegment& b, Duel& duel) {
  const Verdict v = duel.compare(a, b, piece.from, piece.to);
  if (v == Verdict::first_then_second || v == Verdict::second_then_first) {
    piece.to = duel.crossing(a, b, piece.from, piece.to);
  }
  return v == Verdict::first || v == Verdict::first_then_second;
}

// The topmost detail on each surface of the piece; ends the piece where that may change.
inline void LayerSorter::lay_detail(Piece& piece) {
  for (std::uint16_t i = 0; i < count_ && aside_[i].left < piece.to; ++i) {
    const ActiveSegment& entry = aside_[i];
    if (!is_detail(entry)) continue;
    Layer* const layer = layer_of_face(piece, looks_[entry.polygon].parent);
    if (layer == nullptr) continue;
    if (entry.left > piece.from) {
      piece.to = entry.left;
      return;
    }
    piece.end_at(entry.right);
    if (layer->shown == layer->surface || face(entry) > face(*layer->shown)) layer->shown = &entry;
  }
}

inline Layer* LayerSorter::layer_of_face(const Piece& piece, std::uint16_t parent) {
  for (std::uint16_t i = 0; i < piece.layers; ++i) {
    if (face(*stack_[i].surface) == parent) return &stack_[i];
  }
  return nullptr;
}

// What of each layer shading needs, down to the first that nothing shines through.
template <typename Store>
void LayerSorter::look_up(Piece& piece, Store& store) {
  for (std::uint16_t i = 0; i < piece.layers; ++i) {
    Layer& layer = stack_[i];
    const std::uint16_t segment = layer.shown->segment;
    const PolygonLook& look = looks_[layer.shown->polygon];
    layer.segment = &store.held(segment);
    const bool gouraud = ((*polygons_)[layer.shown->polygon].flags & PolygonBlock::kGouraud) != 0;
    layer.shade = gouraud ? &store.shade(segment) : nullptr;
    layer.face = face(*layer.shown);
    layer.color = look.color;
    layer.transmission = look.transmission;
    if (look.transmission == Rgb8{}) piece.layers = static_cast<std::uint16_t>(i + 1);
  }
}

// Where there are none: takes no room.
struct NoLayerSorter {
  NoLayerSorter() = default;
  NoLayerSorter(const LayerStorage&, const Polygons*) {}
};

}  // namespace spanline
