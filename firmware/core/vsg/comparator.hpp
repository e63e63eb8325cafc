// The depth comparator: which of two segments is in front at both ends of a run of pixels. Two ways to the same answer,
// chosen at compile time: by plane, a multiply at each end (the seed's VSG4), or by midpoint halving (III.G, VSG5 and
// 6), which needs adders only once its registers are loaded.
#pragma once

#include <bit>
#include <cstdint>

#include "core/base/check.hpp"
#include "core/vsg/blocks.hpp"

namespace spanline {

enum class Comparator : std::uint8_t { plane, midpoint };

// Two depth ramps over the columns [from, to), to > from. Ties go to the first where `first_wins_ties` (the lower
// face).
struct Contest {
  DepthRamp first, second;
  std::int32_t from, to;
  bool first_wins_ties;

  std::int64_t lead(std::int32_t column) const {  // > 0: the first is nearer; true depths differ by less than 2^31
    return static_cast<std::int32_t>(first.at(column) - second.at(column));
  }
  bool first_ahead(std::int64_t lead) const { return lead > 0 || (lead == 0 && first_wins_ties); }
  // Both facets cover two pixels or more wherever this is used, so their slopes and the difference fit.
  std::int32_t slope() const { return static_cast<std::int32_t>(first.slope - second.slope); }
};

enum class Verdict : std::uint8_t {
  first,  // in front everywhere
  second,
  first_then_second,  // they intersect within the run
  second_then_first,
};

constexpr Verdict verdict(bool first_at_left, bool first_at_right) {
  if (first_at_left == first_at_right) return first_at_left ? Verdict::first : Verdict::second;
  return first_at_left ? Verdict::first_then_second : Verdict::second_then_first;
}

// Each comparator adds to `cycles` the add cycles that the seed's clipper would have taken, without the load.
template <Comparator kKind>
struct DepthComparator;

template <>
struct DepthComparator<Comparator::plane> {
  static Verdict compare(const Contest& contest, std::uint32_t& cycles) {
    ++cycles;
    return verdict(contest.first_ahead(contest.lead(contest.from)), contest.first_ahead(contest.lead(contest.to - 1)));
  }

  // The first column at which the other segment is in front; the contest's verdict was that they intersect.
  static std::int32_t crossing(const Contest& contest, std::uint32_t&) {
    std::int64_t lead = contest.lead(contest.from);
    std::int64_t loss = -std::int64_t{contest.slope()};
    const bool first = contest.first_ahead(lead);
    if (!first) {
      lead = -lead;
      loss = -loss;
    }
    // In front while lead - n * loss > 0, or >= 0 for the lower face.
    const bool wins_ties = first == contest.first_wins_ties;
    const auto steps = static_cast<std::uint32_t>(lead - (wins_ties ? 0 : 1)) / static_cast<std::uint32_t>(loss);
    return contest.from + static_cast<std::int32_t>(steps) + 1;
  }
};

template <>
struct DepthComparator<Comparator::midpoint> {
  static Verdict compare(const Contest& contest, std::uint32_t& cycles) {
    ++cycles;
    const std::int64_t left = contest.lead(contest.from);
    const bool first_at_left = contest.first_ahead(left);
    const std::int32_t target = contest.to - 1 - contest.from;
    if (target == 0) return verdict(first_at_left, first_at_left);
    Interval interval(contest, left, target);
    while (contest.first_ahead(interval.low_lead) != contest.first_ahead(interval.high_lead) &&
           interval.high != target) {
      ++cycles;
      interval.halve(interval.middle() >= target);
    }
    return verdict(first_at_left, contest.first_ahead(interval.high_lead));
  }

  static std::int32_t crossing(const Contest& contest, std::uint32_t& cycles) {
    const std::int64_t left = contest.lead(contest.from);
    const bool first_at_left = contest.first_ahead(left);
    Interval interval(contest, left, contest.to - 1 - contest.from);
    while (interval.high - interval.low > 1) {
      ++cycles;
      interval.halve(contest.first_ahead(interval.middle_lead()) != first_at_left);
    }
    return contest.from + interval.high;
  }

 private:
  // [low, high], 2^k columns long, with the leads at its ends. Every halving is exact: the lead grows by a whole slope
  // a column.
  struct Interval {
    std::int32_t low = 0, high;
    std::int64_t low_lead, high_lead;

    Interval(const Contest& contest, std::int64_t lead, std::int32_t reach)
        : high(static_cast<std::int32_t>(std::bit_ceil(static_cast<std::uint32_t>(reach)))),
          low_lead(lead),
          high_lead(lead + std::int64_t{contest.slope()} * high) {}

    std::int32_t middle() const { return (low + high) / 2; }
    std::int64_t middle_lead() const { return (low_lead + high_lead) / 2; }
    void halve(bool keep_low_end) {
      const std::int32_t m = middle();
      const std::int64_t lead = middle_lead();
      (keep_low_end ? high : low) = m;
      (keep_low_end ? high_lead : low_lead) = lead;
    }
  };
};

}  // namespace spanline
