// Pieces of a patch that points are stepped off from: so small on the screen that they can be walked there, in 32 bits.
//
// A patch is cut in halves (de Casteljau) until a piece is at most kPieceSteps pixels long each way. There the piece is
// taken to the screen as a bicubic patch whose points, tangents and twists at the corners are those of the projected
// one, which it then follows within a sixth of a pixel (tests): perspective is paid once a piece, not once a point.
//
// What is cut is what makes the piece too much: the direction with the more steps where it is long on the screen, the
// one that its distance changes along where that changes by more than an eighth, for perspective to be followed. So few
// are cut: a patch seen along itself, which covers next to nothing, is cut across its depth, never along what is short
// already. Where all of a deep piece lies within an eighth of a pixel, its corners are all that there is to see of it.
//
// Why no hole is left. A piece is stepped off on a grid of rows x columns points, so many that by the bound of its
// derivatives (three times the longest leg of its control net, the maximum norm) neighbours on the grid are at most
// kLongestStep apart in x and in y. Their pixels then touch, by a side or a corner. Take the pixels' centres as the
// corners of a surface of quadrangles: a quadrangle whose four sides join touching pixels holds no other pixel's centre
// than its corners', but for one shape, the diamond about a pixel, and that pixel is filled (PointRows). So
// this surface is covered without a hole. No point of it is farther than half a pixel, in x or in y, from where the
// piece has it, and the piece's walk from the patch; so a sheet of the patch that covers the whole square of a pixel
// turns once about its centre, and so does the surface of quadrangles: the pixel is covered. Where two pieces meet,
// both step off the same curve with steps shorter than a pixel, and merged they are a chain of touching pixels.
#pragma once

#include <cstdint>

#include "core/curve/dice.hpp"
#include "core/curve/screen_piece.hpp"

namespace spanline {

// Cuts a patch and yields the pieces of it that may cover a pixel of the window. Which pieces there are does not
// depend on the window. Parts nearer than half the near plane (and than a 2048th of a world unit), what kMostCuts cuts
// leave too long, and what kMostDepthCuts leave too deep, are left out.
class PieceCutter {
 public:
  // `patch` and `projection` must outlive the cutter.
  // `mirrored`: the patch's instance is.
  PieceCutter(const ClipPatch& patch, const Projection& projection, const PointWindow& window, bool mirrored);

  bool next(ScreenPiece& out);
  // Nets looked at so far: the work done.
  std::uint32_t looks() const { return looks_; }

 private:
  static constexpr std::uint32_t kMostCuts = 32;
  // Halvings of either direction for what is too deep: where a patch crosses the near plane at a slant to both its
  // directions, pieces along the crossing are as many as that allows; more than eight to a pixel would be for nothing.
  // What lies nearer than a 500th of the patch's own depth may be lost by it.
  static constexpr std::uint32_t kMostDepthCuts = 12;
  static constexpr std::int32_t kNearest = 64;  // Q16.16: nearer, rounding would be as much as what is to be cut
  enum class Verdict : std::uint8_t { nothing, cut, piece };

  Verdict look(ScreenPiece& out);
  bool aside() const;
  bool project(ScreenPiece& out) const;
  void fit(ScreenPiece& piece) const;
  void descend();
  void advance();
  void enter(std::uint32_t cut);
  void leave(std::uint32_t cut);
  void cut_again();

  const ClipPatch& patch_;
  const Projection& projection_;
  PointWindow window_;
  std::int32_t borders_[4];  // of the window, a pixel added, from the centre: left, right, top, bottom; px
  bool mirrored_;
  ClipPatch net_;
  PieceRange u_, v_;
  // The cuts that led here, bit by bit from the first: along which direction, and whether to the second half. Where a
  // second half is not among those kept any more, the cuts to it are made again.
  std::uint32_t along_u_ = 0, second_ = 0, cuts_ = 0;
  std::uint32_t looks_ = 0;
  bool cut_u_ = false;  // the direction to cut next
  bool done_ = false;
  static constexpr std::uint32_t kKept = 2;
  static constexpr std::uint8_t kNone = kMostCuts;
  ClipPatch kept_[kKept];  // second halves of the last cuts
  std::uint8_t kept_of_[kKept] = {kNone, kNone};
};

}  // namespace spanline
