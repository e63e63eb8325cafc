// Coefficients that are nowhere far off, for a handful of measured sums.
#pragma once

#include <cstddef>
#include <vector>

namespace spanline::bench {

// A sum that was measured, and how much of each term was in it.
struct Measured {
  std::vector<double> terms;
  double sum;  // > 0
};

struct Fit {
  std::vector<double> prices;  // of each term, none below 0
  double off;                  // the largest relative error, |terms . prices / sum - 1|
};

// The fit whose largest relative error is the least (Chebyshev's), found by trying each vertex of the linear program:
// as many rows and zeros hold with equality as there are unknowns. For few terms and rows, of which there is one at
// least, all of as many terms; the work grows as their binomial coefficient.
Fit minimax_fit(const std::vector<Measured>& measured);

}  // namespace spanline::bench
