// The visible segment generator (seed 1, Fig. 10): facets go in when their first line comes, a stream of visible spans
// comes out line by line.
#pragma once

#include "core/vsg/depth_sorter.hpp"
#include "core/vsg/edge_table.hpp"
#include "core/vsg/segment_eliminator.hpp"
#include "core/vsg/segment_generator.hpp"
#include "core/vsg/x_sort.hpp"

namespace spanline {

// The pools, erased. shades holds as many as segments or none at all.
struct VsgStorage {
  PoolRef<PolygonBlock> polygons;
  PoolRef<EdgeBlock> edges;
  PoolRef<SegmentBlock> segments;
  PoolRef<SegmentShade> shades;
  PoolRef<ActiveSegment> active;
  PoolRef<std::int16_t> samples[2];
  PoolRef<ImpliedEdge> implied;
  void* buckets = nullptr;   // XSortBuckets::Buckets, for XSort::buckets only
  LayerStorage layers = {};  // for VsgOptions::layers only
};

// What a facet looks like: worked out by shade, carried by vsg.
struct FacetLook {
  std::uint16_t payload = 0;
  bool gouraud = false;  // colours along edges
  bool smooth = false;   // the shader makes pixels of a brightness of its own: VisibleSpan::smooth
};

// Likewise where there are layers. The payload and `look.color` are of one colour.
struct LayeredLook : FacetLook {
  PolygonLook look;
};

// Which facet: of all with one face, as those of a patch, each has its own `part`.
struct FacetName {
  std::uint16_t face;
  std::uint16_t part = 0;
};

// The outcome of putting a facet in.
enum class Room : std::uint8_t {
  enough,
  no_edges,  // the edge pool is full: begin again on this line with a shorter band, which files fewer edges
  left_out,  // the line needs more blocks than exist: the highest face numbers were left out
};

template <VsgOptions kOptions>
class VisibleSegments {
 public:
  using Look = std::conditional_t<kOptions.layers, LayeredLook, FacetLook>;

  VisibleSegments() = default;
  VisibleSegments(const VisibleSegments&) = delete;
  VisibleSegments& operator=(const VisibleSegments&) = delete;
  VisibleSegments(const VsgStorage& storage, const Screen& screen, FacetReader* reader);

  // Forgets everything; what comes next lies on lines [top, bottom).
  void begin_band(std::int32_t bottom);

  // Whether there is room for colours along edges; if not, FacetLook::gouraud is not to be set.
  bool has_colours() const { return store_.has_shades(); }

  // Before the first facet of `line` is put in: blocks of what has ended come back, edges that waited for the line
  // enter. In this order no pool ever holds more than the line needs.
  void begin_line(std::int32_t line) {
    polygons_.filter_changing([&](std::uint16_t polygon) { return !eliminator_.release(polygon, edges_, line); });
    enter_waiting(line);
  }

  // Puts the reader's current facet in on `line`: its first line, or the first of the band. `colour` as
  // FacetReader::read.
  template <typename Colour>
  Room add(std::uint16_t face, std::int32_t line, const Look& look, const Colour& colour) {
    const bool triangle = reader_->face().corners.size() == 3 && !reader_->clipped();
    return add({face}, triangle, line, look, [&](auto& sink) { reader_->read(colour, sink); });
  }

  // Likewise the facet whose contours `feed(sink)` hands out as FacetReader::read does. `triangle`: one that the reader
  // can read again under this face, for its plane.
  template <typename Feed>
  Room add(const FacetName& name, bool triangle, std::int32_t line, const Look& look, const Feed& feed);

  // Generates `line`, the one after the last: sink.span(const VisibleSpan&), left to right.
  template <typename Sink>
  void run(std::uint16_t line, Sink& sink);

  // Of the last left_out or unclosed.
  const Status& status() const { return status_; }
  void clear_status() { status_ = {}; }

  // The counters so far; all but none of them where VsgOptions::statistics is not set.
  auto& statistics();
  void clear_statistics() {
    sorter_.statistics() = {};
    store_.clear_counters();
  }

 private:
  using Sort = std::conditional_t<kOptions.x_sort == XSort::list, XSortList<kOptions.statistics>,
                                  XSortBuckets<kOptions.statistics>>;
  struct EdgeSink;

