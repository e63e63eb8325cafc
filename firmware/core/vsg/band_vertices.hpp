#pragma once

#include <bit>

#include "core/base/pool.hpp"
#include "core/geom/screen.hpp"

namespace spanline {

struct BandVertex {
  ScreenXY at;
  std::uint16_t vertex;  // 1 + its number in the scene; 0: none
  std::uint8_t next;     // on the same line, not left of it
  std::uint8_t level;    // its brightness, or kNoLevel

  static constexpr std::uint8_t kNoLevel = 0xff;
};
static_assert(sizeof(BandVertex) == 8);

// The vertices that the lines of a frame will reach: of each is known about where, in a byte, and of those of a band of
// lines the place, filed under their first ones. A band is the longest that its vertices and lines fit.
class BandVertices {
 public:
  static constexpr std::uint16_t kMost = 126;  // that are used of a band

  BandVertices() = default;
  // A byte a vertex, one a line of a band.
  BandVertices(PoolRef<BandVertex> band, PoolRef<std::uint8_t> keys, PoolRef<std::uint8_t> buckets)
      : band_(band), keys_(keys), buckets_(buckets) {
    band_.limit(kMost);
  }
  std::uint16_t capacity() const { return keys_.capacity(); }

  // Begins a frame of the lines [top, bottom): none of `count` vertices waits.
  void begin(std::uint32_t count, std::int32_t top, std::int32_t bottom);
  // The vertices of one mesh, by their numbers in it.
  class Mesh {
   public:
    // `first`: the mesh's first over the scene.
    Mesh(const BandVertices& of, std::uint32_t first) : of_(of), keys_(&of.keys_[first + 1]) {}

    // What is marked waits for its first line, once place(vertex) has told where it lies of each of the first `count`.
    void mark(std::uint32_t vertex) const { keys_[vertex] = 1; }
    template <typename Place>
    void wait(std::uint32_t count, const Place& place) const {
      const BandVertices of = of_;
      std::uint8_t* const keys = keys_;
      for (std::uint32_t vertex = 0; vertex != count; ++vertex) {
        if (keys[vertex] != 0) keys[vertex] = of.key_of(of.first_line(place(vertex)));
      }
    }

   private:
    const BandVertices& of_;
    std::uint8_t* keys_;
  };
  // The line that reaches it: those above the frame are its first line's.
  std::int32_t first_line(ScreenXY at) const {
    const std::int32_t line = first_centre(at.y);
    return line > top_ ? line : top_;
  }

  // Until begin_band(): where a vertex may be kept meanwhile, by the name in it; none is once they are forgotten.
  BandVertex& place(std::uint32_t vertex) { return band_[vertex & (std::bit_floor(band_.capacity() + 1u) - 1)]; }
  void forget_places() {
    for (std::uint32_t i = 0; i <= band_.capacity(); ++i) band_[i].vertex = 0;
  }

  std::uint32_t first() const { return first_; }
  std::uint32_t last() const { return last_; }
  // Begins the longest band from `top` on and files its vertices, place(vertex) is where one lies. It ends at its top
  // where not even that line's vertices fit.
  template <typename Place>
  void begin_band(std::int32_t top, const Place& place);
  std::int32_t end() const { return end_; }

  // The vertices of a line of the band from left to right: the place of the first; BandVertex::next tells the others'.
  bool is_empty(std::int32_t line) const { return first_of(line) == 0; }
  std::uint32_t first_of(std::int32_t line) const { return buckets_[bucket(line)]; }
  const BandVertex* band() const { return band_.sink(); }
  // A vertex that is not of the band, alone; its place.
  std::uint32_t alone(std::uint32_t vertex, ScreenXY at) const {
    band_[0] = {at, static_cast<std::uint16_t>(vertex + 1), 0, BandVertex::kNoLevel};
    return 0;
  }
  // What is known of the vertices from `first` on: 0 of those that do not wait, kFiled + the place of those of the
  // band, between them about the first line.
  const std::uint8_t* keys(std::uint32_t first) const { return &keys_[first + 1]; }
  static constexpr std::uint8_t kFiled = 128;

  // Likewise the first that may be one of `line` and is not filed; it has been reached.
  std::uint32_t next_to_reach(std::uint32_t from, std::int32_t line) const { return next(from, key_of(line), 1); }
  void reach(std::uint32_t vertex) { keys_[vertex + 1] = 0; }

  // A vertex of the band; null: it is none of it.
  BandVertex* find(std::uint32_t vertex) const {
    const std::uint8_t key = keys_[vertex + 1];
    return key > kFiled ? &band_[key - kFiled] : nullptr;
  }

 private:
  static constexpr std::uint8_t kBelow = kFiled - 1;

  std::uint8_t key_of(std::int32_t line) const {
    return line < bottom_ ? static_cast<std::uint8_t>(1 + ((line - top_) >> shift_)) : kBelow;
  }
  std::uint32_t bucket(std::int32_t line) const { return static_cast<std::uint32_t>(line - band_top_ + 1); }
  std::int32_t end_of(std::uint32_t key) const {
    const auto line = static_cast<std::int32_t>(top_ + (key << shift_));
    return line < bottom_ ? line : bottom_;
  }
  void clear_band(std::int32_t top);
  void gather();
  void plan();
  // The first vertex with one of `keys` keys from `first` on.
  std::uint32_t next(std::uint32_t from, std::uint32_t first, std::uint32_t keys) const {
    const std::uint8_t *key = &keys_[0] + 1 + from, *const end = &keys_[0] + 1 + last_;
    while (key != end && *key - first >= keys) ++key;
    return static_cast<std::uint32_t>(key - (&keys_[0] + 1));
  }

  PoolRef<BandVertex> band_;
  PoolRef<std::uint8_t> keys_, buckets_;
  std::uint16_t first_ = 0, last_ = 0;  // vertices before the one and from the other on have been reached, or never are
  std::uint16_t top_ = 0, bottom_ = 0;  // of the frame
  std::uint16_t band_top_ = 0, end_ = 0;  // of the band
  std::uint8_t shift_ = 0;                // of lines to keys
  std::uint8_t filed_ = 0;
  // The last keys of the next bands.
  static constexpr std::uint8_t kMostPlanned = 14;
  std::uint8_t planned_ = 0, next_planned_ = 0;
  std::uint8_t planned_ends_[kMostPlanned];
};

// Backwards, as a line's vertices are mostly met from left to right then.
template <typename Place>
void BandVertices::begin_band(std::int32_t top, const Place& place) {
  clear_band(top);
  gather();
  BandVertex* const band = band_.sink();
  std::uint8_t* const buckets = &buckets_[1];
  const std::int32_t end = end_;
  std::uint32_t filed = 0;
  for (std::uint32_t i = 1, gathered = filed_; i <= gathered; ++i) {
    const std::uint16_t vertex = band[i].vertex;
    const ScreenXY at = place(vertex - 1u);
    const std::int32_t line = first_line(at);
    if (line >= end) {  // with lines of the band in one key
      keys_[vertex] = band[i].next;
      continue;
    }
    std::uint8_t* link = buckets + (line - top);
    while (*link != 0 && band[*link].at.x < at.x) link = &band[*link].next;
    band[++filed] = {at, vertex, *link, BandVertex::kNoLevel};
    *link = static_cast<std::uint8_t>(filed);
    keys_[vertex] = static_cast<std::uint8_t>(kFiled + filed);
  }
  filed_ = static_cast<std::uint8_t>(filed);
}

}  // namespace spanline
