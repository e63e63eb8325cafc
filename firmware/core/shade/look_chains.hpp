#pragma once

#include <bit>

#include "core/shade/brightness.hpp"

namespace spanline {

// The looks made last, any face's in any place: those of faces with like numbers are a chain, whose head is the one met
// last.
class LookChains {
 public:
  static constexpr std::uint32_t kMostHeads = 256;
  // What a scene of so many faces takes.
  static constexpr std::uint32_t heads_for(std::uint32_t faces) {
    return faces < kMostHeads ? std::bit_ceil(faces + 1) : kMostHeads;
  }
  static constexpr std::uint32_t head_of(FaceId face) { return face_place(face) % kMostHeads; }
  static_assert(kMostHeads == 1u << 8, "assembly cuts it off");

  LookChains() = default;
  // As many links as looks, of which SmoothCache::kMostLooks are used.
  LookChains(PoolRef<FaceLook> looks, PoolRef<std::uint8_t> heads, PoolRef<std::uint8_t> links)
      : looks_(looks.sink()),
        heads_(heads.sink()),
        links_(links.sink()),
        last_look_(at_most(SmoothCache::kMostLooks, looks.capacity())),
        last_head_(at_most(kMostHeads - 1, heads.capacity())) {}

  FaceLook* looks() const { return looks_; }
  const std::uint8_t* heads() const { return heads_; }  // of the chains of head_of(), numbers of looks
  std::uint32_t most_faces() const { return last_head_ < kMostHeads - 1 ? last_head_ : UINT16_MAX; }

  // At the beginning of a frame, after SmoothCache::clear(): none is known.
  void clear();
  // The face's look, now its chain's head; make(FaceLook&) makes all but its face where
  // it is not here. Valid until the next call.
  template <typename Make>
  FaceLook& look(FaceId face, const Make& make) {
    std::uint8_t* const head = &heads_[head_of(face)];
    std::uint8_t* link = head;
    while (*link != 0 && looks_[*link].face != face) link = &links_[*link];
    std::uint8_t at = *link;
    if (at != 0) {
      *link = links_[at];
    } else {
      at = give_way();
      make(looks_[at]);
      looks_[at].face = face;
    }
    links_[at] = *head;
    *head = at;
    return looks_[at];
  }
  // Another look of its face.
  void put(const FaceLook& other) {
    look(other.face, [](FaceLook&) {}) = other;
  }

 private:
  static std::uint8_t at_most(std::uint32_t most, std::uint32_t n) {
    return static_cast<std::uint8_t>(n < most ? n : most);
  }
  // The place of the look that was made first.
  std::uint8_t give_way();

  FaceLook* looks_ = nullptr;  // looks_[0] is no face's, and ends the chains
  std::uint8_t *heads_ = nullptr, *links_ = nullptr;
  std::uint8_t last_look_ = 0, last_head_ = 0, oldest_ = 0;
};

}  // namespace spanline