  Room enter(std::uint16_t polygon, PlacedEdge edge, std::int32_t line);
  void enter_waiting(std::int32_t line);
  static std::uint8_t flags_of(const Look& look, bool triangle);
  bool make_room(const char* pool, std::uint16_t capacity, const PolygonBlock& polygon, std::int32_t line);
  void note_pools();

  SegmentStore<kOptions.statistics> store_;
  Polygons polygons_;
  EdgeTable edges_;
  Sort x_sort_;
  SampleSpace samples_;
  ImpliedEdges implied_;
  SegmentGenerator<kOptions.statistics> generator_;
  SegmentEliminator<kOptions.statistics, Sort> eliminator_;
  DepthSorter<kOptions, Sort> sorter_;
  FacetReader* reader_ = nullptr;
  std::uint16_t active_capacity_ = 0;
  std::int32_t bottom_ = 0;
  Status status_;
};

template <VsgOptions kOptions>
VisibleSegments<kOptions>::VisibleSegments(const VsgStorage& storage, const Screen& screen, FacetReader* reader)
    : store_(storage.segments, storage.shades),
      polygons_(storage.polygons),
      edges_(storage.edges),
      x_sort_(&store_),
      samples_(storage.samples[0], storage.samples[1]),
      implied_(storage.implied),
      generator_(&store_, &polygons_),
      eliminator_(&store_, &polygons_, &x_sort_),
      sorter_({&store_, &polygons_, &x_sort_, &samples_, &implied_, storage.active, reader, screen}, storage.layers),
      reader_(reader),
      active_capacity_(storage.active.capacity()) {
  if constexpr (kOptions.x_sort == XSort::buckets) x_sort_.use(static_cast<typename Sort::Buckets*>(storage.buckets));
}

template <VsgOptions kOptions>
void VisibleSegments<kOptions>::begin_band(std::int32_t bottom) {
  store_.clear();
  polygons_.clear();
  edges_.clear();
  x_sort_.clear();
  samples_.clear();
  implied_.clear();
  x_sort_.begin_line();
  bottom_ = bottom;
}

// Cuts a facet's contours into edges and files them: those that have begun at once, the others in the edge table.
template <VsgOptions kOptions>
struct VisibleSegments<kOptions>::EdgeSink {
  VisibleSegments& vsg;
  std::uint16_t polygon;
  std::int32_t line;
  Room room = Room::enough;
  FacetVertex first{}, previous{};
  bool any = false;

  void begin_contour() { any = false; }
  void vertex(const FacetVertex& v) {
    if (any) edge(previous, v);
    if (!any) first = v;
    any = true;
    previous = v;
  }
  void end_contour() {
    if (any) edge(previous, first);
  }

