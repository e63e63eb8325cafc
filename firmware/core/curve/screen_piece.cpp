#include "core/curve/screen_piece.hpp"

namespace spanline {
namespace {

std::int32_t magnitude(std::int32_t v) { return v < 0 ? -v : v; }

std::uint32_t steps_for(std::int32_t longest_leg) {
  constexpr int kShift = 8;  // Q13.11 px: no piece is short of a step for that
  const auto length = static_cast<std::uint32_t>(3 * ((longest_leg >> kShift) + 1));
  constexpr auto kStep = static_cast<std::uint32_t>(kLongestStep >> kShift);
  return (length + kStep - 1) / kStep;
}
static_assert(3 * ((INT32_MAX >> 8) + 1) > 0 && kLongestStep % (1 << 8) == 0);

struct Leg {
  std::int32_t x, y;  // 1/1024 px
};
std::int32_t cross(const Leg& a, const Leg& b) { return a.x * b.y - a.y * b.x; }
std::int32_t dot(const Leg& a, const Leg& b) { return a.x * b.x + a.y * b.y; }
static_assert((kMostPieceSteps / 3 << 10) * (kMostPieceSteps / 3 << 10) < 1u << 30, "the sum of two products fits");

// The legs along rows, or along columns, lie between two of them.
struct Cone {
  Leg first{}, last{};
  bool narrow = true;  // all lie within a quarter turn of one of them

  Cone(const ScreenPiece& piece, bool rows) {
    Leg middle{};
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 3; ++j) {
        const auto leg = [&](PointAxis axis) {
          const auto& at = piece.at[axis];
          return (rows ? at[i][j + 1] - at[i][j] : at[j + 1][i] - at[j][i]) >> (kPointBits - 10);
        };
        const Leg l{leg(kPointX), leg(kPointY)};
        if (l.x == 0 && l.y == 0) continue;
        if (middle.x == 0 && middle.y == 0) first = last = middle = l;
        if (dot(middle, l) <= 0) narrow = false;
        if (cross(l, first) > 0) first = l;
        if (cross(last, l) > 0) last = l;
      }
    }
  }
};

}  // namespace

PieceExtent::PieceExtent(const ScreenPiece& piece) {
  for (int axis = kPointX; axis <= kPointY; ++axis) {
    for (const auto& row : piece.at[axis]) {
      for (const std::int32_t v : row) {
        least[axis] = v < least[axis] ? v : least[axis];
        most[axis] = v > most[axis] ? v : most[axis];
      }
    }
  }
}

void count_steps(ScreenPiece& piece) {
  std::int32_t along = 0, across = 0;
  const auto raise = [](std::int32_t& most, std::int32_t a, std::int32_t b) {
    const std::int32_t leg = magnitude(a - b);
    if (leg > most) most = leg;
  };
  for (int axis = kPointX; axis <= kPointY; ++axis) {
    const auto& at = piece.at[axis];
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 3; ++j) {
        raise(along, at[i][j + 1], at[i][j]);
        raise(across, at[j + 1][i], at[j][i]);
      }
    }
  }
  piece.columns = steps_for(along);
  piece.rows = steps_for(across);
}

void straighten(std::int32_t (&at)[4][4]) {
  const auto along = [](std::int32_t first, std::int32_t& second, std::int32_t& third, std::int32_t last) {
    const std::int32_t part = (last - first) / 3;
    second = first + part;
    third = last - part;
  };
  for (int i = 0; i < 4; i += 3) along(at[i][0], at[i][1], at[i][2], at[i][3]);
  for (int j = 0; j < 4; ++j) along(at[0][j], at[1][j], at[2][j], at[3][j]);
}

// Tangents are sums of legs with weights that are not negative; so is, of the products of the cones' rims, by which
// side the tangents turn.
PieceSide side_of(const ScreenPiece& piece, bool mirrored) {
  const Cone u(piece, true), v(piece, false);
  if (!u.narrow || !v.narrow) return PieceSide::mixed;
  const std::int32_t turns[4] = {cross(u.first, v.first), cross(u.first, v.last), cross(u.last, v.first),
                                 cross(u.last, v.last)};
  bool left = true, right = true;  // y points down: fronts turn left
  for (const std::int32_t turn : turns) {
    left = left && turn < 0;
    right = right && turn > 0;
  }
  if (left == right) return PieceSide::mixed;
  return left != mirrored ? PieceSide::front : PieceSide::back;
}

void turn_flat(ScreenPiece& piece) {
  std::int32_t along = 0, across = 0;
  const auto& y = piece.at[kPointY];
  for (int i = 0; i < 4; ++i) {
    along += magnitude(y[i][3] - y[i][0]) >> 3;
    across += magnitude(y[3][i] - y[0][i]) >> 3;
  }
  piece.turned = along > across;
  if (!piece.turned) return;
  for (auto& at : piece.at) {
    for (int i = 1; i < 4; ++i) {
      for (int j = 0; j < i; ++j) {
        const std::int32_t kept = at[i][j];
        at[i][j] = at[j][i];
        at[j][i] = kept;
      }
    }
  }
  const std::uint32_t rows = piece.rows;
  piece.rows = piece.columns;
  piece.columns = rows;
}

}  // namespace spanline
