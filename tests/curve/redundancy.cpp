// What ways of drawing curves pay for a pixel: `spanline-redundancy docs/redundancy.md` writes the page.
#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "core/curve/point_rows.hpp"
#include "core/curve/strand.hpp"
#include "core/curve/walk.hpp"
#include "curve/curves.hpp"
#include "curve/newton_lines.hpp"
#include "curve/patch_scene.hpp"
#include "curve/screen_net.hpp"

namespace spanline::test {
namespace {

constexpr int kCurves = 10'000, kViews = 20;

// Points computed, and the pixels that they lie in.
struct Plot {
  std::uint64_t points = 0;
  std::set<std::pair<int, int>> pixels;

  void add(double x, double y) {
    ++points;
    pixels.insert({static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y))});
  }
  double redundancy() const { return static_cast<double>(points) / static_cast<double>(pixels.size()); }
};

void walk_strands(const Cubic& curve, Plot& plot) {
  const Strands strands(curve);
  for (unsigned i = 0; i < strands.count(); ++i) {
    StrandWalk walk(strands[i], 0);
    for (;; walk.next()) {
      plot.add(walk.at().x / 16.0, walk.at().y / 16.0);
      if (walk.done()) break;
    }
  }
}

void walk_halves(const Cubic& curve, Plot& plot) {
  CurveWalk walk(curve);
  for (CurvePixel pixel; walk.next(pixel);) plot.add(pixel.x, pixel.y);
  plot.points = walk.points();
}

// Steps of 2^-k with 2^k >= 3 max |leg|: the coarsest power of two that surely skips no pixel.
void step_fixed(const Cubic& curve, Plot& plot) {
  double leg = 0;
  for (int i = 0; i < 3; ++i) {
    leg = std::max(
        {leg, std::abs(curve.p[i + 1].x - curve.p[i].x) / 16.0, std::abs(curve.p[i + 1].y - curve.p[i].y) / 16.0});
  }
  int steps = 1;
  while (steps < 3 * leg) steps *= 2;
  for (int i = 0; i <= steps; ++i) {
    const At at = exact_at(curve, static_cast<double>(i) / steps);
    plot.add(at.x, at.y);
  }
}

double mean_over_curves(const std::function<void(const Cubic&, Plot&)>& draw) {
  oracle::Random random(1);
  double sum = 0;
  for (int i = 0; i < kCurves; ++i) {
    Plot plot;
    draw(random_cubic(random), plot);
    sum += plot.redundancy();
  }
  return sum / kCurves;
}

Newton newton_over_curves() {
  oracle::Random random(1);
  Newton newton;
  for (int i = 0; i < kCurves; ++i) {
    newton.curve(random_cubic(random));
  }
  return newton;
}

// The longest leg of the net along i and along j.
std::pair<double, double> longest_legs(const ScreenNet& screen) {
  const auto& net = screen.control;
  double along_i = 0, along_j = 0;
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < 3; ++b) {
      along_i = std::max(along_i, std::hypot(net[b + 1][a].x - net[b][a].x, net[b + 1][a].y - net[b][a].y));
      along_j = std::max(along_j, std::hypot(net[a][b + 1].x - net[a][b].x, net[a][b + 1].y - net[a][b].y));
    }
  }
  return {along_i, along_j};
}

// Means over views.
struct Cost {
  double of_patch;    // points over the pixels that each patch's own points lie in, summed over the patches
  double of_picture;  // over the pixels of the picture that any lies in
};

// `plot` puts a patch's points into a Plot.
Cost teapot(const std::function<void(const PatchView&, const PatchPoints&, Plot&)>& plot) {
  const std::vector<PatchPoints> patches = teapot_patches();
  Cost sum{0, 0};
  for (std::uint64_t seed = 1; seed <= kViews; ++seed) {
    const PatchView view = random_view(seed, 1, 8);
    std::uint64_t points = 0, pixels = 0;
    std::set<std::pair<int, int>> picture;
    for (const PatchPoints& patch : patches) {
      Plot own;
      plot(view, patch, own);
      points += own.points;
      pixels += own.pixels.size();
      picture.insert(own.pixels.begin(), own.pixels.end());
    }
    sum.of_patch += static_cast<double>(points) / static_cast<double>(pixels) / kViews;
    sum.of_picture += static_cast<double>(points) / static_cast<double>(picture.size()) / kViews;
  }
  return sum;
}

