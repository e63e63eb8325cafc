// Small random scenes with the pictures that the oracle has made of them, as the host's make.cpp writes them down: a
// core that comes to the same checksums agrees with the oracle in every pixel.
#pragma once

#include "core/geom/screen.hpp"
#include "core/scene/format.hpp"

namespace spanline::target {

struct Expected {
  const char* name;
  const SceneRecord* scene;
  const CameraRecord* camera;
  Screen screen;
  bool edges;         // the edge walker draws it too
  std::uint32_t crc;  // CRC-32 of the oracle's faces row by row, two bytes each, the lower first; kNoFace: background
};

extern const Slice<const Expected> kExpected;

}  // namespace spanline::target
