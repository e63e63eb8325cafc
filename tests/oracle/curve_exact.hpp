// Points of Bezier curves and patches as exact fractions, by Bernstein's polynomials in integers.
#pragma once

#include <cstdint>

namespace spanline::oracle {

// n^3 * B(m / n) of the curve with control points p. Exact where n^3 * max |p| stays below 2^63: the weights are
// positive and add up to n^3.
inline std::int64_t exact_cubic(const std::int64_t (&p)[4], std::int64_t m, std::int64_t n) {
  const std::int64_t s = n - m;
  return s * s * s * p[0] + 3 * s * s * m * p[1] + 3 * s * m * m * p[2] + m * m * m * p[3];
}

// nu^3 * nv^3 * B(mu / nu, mv / nv); p[i][j], i along u.
inline std::int64_t exact_bicubic(const std::int64_t (&p)[4][4], std::int64_t mu, std::int64_t nu, std::int64_t mv,
                                  std::int64_t nv) {
  const std::int64_t rows[4] = {exact_cubic(p[0], mv, nv), exact_cubic(p[1], mv, nv), exact_cubic(p[2], mv, nv),
                                exact_cubic(p[3], mv, nv)};
  return exact_cubic(rows, mu, nu);
}

}  // namespace spanline::oracle
