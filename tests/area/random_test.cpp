// The clipper against its slow twin on seeded random pairs. SPANLINE_FULL=1 looks at all 50,000; a failure names its
// seed, and SPANLINE_SEED=N runs that seed alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "area/solved.hpp"
#include "oracle/area_random.hpp"

namespace spanline::area::test {
namespace {

constexpr std::uint64_t kAll = 50000, kSlice = 3000;

std::uint64_t pairs_to_look_at() { return std::getenv("SPANLINE_FULL") != nullptr ? kAll : oracle::rounds(kSlice); }

bool same(const Polygons& a, const Polygons& b) {
  const Polygons one = canonical(a), other = canonical(b);
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](const Polygon& p, const Polygon& q) { return p.main == q.main && p.holes == q.holes; });
}

class Trial {
 public:
  explicit Trial(std::uint64_t seed) : seed_(seed), pair_(oracle::random_area_pair(seed)) {}

  void run() {
    const Solved solved = solve(pair_.subject, pair_.clip);
    ASSERT_TRUE(solved.status.ok()) << solved.status.where;
    ASSERT_EQ(flaw(solved.inside, solved.outside), "");
    ASSERT_EQ(solved.broken_link, "");
    areas(solved);
    points(solved);
    again(solved.inside);
    again(solved.outside);
    shuffle(solved);
    others(solved);
  }

 private:
  using Masks = bool (*)(unsigned);

  // How much of the plane `list` covers wrongly or not at all.
  long double difference(const Polygons& list, Masks wanted) const {
    const std::vector<AreaRegion> regions = {pair_.subject, pair_.clip, rings_of(list)};
    return oracle::measure(regions, [&](unsigned mask) { return wanted(mask & 3) != ((mask & 4) != 0); });
  }

  void areas(const Solved& solved) {
    const long double inside = difference(solved.inside, [](unsigned mask) { return mask == 3; });
    const long double outside = difference(solved.outside, [](unsigned mask) { return mask == 1; });
    const std::int64_t sum = twice_area(solved.inside) + twice_area(solved.outside);
    const long double subject = oracle::measure({pair_.subject}, [](unsigned mask) { return mask == 1; });
    const long double around = oracle::perimeter(pair_.subject) + oracle::perimeter(pair_.clip);
    if (solved.counts.moved == 0) {
      ASSERT_EQ(sum, std::llround(2 * subject));
      ASSERT_LT(inside + outside, 1e-6L);
    } else {
      ASSERT_LE(inside, around / 2);
      ASSERT_LE(outside, around / 2);
      ASSERT_LE(std::abs(static_cast<long double>(sum) / 2 - subject), oracle::perimeter(pair_.subject) / 2);
    }
  }

  // Half-unit points, off all borders; farther than any border can move where some have.
  void points(const Solved& solved) {
    oracle::Random random(seed_ ^ 0x5eed);
    const AreaRegion inside = rings_of(solved.inside), outside = rings_of(solved.outside);
    for (int i = 0; i < 40; ++i) {
      const AreaRing& around = pair_.subject.empty() ? pair_.clip[0] : pair_.subject[0];
      const AreaPoint near = around[static_cast<std::size_t>(random.below(static_cast<int>(around.size())))];
      const int reach = 1 << random.between(1, 12);
      const AreaPoint at{2 * near.x + random.between(-reach, reach), 2 * near.y + random.between(-reach, reach)};
      if (solved.counts.moved != 0 && near_border(at)) continue;
      bool on[4];
      const bool in_subject = oracle::covers(pair_.subject, at, on[0]), in_clip = oracle::covers(pair_.clip, at, on[1]);
      const bool in_inside = oracle::covers(inside, at, on[2]), in_outside = oracle::covers(outside, at, on[3]);
      if (on[0] || on[1] || on[2] || on[3]) continue;
      ASSERT_EQ(in_inside, in_subject && in_clip) << at.x << " " << at.y;
      ASSERT_EQ(in_outside, in_subject && !in_clip) << at.x << " " << at.y;
    }
  }

  bool near_border(AreaPoint at) const {
    for (const AreaRegion* region : {&pair_.subject, &pair_.clip}) {
      for (const AreaRing& ring : *region) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
          if (distance(at, ring[k], ring[(k + 1) % ring.size()]) < 0.75) return true;
        }
      }
    }
    return false;
  }

  // In whole units, of a point in half units.
  static double distance(AreaPoint at, AreaPoint a, AreaPoint b) {
    const double x = static_cast<double>(at.x) / 2 - static_cast<double>(a.x);
    const double y = static_cast<double>(at.y) / 2 - static_cast<double>(a.y);
    const double dx = static_cast<double>(b.x - a.x), dy = static_cast<double>(b.y - a.y);
    const double length = dx * dx + dy * dy;
    const double t = length == 0 ? 0 : std::clamp((x * dx + y * dy) / length, 0.0, 1.0);
    return std::hypot(x - t * dx, y - t * dy);
  }

  void again(const Polygons& list) const {
    const Solved solved = solve(rings_of(list), {}, Operation::unite);
    ASSERT_EQ(solved.counts.moved, 0);
    ASSERT_TRUE(same(solved.inside, list));
  }

  static AreaRegion shuffled(AreaRegion region) {
    std::reverse(region.begin(), region.end());
    for (AreaRing& ring : region) {
      std::reverse(ring.begin(), ring.end());
      std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(ring.size() / 2), ring.end());
    }
    return region;
  }

  void shuffle(const Solved& solved) const {
    const Solved other = solve(shuffled(pair_.subject), shuffled(pair_.clip));
    ASSERT_EQ(rings_of(other.inside), rings_of(solved.inside));
    ASSERT_EQ(rings_of(other.outside), rings_of(solved.outside));
  }

  void others(const Solved& clipped) const {
    const Solved both = solve(pair_.subject, pair_.clip, Operation::unite);
    const Solved apart = solve(pair_.subject, pair_.clip, Operation::differ);
    ASSERT_EQ(flaw(both.inside, both.outside), "");
    ASSERT_EQ(flaw(apart.inside, apart.outside), "");
    ASSERT_TRUE(both.outside.empty());
    ASSERT_TRUE(same(apart.inside, clipped.outside));
    ASSERT_EQ(twice_area(both.inside),
              twice_area(clipped.inside) + twice_area(apart.inside) + twice_area(apart.outside));
  }

  std::uint64_t seed_;
  oracle::AreaPair pair_;
};

TEST(RandomAreas, AgreeWithTheTwin) {
  const char* only = std::getenv("SPANLINE_SEED");
  const std::uint64_t first = only != nullptr ? std::strtoull(only, nullptr, 10) : 0;
  const std::uint64_t end = only != nullptr ? first + 1 : pairs_to_look_at();
  for (std::uint64_t seed = first; seed < end; ++seed) {
    Trial(seed).run();
    if (HasFatalFailure()) FAIL() << "seed " << seed;
  }
}

}  // namespace
}  // namespace spanline::area::test
