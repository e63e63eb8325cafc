#include "core/vsg/band_vertices.hpp"

namespace spanline {

void BandVertices::begin(std::uint32_t count, std::int32_t top, std::int32_t bottom) {
  first_ = 0;
  last_ = static_cast<std::uint16_t>(count);
  for (std::uint32_t i = 1; i <= count; ++i) keys_[i] = 0;
  top_ = static_cast<std::uint16_t>(top);
  bottom_ = static_cast<std::uint16_t>(bottom);
  shift_ = 0;
  while ((bottom - 1 - top) >> shift_ >= kBelow - 1) ++shift_;
  filed_ = 0;
  planned_ = next_planned_ = 0;
}

void BandVertices::clear_band(std::int32_t top) {
  for (std::uint32_t i = 1; i <= filed_; ++i) keys_[band_[i].vertex] = 0;
  filed_ = 0;
  while (first_ != last_ && keys_[first_ + 1] == 0) ++first_;
  while (first_ != last_ && keys_[last_] == 0) --last_;
  band_top_ = end_ = static_cast<std::uint16_t>(top);
  if (next_planned_ == planned_) plan();
  if (next_planned_ == planned_) return;
  end_ = static_cast<std::uint16_t>(end_of(planned_ends_[next_planned_]));
  if (end_ - band_top_ > buckets_.capacity()) {
    end_ = static_cast<std::uint16_t>(band_top_ + buckets_.capacity());
  } else {
    ++next_planned_;
  }
  for (std::int32_t line = top; line < end_; ++line) buckets_[bucket(line)] = 0;
}

// Where this band and the next ones end, by counting the vertices of each key where those of a band will lie. None is
// planned where not even one key's fit.
void BandVertices::plan() {
  planned_ = next_planned_ = 0;
  auto* const counts = reinterpret_cast<std::uint8_t*>(band_.sink());
  const std::uint32_t most = (band_.capacity() + 1u) * sizeof(BandVertex);
  const std::uint32_t first = key_of(band_top_), all = key_of(bottom_ - 1) - first + 1u, keys = all < most ? all : most;
  for (std::uint32_t i = 0; i != keys; ++i) counts[i] = 0;
  const std::uint8_t* const end = &keys_[0] + 1 + last_;
  for (const std::uint8_t* key = &keys_[0] + 1 + first_; key != end; ++key) {
    const std::uint32_t i = *key - first;
    if (i < keys && counts[i] <= kMost) ++counts[i];
  }
  std::uint32_t room = band_.capacity();  // of the band that ends next
  for (std::uint32_t i = 0, begun = 0; planned_ != kMostPlanned;) {
    if (i != keys && counts[i] <= room) {
      room -= counts[i++];
      continue;
    }
    if (i == begun) return;
    planned_ends_[planned_++] = static_cast<std::uint8_t>(first + i - 1);
    begun = i;
    room = band_.capacity();
  }
}

// Notes the vertices that may be of the band, each with its key as BandVertex::next.
void BandVertices::gather() {
  if (end_ == band_top_) return;
  constexpr std::uint32_t kEach = 0x01010101;
  static_assert(kFiled == 0x80 && kBelow == kFiled - 1, "sums of two keys below it stay in their bytes");
  const std::uint32_t last = key_of(end_ - 1), beyond = (kBelow - last) * kEach;
  const std::uint8_t* const before = keys_.sink();  // of a vertex's key, at the vertex
  const std::uint8_t* const first = before + 1 + first_;
  BandVertex* out = band_.sink();
  const auto take = [&](const std::uint8_t* key) {
    ++out;
    out->vertex = static_cast<std::uint16_t>(key - before);
    out->next = *key;
  };
  const std::uint8_t* key = before + 1 + last_;
  const auto take_to = [&](const std::uint8_t* end) {
    while (key != end) {
      if (*--key - 1u < last) take(key);
    }
  };
  const std::size_t behind = reinterpret_cast<std::uintptr_t>(key) % 4;
  take_to(static_cast<std::size_t>(key - first) < behind ? first : key - behind);
  for (; key - first >= 4; key -= 4) {
    std::uint32_t four;
    __builtin_memcpy(&four, __builtin_assume_aligned(key - 4, 4), 4);
    std::uint32_t theirs = (four + kBelow * kEach) & ~(four + beyond) & kFiled * kEach;
    for (const std::uint8_t* at = key; theirs != 0; theirs <<= 8) {
      --at;
      if (theirs >> 31 != 0) take(at);
    }
  }
  take_to(first);
  filed_ = static_cast<std::uint8_t>(out - band_.sink());
}

}  // namespace spanline
