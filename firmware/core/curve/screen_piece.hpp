// A piece of a patch on the screen, as points are stepped off it.
#pragma once

#include <cstdint>

namespace spanline {

// The pixels that are worked for: columns [0, width) of the lines [top, bottom).
struct PointWindow {
  std::int32_t top, bottom, width;
};

// Coordinates of a piece: x and y are Q13.19 px, depth is Q16.10.
inline constexpr int kPointBits = 19;
inline constexpr int kPointDepthBits = 10;
enum PointAxis : int { kPointX, kPointY, kPointDepth, kPointAxes };

// A direction of the patch: the piece is the part [index, index + 1] / 2^level of it.
struct PieceRange {
  std::uint32_t index = 0, level = 0;
};

// Which side of the patch is seen, the one from which u and v turn counter-clockwise being its front.
enum class PieceSide : std::uint8_t { front, back, mixed };

struct ScreenPiece {
  std::int32_t at[kPointAxes][4][4];  // control points: rows i, points j of a row
  std::uint32_t rows, columns;        // steps, 1 … kMostPieceSteps
  PieceRange u, v;
  bool turned;     // rows run along v, not along u
  PieceSide side;  // mixed also where it is not known
};

// A piece that would need more is cut.
inline constexpr std::uint32_t kPieceSteps = 16;
// What bending the net to the projected patch's tangents may make of that.
inline constexpr std::uint32_t kMostPieceSteps = 24;
// 63/64 px: the rest is for roundings, and for what neighbouring pieces may differ where they meet.
inline constexpr std::int32_t kLongestStep = 63 << (kPointBits - 6);

// What a piece's control points reach to on the screen: x and y, Q13.19 px.
struct PieceExtent {
  std::int32_t least[2] = {INT32_MAX, INT32_MAX}, most[2] = {INT32_MIN, INT32_MIN};

  explicit PieceExtent(const ScreenPiece& piece);

  // A pixel is added all round: so far, and no farther, the piece stepped off may leave the hull of its projected net.
  bool meets(const PointWindow& window) const {
    return (most[kPointX] >> kPointBits) >= -1 && (least[kPointX] >> kPointBits) <= window.width &&
           (most[kPointY] >> kPointBits) >= window.top - 1 && (least[kPointY] >> kPointBits) <= window.bottom;
  }
  // All within an eighth of a pixel.
  bool is_speck() const {
    constexpr std::int32_t kSpeck = 1 << (kPointBits - 3);
    return most[kPointX] - least[kPointX] <= kSpeck && most[kPointY] - least[kPointY] <= kSpeck;
  }
};

// Steps that keep neighbours within kLongestStep, along rows and along columns.
void count_steps(ScreenPiece& piece);

// Between its corners a speck goes straight in depth, which may change by more there than curves have room for.
void straighten(std::int32_t (&at)[4][4]);

// `mirrored`: the patch's instance is.
PieceSide side_of(const ScreenPiece& piece, bool mirrored);

// Turns the piece so that its rows are the flatter ones on the screen: a band then meets fewer of them.
void turn_flat(ScreenPiece& piece);

}  // namespace spanline
