#pragma once

#include "core/shade/brightness.hpp"

namespace spanline {

// What the smooth spans of a line are painted with, as long as one material lasts. Assembly knows where each member
// stands.
class SmoothBrush {
 public:
  SmoothBrush() = default;
  // slots[face] is the number of the face's look; slots[0] that of a look that is no face's.
  SmoothBrush(const FaceLook* looks, const std::uint8_t* slots) : looks_(looks), slots_(slots) {}

  void begin_line(std::uint16_t line, std::uint16_t background) {
    line_ = line;
    background_ = background;
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
  std::uint16_t background() const { return static_cast<std::uint16_t>(background_); }
  const std::uint16_t* colors() const { return colors_; }

 private:
  static constexpr std::uint32_t kDry = std::uint32_t{FaceLook::kNoMaterial - 1u} << 16;

  const FaceLook* looks_ = nullptr;
  const std::uint8_t* slots_ = nullptr;
  std::uint32_t material_ = kDry;  // in the upper half
  std::uint32_t line_ = 0;
  const std::uint16_t* colors_ = nullptr;
  std::uint32_t background_ = 0;
};

}  // namespace spanline
