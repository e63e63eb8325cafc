#include "core/frame/line_frame.hpp"

#include "core/shade/pixel.hpp"

namespace spanline {

// The scene for area::WindowSort.
struct LineFrame::Faces {
  FacetReader& reader;
  PoolRef<area::Box> boxes;
  Slice<const MaterialRecord> materials;
  std::uint16_t faces = 0;

  std::uint32_t count() const { return faces; }
  const area::Box& bounds(std::uint16_t face) const { return boxes[face + 1u]; }

  void put(std::uint16_t face, area::AreaSort& sort) const {
    reader.select(face);
    const bool clear = materials[reader.face().material].transmission != Rgb8{};
    sort.begin_polygon(face, clear ? area::Opacity::translucent : area::Opacity::opaque);
    put_rings(sort);
    const auto& parents = reader.mesh().parents;
    const std::uint32_t first = reader.last_face() + 1u - parents.size(), own = reader.face().mesh_face;
    for (std::uint32_t i = 0; i < parents.size(); ++i) {
      if (parents[i] != own) continue;
      const auto detail = static_cast<std::uint16_t>(first + i);
      reader.select(detail);
      if (!is_seen()) continue;
      sort.begin_detail(detail);
      put_rings(sort);
    }
  }

  bool is_seen() const {
    const FacetExtent extent = reader.extent();
    return extent.area != 0 && (extent.left < extent.right || extent.first_line < extent.end_line);
  }

  // Of faces that are seen and no detail; the others have none.
  void find_bounds(std::uint32_t total) {
    for (faces = 0; faces < total; ++faces) {
      area::Box& box = boxes[faces + 1u];
      box = area::Box::none();
      reader.select(faces);
      if (reader.parent() != kNoFace || reader.is_patch() || !is_seen()) continue;
      struct Widen {
        area::Box& box;
        void begin_contour() {}
        void vertex(const FacetVertex& v) { box.widen({v.at.x, v.at.y}); }
        void end_contour() {}
      } widen{box};
      reader.read([](std::uint16_t) { return Rgb8{}; }, widen);
    }
  }

 private:
  void put_rings(area::AreaSort& sort) const {
    struct Put {
      area::AreaSort& sort;
      void begin_contour() { sort.begin_contour(); }
      void vertex(const FacetVertex& v) { sort.vertex(v.at.x, v.at.y, static_cast<std::int32_t>(v.depth)); }
      void end_contour() { sort.end_contour(); }
    } put{sort};
    reader.read([](std::uint16_t) { return Rgb8{}; }, put);
    sort.end_polygon();
  }
};

// The edges of what is visible.
struct LineFrame::Pieces {
  area::LineDrawing& drawing;
  area::GridPoint start, last;
  std::uint16_t look = 0;
  bool open = false;

  void begin_piece(std::uint16_t source, const area::Plane&) { look = source; }
  void film(std::uint16_t) {}
  void begin_contour() { open = false; }
  void vertex(area::GridPoint p) {
    if (open) drawing.edge(last, p, look);
    if (!open) start = p;
    open = true;
    last = p;
  }
  void end_contour() { drawing.edge(last, start, look); }
  void end_piece() {}
};

// Draws lines into the picture, a pixel for each column of a flat one and for each row of a steep one.
struct LineFrame::Pen {
  PoolRef<std::uint8_t> bits;
  const Screen& screen;

  void line(area::GridPoint from, area::GridPoint to) const {
    const std::int32_t dx = to.x - from.x, dy = to.y - from.y;
    if (dx >= (dy < 0 ? -dy : dy)) {
      run(from.x, to.x, from.y, dy, [this](std::int32_t x, std::int32_t y) { set(x, y); });
    } else if (dy > 0) {
      run(from.y, to.y, from.x, dx, [this](std::int32_t y, std::int32_t x) { set(x, y); });
    } else {
      run(to.y, from.y, to.x, -dx, [this](std::int32_t y, std::int32_t x) { set(x, y); });
    }
  }

 private:
  static_assert(kMaxExtent * kSubpixels <= 1 << 15, "a coordinate in Q15 fits 32 bits");

