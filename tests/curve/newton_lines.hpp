// Scan lines through curves and patches by Newton's iteration (Whitted 1978, Blinn 1978): what it costs, and how often
// it fails.
#pragma once

#include <cstdint>

#include "curve/screen_net.hpp"

namespace spanline::test {

struct Newton {
  // A crossing is a root that was looked for, an iteration a point computed with its derivatives.
  std::uint64_t crossings = 0, failures = 0, iterations = 0;

  // The scan lines that a curve meets, each begun at the root on the line above. A failure ends nowhere within ten
  // iterations, or outside of the curve's monotone part.
  void curve(const Cubic& curve);

  // The pixels of one of a patch's sheets, each begun at the place of the one to its left. A failure ends nowhere, off
  // the patch, or on the other sheet.
  void sheet(const ScreenNet& net, const ScreenNet::Sheet& sheet);

 private:
  static constexpr int kMost = 10;
  static constexpr double kNear = 1.0 / 32;  // px
  void strand(const Cubic& curve, double from, double to);
  bool place(const ScreenNet& net, At centre, ScreenNet::Root& root);
};

}  // namespace spanline::test
