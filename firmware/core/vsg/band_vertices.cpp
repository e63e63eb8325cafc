#include "core/vsg/band_vertices.hpp"

namespace spanline {

void BandVertices::begin(std::uint32_t count, std::int32_t top, std::int32_t bottom) {
  count_ = count;
  first_ = 0;
  for (std::uint32_t i = 1; i <= count; ++i) keys_[i] = 0;
  top_ = top;
  bottom_ = bottom;
  shift_ = 0;
  while ((bottom - 1 - top) >> shift_ >= kBelow - 1) ++shift_;
  filed_ = 0;
  planned_ = next_planned_ = 0;
}

void BandVertices::begin_band(std::int32_t top) {
  for (std::uint32_t i = 1; i <= filed_; ++i) keys_[band_[i].vertex] = 0;
  filed_ = 0;
  while (first_ != count_ && keys_[first_ + 1] == 0) ++first_;
  band_top_ = top;
  if (next_planned_ == planned_) plan();
  if (next_planned_ != planned_) end_ = top_ + ((planned_ends_[next_planned_++] - 1) << shift_);
  last_key_ = end_ > top ? key_of(end_ - 1) : 0;
  for (std::int32_t line = top; line < end_; ++line) buckets_[bucket(line)] = 0;
}

// Where this band and the next ones end, by counting the vertices of each key in the buckets. None is planned where not
// even one key's vertices fit, or all that the buckets have lines for.
void BandVertices::plan() {
  const std::int32_t most = band_top_ + buckets_.capacity(), last = most < bottom_ ? most : bottom_;
  planned_ = next_planned_ = 0;
  end_ = last;
  if (last == band_top_) return;
  const std::uint32_t first = key_of(band_top_), keys = key_of(last - 1) - first + 1;
  std::uint8_t* const counts = &buckets_[1];
  for (std::uint32_t i = 0; i != keys; ++i) counts[i] = 0;
  const std::uint8_t* key = &keys_[0] + 1 + first_;
  for (const std::uint8_t* const end = &keys_[0] + 1 + count_; key != end; ++key) {
    if (*key - first < keys && counts[*key - first] <= kMost) ++counts[*key - first];
  }
  std::uint32_t room = band_.capacity(), begun = 0;  // of the band that ends next
  for (std::uint32_t i = 0; i != keys; ++i) {
    if (counts[i] > room) {
      if (i == begun) {
        if (i == 0) end_ = band_top_;
        return;
      }
      planned_ends_[planned_++] = static_cast<std::uint8_t>(first + i);
      if (planned_ == kMostPlanned) return;
      room = band_.capacity();
      begun = i--;
      continue;
    }
    room -= counts[i];
  }
}

// The first of the four keys at `key`, and so on up to `end`, with one of 1 to `last`, or those that stand in no whole
// word.
const std::uint8_t* BandVertices::skip(const std::uint8_t* key, const std::uint8_t* end, std::uint32_t last) {
  constexpr std::uint32_t kEach = 0x01010101, kFiledBits = kFiled * kEach;
  static_assert(kFiled == 0x80 && kBelow == kFiled - 1, "sums of two keys below it stay in their bytes");
  const std::uint32_t beyond = (kBelow - last) * kEach;
  for (; end - key >= 4; key += 4) {
    std::uint32_t four;
    __builtin_memcpy(&four, __builtin_assume_aligned(key, 4), 4);
    const std::uint32_t low = four & ~kFiledBits;
    if (((low + kBelow * kEach) & ~(low + beyond) & ~four & kFiledBits) != 0) break;
  }
  return key;
}

// The same, where it is not `from`.
std::uint32_t BandVertices::look_on(std::uint32_t from) const {
  const std::uint8_t *const first = &keys_[0] + 1, *const end = first + count_, *key = first + from;
  while (key != end) {
    if (reinterpret_cast<std::uintptr_t>(key) % 4 == 0) {
      key = skip(key, end, last_key_);
      if (key == end) break;
    }
    if (*key - 1u < last_key_) break;
    ++key;
  }
  return static_cast<std::uint32_t>(key - first);
}

void BandVertices::file(std::uint32_t vertex, ScreenXY at) {
  const std::int32_t line = first_line(at);
  if (line >= end_) return;
  std::uint8_t* link = &buckets_[bucket(line)];
  while (*link != 0 && band_[*link].at.x < at.x) link = &band_[*link].next;
  band_[++filed_] = {at, static_cast<std::uint16_t>(vertex + 1), *link, BandVertex::kNoLevel};
  *link = filed_;
  keys_[vertex + 1] = static_cast<std::uint8_t>(kFiled + filed_);
}

}  // namespace spanline