  // From `low` to `high` along the longer way, whose other coordinate begins at `across` and rises by `rise` in all; it
  // is taken where the middle of each pixel is, or the line ends.
  template <typename Set>
  static void run(std::int32_t low, std::int32_t high, std::int32_t across, std::int32_t rise, Set pixel) {
    const std::int32_t length = high - low;
    const std::int32_t slope = length > 0 ? rise * (1 << 15) / length : 0;  // Q15
    for (std::int32_t at = low / kSubpixels; at <= high / kSubpixels; ++at) {
      const std::int32_t middle = at * kSubpixels + kSubpixels / 2;
      const std::int32_t place = middle < low ? low : middle > high ? high : middle;
      pixel(at, (across * (1 << 15) + slope * (place - low)) / (kSubpixels << 15));
    }
  }

  // What lies on the right or lower border of the screen is drawn in the last column or line.
  void set(std::int32_t x, std::int32_t y) const {
    const std::int32_t column = x < screen.width ? x : screen.width - 1,
                       line = y < screen.height ? y : screen.height - 1;
    const std::uint32_t stride = bytes_per_line(PixelFormat::mono1, screen.width);
    std::uint8_t& byte = bits[1 + stride * static_cast<std::uint32_t>(line) + static_cast<std::uint32_t>(column) / 8];
    byte = static_cast<std::uint8_t>(byte | 0x80 >> (column & 7));
  }
};

LineFrame::LineFrame(const LineStorage& storage)
    : storage_(storage),
      sort_(storage.sort, area::Panes::unnamed),
      drawing_(storage.edges, storage.corners),
      painter_(storage.screen) {}

Status LineFrame::find_lines(const SceneView& scene, const CameraRecord& camera) {
  drawing_.clear();
  if (const Status status = check_camera(camera); !status.ok()) return status;
  const std::uint32_t total = scene.face_count();
  if (total > storage_.bounds.capacity()) {
    const std::uint16_t capacity = storage_.bounds.capacity();
    return {Code::pool_exhausted, "facets", "polygon", capacity, 0, total, capacity};
  }
  FacetReader reader(scene, camera, storage_.screen, storage_.vertices);
  reader.fill_cache();
  Faces faces{reader, storage_.bounds, scene.scene().materials};
  faces.find_bounds(total);
  const auto unit = [](std::uint16_t px) { return static_cast<std::int16_t>(px * kSubpixels); };
  const area::Box whole{{0, 0}, {unit(storage_.screen.width), unit(storage_.screen.height)}};
  Pieces pieces{drawing_, {}, {}};
  // As many at once as there is room for: smaller windows only cost time.
  const Status status = area::WindowSort<Faces>(sort_, storage_.names, 0).solve(faces, whole, pieces);
  return status.ok() ? drawing_.solve() : status;
}

Band LineFrame::prepare(const SceneView& scene, const CameraRecord& camera, Band rest) {
  if (rest.top == 0) {
    for (std::uint32_t i = 1; i <= storage_.bits.capacity(); ++i) storage_.bits[i] = 0;
    status_ = find_lines(scene, camera);
    if (status_.ok()) {
      Pen pen{storage_.bits, storage_.screen};
      drawing_.read(pen);
    }
    const BackgroundRecord& paper = scene.scene().background;
    painter_.begin_lines(paper);
    constexpr std::uint8_t kHalf = 128;
    ink_ = flat_payload(storage_.screen.format, paper.top.g < kHalf ? Rgb8{255, 255, 255} : Rgb8{0, 0, 0});
  }
  band_ = rest;
  return status_.code == Code::bad_argument ? Band{} : rest;
}

bool LineFrame::next_line(Slice<std::uint8_t> out) {
  if (band_.empty()) return false;
  const Screen& screen = storage_.screen;
  const std::uint32_t stride = bytes_per_line(PixelFormat::mono1, screen.width);
  const std::uint32_t first = 1 + stride * band_.top;
  const auto inked = [&](std::uint32_t x) { return (storage_.bits[first + x / 8] & 0x80 >> (x & 7)) != 0; };
  painter_.begin_line(band_.top, out.data());
  for (std::uint32_t x = 0; x < screen.width;) {
    const std::uint32_t left = x;
    const bool ink = inked(x);
    while (x < screen.width && inked(x) == ink) ++x;
    painter_.fill(left, x, ink ? ink_ : painter_.background());
  }
  ++band_.top;
  return true;
}

}  // namespace spanline
