#include "core/curve/point_piece.hpp"

namespace spanline {
namespace {

// What may be projected here: one and a half times the guard band.
constexpr std::int64_t border(std::int32_t w) { return std::int64_t{w} + w / 2; }
constexpr std::int32_t kBorderPx = kGuardPx + kGuardPx / 2;

std::int32_t clamp(std::int32_t v, std::int64_t limit) {
  return static_cast<std::int32_t>(v > limit ? limit : v < -limit ? -limit : v);
}

// The mean of two coordinates, halves upwards: the same seen from either end.
std::int32_t middle(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>((std::int64_t{a} + b + 1) >> 1);
}
ClipPoint middle(const ClipPoint& a, const ClipPoint& b) {
  return {middle(a.x, b.x), middle(a.y, b.y), middle(a.w, b.w)};
}

// Leaves the first half of a curve whose points are `step` apart, and writes the second.
void halve_curve(ClipPoint* p, int step, ClipPoint* second) {
  ClipPoint &p0 = p[0], &p1 = p[step], &p2 = p[2 * step], &p3 = p[3 * step];
  const ClipPoint a = middle(p0, p1), b = middle(p1, p2), c = middle(p2, p3);
  const ClipPoint ab = middle(a, b), bc = middle(b, c), all = middle(ab, bc);
  second[0] = all, second[step] = bc, second[2 * step] = c, second[3 * step] = p3;
  p1 = a, p2 = ab, p3 = all;
}

// Leaves the first half of a net, and writes the second.
void halve_net(ClipPatch& net, bool along_u, ClipPatch& second) {
  for (int k = 0; k < 4; ++k) {
    if (along_u) {
      halve_curve(net.at[k], 1, second.at[k]);
    } else {
      halve_curve(&net.at[0][k], 4, &second.at[0][k]);
    }
  }
}

// Whether the distance changes along u at least as much as along v.
bool deeper_along_u(const ClipPatch& net) {
  std::uint32_t along = 0, across = 0;
  const auto raise = [](std::uint32_t& most, const ClipPoint& a, const ClipPoint& b) {
    const std::uint32_t leg = a.w > b.w ? static_cast<std::uint32_t>(a.w) - static_cast<std::uint32_t>(b.w)
                                        : static_cast<std::uint32_t>(b.w) - static_cast<std::uint32_t>(a.w);
    if (leg > most) most = leg;
  };
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 3; ++j) {
      raise(along, net.at[i][j + 1], net.at[i][j]);
      raise(across, net.at[j + 1][i], net.at[j][i]);
    }
  }
  return along >= across;
}

}  // namespace

PieceCutter::PieceCutter(const ClipPatch& patch, const Projection& projection, const PointWindow& window, bool mirrored)
    : patch_(patch),
      projection_(projection),
      window_(window),
      borders_{-1 - (projection.centre_x >> 4), window.width + 1 - (projection.centre_x >> 4),
               window.top - 1 - (projection.centre_y >> 4), window.bottom + 1 - (projection.centre_y >> 4)},
      mirrored_(mirrored),
      net_(patch) {}

bool PieceCutter::next(ScreenPiece& out) {
  while (!done_) {
    switch (look(out)) {
      case Verdict::nothing:
        advance();
        break;
      case Verdict::cut:
        descend();
        break;
      case Verdict::piece:
        out.u = u_;
        out.v = v_;
        out.side = side_of(out, mirrored_);
        turn_flat(out);
        advance();
        return true;
    }
  }
  return false;
}

PieceCutter::Verdict PieceCutter::look(ScreenPiece& out) {
  ++looks_;
  const Verdict rest = cuts_ == kMostCuts ? Verdict::nothing : Verdict::cut;
  const std::int32_t nearest = projection_.near_w > kNearest ? projection_.near_w : kNearest;
  std::int32_t low = INT32_MAX, high = INT32_MIN;
  for (const auto& row : net_.at) {
    for (const ClipPoint& p : row) {
      low = p.w < low ? p.w : low;
      high = p.w > high ? p.w : high;
    }
  }
  if (high < nearest) return Verdict::nothing;
  const auto cut_depth = [&] {
    cut_u_ = deeper_along_u(net_);
    return (cut_u_ ? u_ : v_).level >= kMostDepthCuts ? Verdict::nothing : rest;
  };
  if (low < nearest / 2 + 1) return aside() ? Verdict::nothing : cut_depth();
  const bool inside = project(out);
  const PieceExtent extent(out);
  if (!extent.meets(window_)) return Verdict::nothing;
  count_steps(out);
  if (inside && out.columns <= kPieceSteps && out.rows <= kPieceSteps) {
    if (high - low > low / 8) {
      if (!extent.is_speck()) return cut_depth();
      straighten(out.at[kPointDepth]);
      return Verdict::piece;
    }
    fit(out);
    count_steps(out);
    if (out.columns <= kMostPieceSteps && out.rows <= kMostPieceSteps) return Verdict::piece;
  }
  cut_u_ = out.columns >= out.rows;
  return rest;
}

// Whether all of the net lies beyond one of the planes through the eye and the window's borders; what of it lies before
// the eye is then out of sight.
bool PieceCutter::aside() const {
  bool beyond[4] = {true, true, true, true};
  for (const auto& row : net_.at) {
    for (const ClipPoint& p : row) {
      const std::int64_t x = std::int64_t{p.x} * kGuardPx, y = std::int64_t{p.y} * kGuardPx;
      beyond[0] = beyond[0] && x < std::int64_t{p.w} * borders_[0];
      beyond[1] = beyond[1] && x > std::int64_t{p.w} * borders_[1];
      beyond[2] = beyond[2] && y < std::int64_t{p.w} * borders_[2];
      beyond[3] = beyond[3] && y > std::int64_t{p.w} * borders_[3];
    }
  }
  return beyond[0] || beyond[1] || beyond[2] || beyond[3];
}