// Each patch a grid with `steps(3 * leg)` steps a direction.
Cost teapot_in_grids(const std::function<int(double)>& steps) {
  return teapot([&](const PatchView& view, const PatchPoints& patch, Plot& plot) {
    const ScreenNet net(view, patch);
    const auto [i, j] = longest_legs(net);
    const int nu = steps(3 * i), nv = steps(3 * j);
    for (int a = 0; a <= nu; ++a) {
      for (int b = 0; b <= nv; ++b) {
        const At at = net.at(static_cast<double>(b) / nv, static_cast<double>(a) / nu);
        plot.add(at.x, at.y);
      }
    }
  });
}

// Each patch in pieces, with `steps(n)` steps where n are enough.
Cost teapot_in_pieces(const std::function<std::uint32_t(std::uint32_t)>& steps) {
  return teapot([&](const PatchView& view, const PatchPoints& points, Plot& plot) {
    const ClipPatch patch = view.patch(points);
    PieceCutter cutter(patch, view.projection, {0, 240, 320}, false);
    for (ScreenPiece piece; cutter.next(piece);) {
      piece.rows = steps(piece.rows);
      piece.columns = steps(piece.columns);
      PointRows rows(piece);
      std::vector<PointPixel> row(piece.columns + 1);
      for (std::uint32_t i = 0; i <= piece.rows; ++i, rows.step()) {
        rows.step_off(row.data());
        for (const PointPixel& p : row) plot.add(p.x, p.y);
      }
    }
  });
}

// Whitted's scan lines: the sides of the patches are met by Newton's iteration, what is between them is interpolated.
Cost teapot_by_whitted(Newton& newton) {
  return teapot([&](const PatchView& view, const PatchPoints& patch, Plot& plot) {
    const ScreenNet net(view, patch);
    const std::uint64_t before = newton.iterations;
    for (const Cubic& side : net.sides()) newton.curve(side);
    plot.points += newton.iterations - before;
    for (const auto& sheet : net.sheets()) {
      for (const auto& [pixel, root] : sheet) plot.pixels.insert({pixel.second, pixel.first});
    }
  });
}

// Blinn's: each pixel's place on the patch is met, too, from that of the pixel to the left.
Cost teapot_by_blinn(Newton& newton) {
  return teapot([&](const PatchView& view, const PatchPoints& patch, Plot& plot) {
    const ScreenNet net(view, patch);
    const std::uint64_t before = newton.iterations;
    for (const auto& sheet : net.sheets()) {
      newton.sheet(net, sheet);
      for (const auto& [pixel, root] : sheet) plot.pixels.insert({pixel.second, pixel.first});
    }
    plot.points += newton.iterations - before;
  });
}

int power_of_two(double least) {
  int steps = 1;
  while (steps < least) steps *= 2;
  return steps;
}

int whole(double least) { return std::max(1, static_cast<int>(std::ceil(least))); }
std::uint32_t same(std::uint32_t n) { return n; }

std::string row(const std::string& way, const Cost& cost) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(2) << "| " << way << " | " << cost.of_patch << " | " << cost.of_picture
      << " |\n";
  return out.str();
}

