#include "frames/minimax.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace spanline::bench {
namespace {

using Row = std::vector<double>;

// Gauss and Jordan, pivots chosen; each row's last number is its right side. Empty where rows depend on each other.
std::optional<Row> solved(std::vector<Row> rows) {
  const std::size_t n = rows.size();
  constexpr double kNone = 1e-12;
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t pivot = i;
    for (std::size_t r = i + 1; r < n; ++r) {
      if (std::abs(rows[r][i]) > std::abs(rows[pivot][i])) pivot = r;
    }
    if (std::abs(rows[pivot][i]) < kNone) return std::nullopt;
    std::swap(rows[i], rows[pivot]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == i) continue;
      const double factor = rows[r][i] / rows[i][i];
      for (std::size_t k = i; k <= n; ++k) rows[r][k] -= factor * rows[i][k];
    }
  }
  Row x(n);
  for (std::size_t i = 0; i < n; ++i) x[i] = rows[i][n] / rows[i][i];
  return x;
}

// What may hold with equality at the best fit, in the unknowns (shares of the terms, off): a row is too high by `off`,
// or too low by it, or a term is free. Terms are counted in their largest part, so that pivots compare.
std::vector<Row> borders_of(const std::vector<Measured>& measured, const Row& scale) {
  std::vector<Row> borders;
  const std::size_t terms = scale.size();
  for (const Measured& row : measured) {
    Row border(terms + 2);
    for (std::size_t k = 0; k < terms; ++k) border[k] = row.terms[k] / row.sum / scale[k];
    border[terms + 1] = 1;
    for (const double side : {-1.0, 1.0}) {
      border[terms] = side;
      borders.push_back(border);
    }
  }
  for (std::size_t k = 0; k < terms; ++k) {
    Row border(terms + 2);
    border[k] = 1;
    borders.push_back(border);
  }
  return borders;
}

double largest_error(const std::vector<Measured>& measured, const Row& prices) {
  double off = 0;
  for (const Measured& row : measured) {
    double sum = 0;
    for (std::size_t k = 0; k < prices.size(); ++k) sum += row.terms[k] * prices[k];
    off = std::max(off, std::abs(sum / row.sum - 1));
  }
  return off;
}

}  // namespace

Fit minimax_fit(const std::vector<Measured>& measured) {
  const std::size_t terms = measured.front().terms.size();
  Row scale(terms, std::numeric_limits<double>::min());
  for (const Measured& row : measured) {
    for (std::size_t k = 0; k < terms; ++k) scale[k] = std::max(scale[k], row.terms[k] / row.sum);
  }
  const std::vector<Row> borders = borders_of(measured, scale);
  Fit best{Row(terms), 1};  // nothing has a price: all of it is missing
  std::vector<bool> taken(borders.size());
  std::fill(taken.begin(), taken.begin() + static_cast<std::ptrdiff_t>(terms) + 1, true);
  do {
    std::vector<Row> equal;
    for (std::size_t i = 0; i < borders.size(); ++i) {
      if (taken[i]) equal.push_back(borders[i]);
    }
    const std::optional<Row> vertex = solved(equal);
    if (!vertex) continue;
    Row prices(terms);
    for (std::size_t k = 0; k < terms; ++k) prices[k] = (*vertex)[k] / scale[k];
    constexpr double kRounding = -1e-9;
    if (std::any_of(prices.begin(), prices.end(), [](double price) { return price < kRounding; })) continue;
    for (double& price : prices) price = std::max(price, 0.0);
    const double off = largest_error(measured, prices);
    if (off < best.off) best = {prices, off};
  } while (std::prev_permutation(taken.begin(), taken.end()));
  return best;
}

}  // namespace spanline::bench
