#pragma once

#include "core/shade/brightness.hpp"

namespace spanline {

struct FaceColor {
  FaceId face;
  std::uint16_t color;  // as Painter::fill takes it
};
static_assert(sizeof(FaceColor) == 4);

// The colours of faces that were met lately, and of the background as that of face 0, each in the place that its number
// gives it. Assembly knows where each member stands.
class FaceColors {
 public:
  // Puts the colour of a face that is not known, and returns it.
  using Learn = std::uint16_t (*)(void* from, FaceId face);

  FaceColors() = default;
  FaceColors(PoolRef<FaceColor> colors, Learn learn, void* from)
      : colors_(colors.sink()), mask_(std::bit_floor(colors.capacity() + 1u) - 1u), from_(from), learn_(learn) {}

  // None is known; put(0) is to be said next.
  void clear() {
    for (std::uint32_t i = 0; i <= mask_; ++i) colors_[i].face = 0;
  }
  void put(FaceId face, std::uint16_t color) { colors_[face_place(face) & mask_] = {face, color}; }
  std::uint16_t operator[](FaceId face) const {
    const FaceColor& place = colors_[face_place(face) & mask_];
    return place.face == face ? place.color : learn_(from_, face);
  }

 private:
  FaceColor* colors_ = nullptr;
  std::uint32_t mask_ = 0;
  void* from_ = nullptr;
  Learn learn_ = nullptr;
};

}  // namespace spanline