std::string page() {
  const Newton newton = newton_over_curves();
  Newton whitted, blinn;
  const auto share = [](std::uint64_t part, std::uint64_t all) {
    return static_cast<double>(part) / static_cast<double>(all);
  };
  std::ostringstream out;
  out << std::fixed << std::setprecision(3);
  out << "# Redundancy: points computed for a pixel\n\n"
         "Points computed over distinct pixels, at 320 x 240. Written by `build/host/spanline-redundancy "
         "docs/redundancy.md`.\n\n## Curves\n\nThe mean over 10,000 cubic Bezier curves with random control points on "
         "the "
         "screen. Steps of powers of two cannot do\nbetter than 1 / ln 2 = 1.44 points a pixel *in the longer "
         "direction* "
         "where a curve runs along an axis; diagonal ones\nget by with fewer.\n\n"
         "| way | redundancy |\n|---|--:|\n"
      << "| adaptive steps of y-monotone strands, 64-bit registers (what scenes are drawn with) | "
      << mean_over_curves(walk_strands) << " |\n"
      << "| Klassen's hybrid: cut into halves first, then adaptive steps in 32 bits | " << mean_over_curves(walk_halves)
      << " |\n| fixed steps, the coarsest power of two that skips no pixel | " << mean_over_curves(step_fixed)
      << " |\n\n"
      << "Scan lines by Newton's iteration (Whitted 1978; Blinn 1978), begun at the root of the line above:\n"
      << std::setprecision(2) << share(newton.iterations, newton.crossings)
      << " iterations a crossing, each with a division; " << 100 * share(newton.failures, newton.crossings)
      << " % of the crossings are not\nfound within ten, or found on another piece of the curve.\n\n"
      << "## The teapot\n\nAll 32 patches, the mean over " << kViews
      << " random views that it fills, hidden points counted: over the pixels that a patch's own points\nlie in, "
         "summed "
         "over the patches; and over the pixels of the picture, in which on the average more than two sheets lie\n"
         "over one another.\n\n| way | redundancy | over the picture's pixels |\n|---|--:|--:|\n"
      << row("**points** (`--surface points`): pieces of 16 pixels at most, any number of steps",
             teapot_in_pieces(same))
      << row("Klassen's hybrid on a surface: the same pieces, steps of powers of two",
             teapot_in_pieces([](std::uint32_t n) { return std::min(std::bit_ceil(n), kMostPieceSteps); }))
      << row("fixed steps, as many as skip no pixel", teapot_in_grids(whole))
      << row("fixed steps, the coarsest powers of two that skip no pixel", teapot_in_grids(power_of_two))
      << row("micropolygons: a grid of quadrangles of half a pixel at most (Cook, Carpenter, Catmull 1987)",
             teapot_in_grids([](double length) { return whole(2 * length); }))
      << row("Whitted's scan lines: crossings with the patches' sides by Newton's iteration, what is between them "
             "interpolated",
             teapot_by_whitted(whitted))
      << row("Blinn's scan lines: each pixel's place on the patch by Newton's iteration", teapot_by_blinn(blinn))
      << "\nFor scan lines a point is an iteration: the patch, or the side, and its derivatives there, and a "
         "division. Whitted's meets\n"
      << whitted.crossings / kViews << " crossings with sides a view, of which "
      << 100 * share(whitted.failures, whitted.crossings)
      << " % fail; what a patch is between its sides it does not see, outlines first of all,\nunless more curves are "
         "put there. Blinn's meets "
      << blinn.crossings / kViews << " pixels of sheets a view, each begun at its left neighbour's place, in\n"
      << share(blinn.iterations, blinn.crossings) << " iterations; " << 100 * share(blinn.failures, blinn.crossings)
      << " % fail: ten do not do, or they lead off the patch or to its other sheet, most of them near outlines,\nwhere "
         "the derivatives become dependent. Both are given where curves and spans begin.\n"
      << "\nThe first leaves no hole by proof (`core/curve/point_piece.hpp`); that it leaves none is "
         "also "
         "tested, in 1,000\nviews of each of two sizes. What is above one point a pixel goes where it does for any "
         "grid: "
         "a sheet seen at an angle has\nits isocurves closer together than their points need be, pieces share their "
         "rims' "
         "points, steps are whole numbers, and within\na piece the longest leg decides.\n\n"
      << "3D pixels (a point, its depth and colour kept until the picture is whole) need a place to be kept: 320 x 240 "
         "x "
         "(2 + 2) bytes =\n307,200 bytes for RGB565 and 16 bits of depth, against 24 KB for the diced teapot, "
         "everything "
         "counted.\n";
  return out.str();
}

}  // namespace
}  // namespace spanline::test

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: spanline-redundancy PAGE.md\n";
    return 2;
  }
  std::ofstream file(arguments[1]);
  file << spanline::test::page();
  return file.flush() ? 0 : 1;
}
