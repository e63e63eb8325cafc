#include "core/vsg/band_vertices.hpp"

namespace spanline {

void BandVertices::begin(std::uint32_t count, std::int32_t top, std::int32_t bottom) {
  count_ = count;
  first_ = 0;
  for (std::uint32_t i = 1; i <= count; ++i) keys_[i] = 0;
  for (std::uint32_t i = 0; i <= place_mask_; ++i) band_[i].vertex = 0;
  top_ = top;
  bottom_ = bottom;
  shift_ = 0;
  while ((bottom - 1 - top) >> shift_ >= kBelow - 1) ++shift_;
  filed_ = 0;
}

void BandVertices::begin_band(std::int32_t top) {
  for (std::uint32_t i = 1; i <= filed_; ++i) keys_[band_[i].vertex] = 0;
  filed_ = 0;
  while (first_ != count_ && keys_[first_ + 1] == 0) ++first_;
  band_top_ = top;
  end_ = longest();
  last_key_ = end_ > top ? key_of(end_ - 1) : 0;
  for (std::int32_t line = top; line < end_; ++line) buckets_[bucket(line)] = 0;
}

// Where the band ends, by counting the vertices of each key in the buckets.
std::int32_t BandVertices::longest() const {
  const std::int32_t most = band_top_ + buckets_.capacity(), last = most < bottom_ ? most : bottom_;
  if (last == band_top_) return last;
  const std::uint32_t first = key_of(band_top_), keys = key_of(last - 1) - first + 1;
  std::uint8_t* const counts = &buckets_[1];
  for (std::uint32_t i = 0; i != keys; ++i) counts[i] = 0;
  const std::uint8_t* key = &keys_[0] + 1 + first_;
  for (const std::uint8_t* const end = &keys_[0] + 1 + count_; key != end; ++key) {
    if (*key - first < keys && counts[*key - first] <= kMost) ++counts[*key - first];
  }
  std::uint32_t room = band_.capacity(), i = 0;
  for (; i != keys && counts[i] <= room; ++i) room -= counts[i];
  if (i == keys) return last;
  const std::int32_t end = top_ + static_cast<std::int32_t>((first + i - 1) << shift_);
  return end > band_top_ ? end : band_top_;
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