// The net on the screen. False where some point of it lies too far aside; then it is moved to that border, which lies
// off every screen.
bool PieceCutter::project(ScreenPiece& out) const {
  bool inside = true;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const ClipPoint& p = net_.at[i][j];
      const auto w = static_cast<std::uint32_t>(p.w);
      const int up = std::countl_zero(w) - 1;
      const std::uint32_t inverse = reciprocal_normalised(w << up);  // 2^(61 - up) / w
      const std::int32_t x = clamp(p.x, border(p.w)), y = clamp(p.y, border(p.w));
      inside = inside && x == p.x && y == p.y;
      // v / w * 2^28: v is within 1.5 w, and the near plane within 2 w.
      const auto over_w = [&](std::int32_t v) {
        return mul_high(up > 0 ? v * (1 << (up - 1)) : v >> 1, static_cast<std::int32_t>(inverse));
      };
      // v / w * kGuardPx px in Q13.19 is v / w * 2^29.
      static_assert(kGuardPx << kPointBits == 1 << 29);
      static_assert(2 * kBorderPx < 1 << (31 - kPointBits), "differences fit a word");
      out.at[kPointX][i][j] = over_w(x) * 2 + (projection_.centre_x << (kPointBits - 4));
      out.at[kPointY][i][j] = over_w(y) * 2 + (projection_.centre_y << (kPointBits - 4));
      out.at[kPointDepth][i][j] = over_w(projection_.near_w) >> (28 - 16 - kPointDepthBits);
    }
  }
  return inside;
}

// At a corner c, with the neighbours' weights relative to its own (1 + k) and r = (1 + k) * (p - c), the projected
// patch's derivatives there are those of a polynomial patch with c + r for the two neighbours along the sides and
// c + r11 - r10 * k01 - r01 * k10 for the inner one.
void PieceCutter::fit(ScreenPiece& piece) const {
  for (int corner = 0; corner < 4; ++corner) {
    const int i = (corner & 2) != 0 ? 3 : 0, j = (corner & 1) != 0 ? 3 : 0;
    const int next_i = i == 0 ? 1 : 2, next_j = j == 0 ? 1 : 2;
    const std::int32_t w = net_.at[i][j].w;
    const int up = std::countl_zero(static_cast<std::uint32_t>(w)) - 1;
    const auto inverse =
        static_cast<std::int32_t>(reciprocal_normalised(static_cast<std::uint32_t>(w) << up));  // 2^(61 - up) / w
    const auto excess = [&](const ClipPoint& p) {  // Q1.30; no more than an eighth, since high - low is checked
      return static_cast<std::int32_t>((std::int64_t{p.w - w} * inverse) >> (31 - up));
    };
    const auto times = [](std::int32_t a, std::int32_t k) {
      return static_cast<std::int32_t>(shift_round(std::int64_t{a} * k, 30));
    };
    const std::int32_t k10 = excess(net_.at[next_i][j]), k01 = excess(net_.at[i][next_j]),
                       k11 = excess(net_.at[next_i][next_j]);
    for (auto& at : piece.at) {
      const std::int32_t c = at[i][j];
      const std::int32_t d10 = at[next_i][j] - c, d01 = at[i][next_j] - c, d11 = at[next_i][next_j] - c;
      const std::int32_t r10 = d10 + times(d10, k10), r01 = d01 + times(d01, k01), r11 = d11 + times(d11, k11);
      at[next_i][j] = c + r10;
      at[i][next_j] = c + r01;
      at[next_i][next_j] = c + r11 - times(r10, k01) - times(r01, k10);
    }
  }
}

// To the first half.
void PieceCutter::descend() {
  const std::uint32_t bit = 1u << cuts_;
  along_u_ = cut_u_ ? along_u_ | bit : along_u_ & ~bit;
  second_ &= ~bit;
  halve_net(net_, cut_u_, kept_[cuts_ % kKept]);
  kept_of_[cuts_ % kKept] = static_cast<std::uint8_t>(cuts_);
  enter(cuts_++);
}

// To the second half of the last cut that has not been there yet.
void PieceCutter::advance() {
  while (cuts_ != 0 && (second_ >> (cuts_ - 1) & 1u) != 0) leave(--cuts_);
  done_ = cuts_ == 0;
  if (done_) return;
  const std::uint32_t cut = cuts_ - 1;
  leave(cut);
  second_ |= 1u << cut;
  enter(cut);
  std::uint8_t& kept = kept_of_[cut % kKept];
  if (kept == cut) {
    net_ = kept_[cut % kKept];
    kept = kNone;
  } else {
    cut_again();
  }
}

void PieceCutter::enter(std::uint32_t cut) {
  PieceRange& range = (along_u_ >> cut & 1u) != 0 ? u_ : v_;
  range = {2 * range.index + (second_ >> cut & 1u), range.level + 1};
}
void PieceCutter::leave(std::uint32_t cut) {
  PieceRange& range = (along_u_ >> cut & 1u) != 0 ? u_ : v_;
  range = {range.index / 2, range.level - 1};
}

void PieceCutter::cut_again() {
  net_ = patch_;
  ClipPatch& second = kept_[0];
  kept_of_[0] = kNone;
  for (std::uint32_t cut = 0; cut < cuts_; ++cut) {
    halve_net(net_, (along_u_ >> cut & 1u) != 0, second);
    if ((second_ >> cut & 1u) != 0) net_ = second;
  }
}

}  // namespace spanline
