#include "core/shade/look_chains.hpp"

namespace spanline {

void LookChains::clear() {
  for (std::uint32_t i = 0; i <= last_head_; ++i) heads_[i] = 0;
  for (std::uint32_t i = 0; i <= last_look_; ++i) looks_[i].face = 0;
  looks_[0].material = FaceLook::kUnknown;
  oldest_ = 0;
}

std::uint8_t LookChains::give_way() {
  oldest_ = oldest_ == last_look_ ? std::uint8_t{1} : static_cast<std::uint8_t>(oldest_ + 1);
  // One that has not been made yet is in no chain.
  std::uint8_t* link = &heads_[head_of(looks_[oldest_].face)];
  while (*link != 0 && *link != oldest_) link = &links_[*link];
  if (*link != 0) *link = links_[oldest_];
  return oldest_;
}

}  // namespace spanline
