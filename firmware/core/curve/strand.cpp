#include "core/curve/strand.hpp"

#include <utility>

#include "core/base/check.hpp"
#include "core/fx/root.hpp"
#include "core/geom/screen.hpp"

namespace spanline {
namespace {

constexpr std::int32_t kOne = StrandSteps::kWhole;

// One coordinate at t = m / kOne, cut off: Bernstein's weights are positive and add up to kOne^3, 2^45.
std::int32_t coordinate_at(const Cubic& curve, std::int32_t CurvePoint::*c, std::int64_t m) {
  const std::int64_t n = kOne - m;
  const std::int64_t sum =
      n * n * n * curve.p[0].*c + 3 * n * m * (n * curve.p[1].*c + m * curve.p[2].*c) + m * m * m * curve.p[3].*c;
  return static_cast<std::int32_t>(sum >> (3 * kStrandLevels));
}
static_assert(3 * kStrandLevels + 18 <= 63);

CurvePoint point_at(const Cubic& curve, std::int32_t m) {
  return {coordinate_at(curve, &CurvePoint::x, m), coordinate_at(curve, &CurvePoint::y, m)};
}

bool near(CurvePoint a, CurvePoint b, std::int32_t most) {
  return b.x - a.x <= most && a.x - b.x <= most && b.y - a.y <= most && a.y - b.y <= most;
}

// kOne * numerator / denominator where that lies strictly between 0 and kOne, else 0.
std::int32_t inner_fraction(std::int64_t numerator, std::int64_t denominator) {
  if (denominator < 0) {
    numerator = -numerator;
    denominator = -denominator;
  }
  if (numerator <= 0 || numerator >= denominator) return 0;
  return static_cast<std::int32_t>(numerator * kOne / denominator);
}

// Where y turns: the roots of y' / 3 = c + 2 b t + a t t. With q = -(b + sign(b) sqrt(b b - a c)) they are q / a and
// c / q, without cancellation (Press et al., Numerical Recipes, 5.6).
struct Turns {
  std::int32_t first = 0, second = 0;  // 0: none
};
Turns turns_of(const Cubic& curve) {
  const std::int64_t d0 = curve.p[1].y - curve.p[0].y, d1 = curve.p[2].y - curve.p[1].y,
                     d2 = curve.p[3].y - curve.p[2].y;
  const std::int64_t a = d0 - 2 * d1 + d2, b = d1 - d0, c = d0;
  const std::int64_t square = b * b - a * c;
  if (square < 0) return {};
  constexpr int kFraction = 10;  // bits of the root
  const auto root = static_cast<std::int64_t>(square_root(static_cast<std::uint64_t>(square) << (2 * kFraction)));
  const std::int64_t q = -(b * (1 << kFraction) + (b < 0 ? -root : root));
  Turns turns{inner_fraction(q, a * (1 << kFraction)), inner_fraction(c * (1 << kFraction), q)};
  if (turns.second < turns.first) std::swap(turns.first, turns.second);
  return turns;
}

}  // namespace

Strands::Strands(const Cubic& curve) : curve_(curve) {
  const Turns turns = turns_of(curve);
  ends_[0] = 0;
  for (const std::int32_t turn : {turns.first, turns.second}) {
    if (turn > ends_[count_ - 1]) ends_[count_++] = static_cast<std::uint16_t>(turn);
  }
  ends_[count_] = kOne;
}

Strand Strands::operator[](unsigned index) const {
  CHECK(index < count_);
  Strand strand{curve_, ends_[index], ends_[index + 1]};
  if (coordinate_at(curve_, &CurvePoint::y, strand.to) >= coordinate_at(curve_, &CurvePoint::y, strand.from)) {
    return strand;
  }
  // Run backwards: the curve's points are the same integers seen from either end.
  std::swap(strand.curve.p[0], strand.curve.p[3]);
  std::swap(strand.curve.p[1], strand.curve.p[2]);
  const auto from = static_cast<std::uint16_t>(kOne - strand.to);
  strand.to = static_cast<std::uint16_t>(kOne - strand.from);
  strand.from = from;
  return strand;
}

StrandWalk::StrandWalk(const Strand& strand, int fineness)
    : steps_(strand.curve.p),
      end_(point_at(strand.curve, strand.to)),
      rest_(static_cast<std::uint16_t>(strand.to - strand.from)),
      fineness_(static_cast<std::uint8_t>(fineness)) {
  for (int rest = strand.from; rest != 0;) {
    if (steps_.length() > rest) {
      steps_.halve();
    } else {
      steps_.step();
      rest -= steps_.length();
    }
  }
  steps_.settle(strand.curve.p, StrandSteps::kPixel >> fineness);
}

// The last step, which need not be a power of two, goes to the end itself. Where the curve turns within it, the end may
// be further off than a whole step would be: then shorter ones go there.
void StrandWalk::next() {
  CHECK(rest_ != 0);
  const std::int32_t most = kSubpixels >> fineness_;
  while (steps_.length() > rest_ && !near(steps_.at(), end_, most)) steps_.halve();
  steps_.fit(StrandSteps::kPixel >> fineness_, [this](int doubled) { return doubled <= rest_; });
  if (steps_.length() >= rest_) {
    rest_ = 0;
    return;
  }
  steps_.step();
  rest_ = static_cast<std::uint16_t>(rest_ - steps_.length());
}

}  // namespace spanline
