#include "curve/newton_lines.hpp"

#include <cmath>

#include "core/curve/strand.hpp"

namespace spanline::test {
namespace {

// Where y meets the line, found surely: what the next line begins at after a failure.
double by_halving(const Cubic& curve, double low, double high, double line) {
  for (int i = 0; i < 40; ++i) (exact_at(curve, (low + high) / 2).y < line ? low : high) = (low + high) / 2;
  return low;
}

}  // namespace

void Newton::curve(const Cubic& curve) {
  const Strands strands(curve);
  for (unsigned i = 0; i < strands.count(); ++i) {
    const Strand part = strands[i];
    strand(part.curve, part.from / 32768.0, part.to / 32768.0);
  }
}

void Newton::strand(const Cubic& curve, double from, double to) {
  const auto y = [&](double t) { return exact_at(curve, t).y; };
  double t = from + (to - from) / 64;  // at the end itself the slope may be zero
  for (double line = std::ceil(y(from) - 0.5) + 0.5; line < y(to); ++line) {
    ++crossings;
    double at = t;
    bool found = false;
    for (int i = 0; i < kMost && !found; ++i, ++iterations) {
      const double slope = (y(at + 1e-6) - y(at - 1e-6)) / 2e-6;
      const double off = y(at) - line;
      found = std::abs(off) < kNear;
      if (!found) at -= off / (std::abs(slope) < 1e-9 ? 1e-9 : slope);
    }
    const bool failed = !found || at < from - 1e-3 || at > to + 1e-3;
    if (failed) ++failures;
    t = failed ? by_halving(curve, from, to, line) : at;
  }
}

// Leads `root` to the pixel's centre. False where it ends nowhere.
bool Newton::place(const ScreenNet& net, At centre, ScreenNet::Root& root) {
  for (int i = 0; i < kMost; ++i) {
    ++iterations;
    const At at = net.at(root.u, root.v);
    const At off{centre.x - at.x, centre.y - at.y};
    if (std::hypot(off.x, off.y) < kNear) return true;
    const ScreenNet::Derivatives d = net.derivatives(root.u, root.v);
    if (std::abs(d.turn()) < 1e-9) return false;
    root.u += (off.x * d.along_v.y - off.y * d.along_v.x) / d.turn();
    root.v += (d.along_u.x * off.y - d.along_u.y * off.x) / d.turn();
  }
  return false;
}

void Newton::sheet(const ScreenNet& net, const ScreenNet::Sheet& sheet) {
  std::pair<int, int> next{-1, -1};
  ScreenNet::Root root{};
  for (const auto& [pixel, known] : sheet) {
    ++crossings;
    if (pixel != next) root = known;
    const auto on_patch = [](double t) { return t >= -1e-3 && t <= 1 + 1e-3; };
    const bool right = net.derivatives(known.u, known.v).turn() > 0;
    const bool found = place(net, {pixel.second + 0.5, pixel.first + 0.5}, root) && on_patch(root.u) &&
                       on_patch(root.v) && (net.derivatives(root.u, root.v).turn() > 0) == right;
    if (!found) {
      ++failures;
      root = known;
    }
    next = {pixel.first, pixel.second + 1};
  }
}

}  // namespace spanline::test