  void edge(const FacetVertex& a, const FacetVertex& b) {
    if (room != Room::enough) return;
    const ScreenEdge e(a, b);
    const std::int32_t begin = e.first_line(), end = e.end_line();
    if (begin >= end || end <= line || begin >= vsg.bottom_) return;
    PolygonBlock& block = vsg.polygons_[polygon];
    if (begin > line) {
      ++block.waiting;
      if (!vsg.edges_.add(e, polygon)) room = Room::no_edges;
      return;
    }
    const bool gouraud = (block.flags & PolygonBlock::kGouraud) != 0;
    const bool with_depth = (block.flags & PolygonBlock::kTriangle) == 0;
    room = vsg.enter(polygon, {start_edge(e, line, with_depth), gouraud ? shade_edge(e) : EdgeShade{}}, line);
  }
};

template <VsgOptions kOptions>
template <typename Feed>
Room VisibleSegments<kOptions>::add(const FacetName& name, bool triangle, std::int32_t line, const Look& look,
                                    const Feed& feed) {
  CHECK(!look.gouraud || has_colours());
  const std::uint8_t flags = flags_of(look, triangle);
  const PolygonBlock block{name.face, 0, 0, 0, look.payload, flags, {}, name.part};
  std::uint16_t polygon = polygons_.open(block);
  while (polygon == 0) {
    if (!make_room("polygons", polygons_.capacity(), block, line)) return Room::left_out;
    polygon = polygons_.open(block);
  }
  if constexpr (kOptions.layers) sorter_.layers().look(polygon) = look.look;
  polygons_.change(polygon);
  EdgeSink sink{*this, polygon, line};
  feed(sink);
  return sink.room;
}

template <VsgOptions kOptions>
std::uint8_t VisibleSegments<kOptions>::flags_of(const Look& look, bool triangle) {
  int flags = (triangle ? PolygonBlock::kTriangle : 0) | (look.gouraud ? PolygonBlock::kGouraud : 0) |
              (look.smooth ? PolygonBlock::kSmooth : 0);
  if constexpr (kOptions.layers) {
    if (look.look.parent != kNoFace || look.look.transmission != Rgb8{}) flags |= PolygonBlock::kAside;
  }
  return static_cast<std::uint8_t>(flags);
}

// Files an edge; while there is no block for it, the highest face goes, perhaps the edge's own.
template <VsgOptions kOptions>
Room VisibleSegments<kOptions>::enter(std::uint16_t polygon, PlacedEdge edge, std::int32_t line) {
  while (!generator_.insert(polygon, edge)) {
    if (make_room("segments", store_.capacity(), polygons_[polygon], line)) continue;
    eliminator_.drop(polygon, edges_);
    return Room::left_out;
  }
  polygons_.change(polygon);
  PolygonBlock& block = polygons_[polygon];
  block.flags &= static_cast<std::uint8_t>(~PolygonBlock::kSettled);
  if (eliminator_.settle(polygon)) block.flags |= PolygonBlock::kSettled;
  return Room::enough;
}

// Drops the live polygon with the highest face if that is above `polygon`'s. Notes the shortage.
template <VsgOptions kOptions>
bool VisibleSegments<kOptions>::make_room(const char* pool, std::uint16_t capacity, const PolygonBlock& polygon,
                                          std::int32_t line) {
  const bool same = !status_.ok() && status_.line == static_cast<std::uint32_t>(line) && status_.where == pool;
  status_ = {Code::pool_exhausted,
             pool,
             "",
             polygon.face,
             static_cast<std::uint32_t>(line),
             (same ? status_.needed : capacity) + 1u,
             capacity};
  if constexpr (kOptions.statistics) ++sorter_.statistics().facets_left_out;
  const std::uint16_t last = polygons_.last_face();
  if (last == 0 || !polygon.before(polygons_[last])) return false;
  eliminator_.drop(last, edges_);
  return true;
}

template <VsgOptions kOptions>
void VisibleSegments<kOptions>::enter_waiting(std::int32_t line) {
  while (const std::uint16_t index = edges_.pop(line)) {
    const EdgeBlock block = edges_[index];
    edges_.give(index);
    const PlacedEdge edge{start_edge(block.edge, line, true), has_colours() ? shade_edge(block.edge) : EdgeShade{}};
    for (const std::uint16_t polygon : block.polygons) {
      // Making room for the first may have dropped the second: its block then names no face.
      if (polygon == 0 || polygons_[polygon].face == kNoFace) continue;
      --polygons_[polygon].waiting;
      enter(polygon, edge, line);
    }
  }
}

template <VsgOptions kOptions>
template <typename Sink>
void VisibleSegments<kOptions>::run(std::uint16_t line, Sink& sink) {
  if constexpr (kOptions.statistics) note_pools();
  while (const std::uint16_t polygon = polygons_.pop_changing()) {
    const std::uint16_t face = polygons_[polygon].face;
    if (!eliminator_.pack(polygon)) status_ = {Code::unclosed, "face", "contours", face, line, 0, 0};
  }
  sorter_.run(line, sink);
  if (sorter_.left_out() != 0) {
    const std::uint32_t capacity = active_capacity_;
    status_ = {Code::pool_exhausted, "active", "", 0, line, capacity + sorter_.left_out(), capacity};
  }
  if constexpr (kOptions.layers) {
    const LayerSorter& layers = sorter_.layers();
    if (layers.left_out() != 0) {
      const std::uint32_t capacity = layers.capacity();
      status_ = {Code::pool_exhausted, "layers", "", 0, line, capacity + layers.left_out(), capacity};
    }
  }
  x_sort_.begin_line();
}

template <VsgOptions kOptions>
void VisibleSegments<kOptions>::note_pools() {
  Statistics& s = sorter_.statistics();
  if (polygons_.used() > s.max_polygons) s.max_polygons = polygons_.used();
  if (edges_.used() > s.max_edges) s.max_edges = edges_.used();
}

template <VsgOptions kOptions>
auto& VisibleSegments<kOptions>::statistics() {
  auto& s = sorter_.statistics();
  if constexpr (kOptions.statistics) {
    s.segment_references = store_.references();
    s.segment_blocks = store_.taken();
    s.max_segments = store_.most();
  }
  return s;
}

}  // namespace spanline
