#pragma once

#include "core/shade/brightness.hpp"

namespace spanline {

// What the smooth spans of a line are painted with, as long as one material lasts. Assembly knows where each member
// stands.
class SmoothBrush {
 public:
  SmoothBrush() = default;
  // slots[face] is the number of the face's look. looks[0] is the background's, and slots[0] is 0.
  SmoothBrush(FaceLook* looks, const std::uint8_t* slots) : looks_(looks), slots_(slots) {}

  void begin_line(std::uint16_t line, std::uint16_t background) {
    line_ = line;
    looks_[0] = FaceLook::flat(background);
  }
  // `colors` are those that were looked up last: no other material's take their place.
  void dip(std::uint16_t material, const std::uint16_t* colors) {
    material_ = std::uint32_t{material} << 16;
    colors_ = colors;
  }

  const FaceLook& look(FaceId face) const { return looks_[slots_[face]]; }
  // Whether it is this face's, and of the brush's material.
  bool knows(FaceId face, const FaceLook& look) const {
    return (look.face | std::uint32_t{look.material} << 16) == (face | material_);
  }
  std::uint32_t line() const { return line_; }
  const std::uint16_t* colors() const { return colors_; }

 private:
  static constexpr std::uint32_t kDry = std::uint32_t{FaceLook::kNoMaterial - 1u} << 16;

  FaceLook* looks_ = nullptr;
  const std::uint8_t* slots_ = nullptr;
  std::uint32_t material_ = kDry;  // in the upper half
  std::uint32_t line_ = 0;
  const std::uint16_t* colors_ = nullptr;
};

}  // namespace spanline
