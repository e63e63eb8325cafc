#pragma once

#include "core/shade/look_chains.hpp"

namespace spanline {

// Where a face's look is among those that are kept: each face has a slot for the number, and slots[0] is 0;
struct LookSlots {
  const std::uint8_t* slots = nullptr;
  std::uint32_t operator()(FaceId face) const { return slots[face]; }
};
// or it is the head of a chain.
struct LookHeads {
  const std::uint8_t* heads = nullptr;
  std::uint32_t operator()(FaceId face) const { return heads[LookChains::head_of(face)]; }
};

// What the smooth spans of a line are painted with, as long as one material lasts. Assembly knows where each member
// stands.
template <typename Find>
class Brush {
 public:
  Brush() = default;
  Brush(FaceLook* looks, Find find) : looks_(looks), find_(find) {}

  void begin_line(std::uint16_t line) { line_ = line; }
  // Likewise where looks[0] is the background's.
  void begin_line(std::uint16_t line, std::uint16_t background) {
    begin_line(line);
    looks_[0] = FaceLook::flat(background);
  }
  // `colors` are those that were looked up last: no other material's take their place.
  void dip(std::uint16_t material, const std::uint16_t* colors) {
    material_ = std::uint32_t{material} << 16;
    colors_ = colors;
  }

  const FaceLook& look(FaceId face) const { return looks_[find_(face)]; }
  // Whether it is this face's, and of the brush's material.
  bool knows(FaceId face, const FaceLook& look) const {
    return (look.face | std::uint32_t{look.material} << 16) == (face | material_);
  }
  std::uint32_t line() const { return line_; }
  const std::uint16_t* colors() const { return colors_; }

 private:
  static constexpr std::uint32_t kDry = std::uint32_t{FaceLook::kNoMaterial - 1u} << 16;
  static_assert(kDry >> 16 > FaceLook::kUnknown);

  FaceLook* looks_ = nullptr;
  Find find_;
  std::uint32_t material_ = kDry;  // in the upper half
  std::uint32_t line_ = 0;
  const std::uint16_t* colors_ = nullptr;
};

// One that sees to the looks that it does not know.
template <typename Find>
class LearningBrush : public Brush<Find> {
 public:
  // Makes the look of a face, or of none where that is asked for, findable, and dips the brush where it is smooth.
  using Learn = void (*)(void* from, FaceId face);

  LearningBrush() = default;
  LearningBrush(FaceLook* looks, Find find, Learn learn, void* from)
      : Brush<Find>(looks, find), from_(from), learn_(learn) {}

  // What it is known by then, if it is not of one colour.
  const FaceLook& learned(FaceId face) const {
    const FaceLook& look = this->look(face);
    if (this->knows(face, look) || look.flat_of(face)) [[likely]]
      return look;
    learn_(from_, face);
    return this->look(face);
  }

 private:
  void* from_ = nullptr;
  Learn learn_ = nullptr;
};
using SmoothBrush = LearningBrush<LookSlots>;
using BandBrush = LearningBrush<LookHeads>;

}  // namespace spanline
