// Other people's hardest cases, where they are at hand: SPANLINE_CLIP_PAIRS names a file with a JSON object a line, of
// `id`, `subject`, `clip` (rings of [x, y]) and the exact `inside_area` and `outside_area` as fractions.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "area/solved.hpp"

namespace spanline::area::test {
namespace {

using nlohmann::json;

struct Pair {
  std::string id;
  AreaRegion subject, clip;
  long double inside, outside;
};

AreaRegion region_of(const json& rings) {
  AreaRegion region;
  for (const json& ring : rings) {
    AreaRing& points = region.emplace_back();
    for (const json& p : ring) points.push_back({p[0], p[1]});
  }
  return region;
}

long double value_of(const std::string& fraction) {
  const std::size_t slash = fraction.find('/');
  const long double number = std::stold(fraction);
  return slash == std::string::npos ? number : number / std::stold(fraction.substr(slash + 1));
}

std::optional<std::vector<Pair>> pairs() {
  const char* path = std::getenv("SPANLINE_CLIP_PAIRS");
  std::ifstream file(path != nullptr ? path : SPANLINE_DATA "/clip-pairs.jsonl");
  if (!file) return std::nullopt;
  std::vector<Pair> all;
  for (std::string line; std::getline(file, line);) {
    const json pair = json::parse(line);
    all.push_back({pair["id"], region_of(pair["subject"]), region_of(pair["clip"]), value_of(pair["inside_area"]),
                   value_of(pair["outside_area"])});
  }
  return all;
}

long double difference(const Pair& pair, const Polygons& list, unsigned wanted) {
  return oracle::measure({pair.subject, pair.clip, rings_of(list)},
                         [&](unsigned mask) { return ((mask & 3) == wanted) != ((mask & 4) != 0); });
}

void judge(const Pair& pair) {
  const Solved solved = solve(pair.subject, pair.clip);
  ASSERT_TRUE(solved.status.ok()) << solved.status.where;
  EXPECT_EQ(flaw(solved.inside, solved.outside), "");
  EXPECT_EQ(solved.broken_link, "");
  const long double bound = (oracle::perimeter(pair.subject) + oracle::perimeter(pair.clip)) / 2;
  EXPECT_LE(difference(pair, solved.inside, 3), bound);
  EXPECT_LE(difference(pair, solved.outside, 1), bound);
  const long double inside = static_cast<long double>(twice_area(solved.inside)) / 2;
  const long double outside = static_cast<long double>(twice_area(solved.outside)) / 2;
  const long double allowed = solved.counts.moved == 0 ? 1e-9L * (1 + pair.inside + pair.outside) : bound;
  EXPECT_LE(std::abs(inside - pair.inside), allowed);
  EXPECT_LE(std::abs(outside - pair.outside), allowed);
}

// The pair moved by a map of the grid onto itself that keeps areas.
template <typename Map>
void judge_moved(Pair pair, Map map) {
  for (AreaRegion* region : {&pair.subject, &pair.clip}) {
    for (AreaRing& ring : *region) {
      for (AreaPoint& p : ring) p = map(p);
    }
  }
  judge(pair);
}

class Pairs : public testing::Test {
 protected:
  template <typename Map>
  void judge_all(Map map) {
    const auto all = pairs();
    if (!all) GTEST_SKIP() << "no clip-pairs.jsonl";
    for (const Pair& pair : *all) {
      SCOPED_TRACE(pair.id);
      judge_moved(pair, map);
    }
  }
};

TEST_F(Pairs, AsTheyAre) {
  judge_all([](AreaPoint p) { return p; });
}
TEST_F(Pairs, Mirrored) {
  judge_all([](AreaPoint p) { return AreaPoint{-p.x, p.y}; });
}
TEST_F(Pairs, UpsideDown) {
  judge_all([](AreaPoint p) { return AreaPoint{p.x, -p.y}; });
}
TEST_F(Pairs, Turned) {
  judge_all([](AreaPoint p) { return AreaPoint{-p.y, p.x}; });
}
TEST_F(Pairs, Transposed) {
  judge_all([](AreaPoint p) { return AreaPoint{p.y, p.x}; });
}
TEST_F(Pairs, Shifted) {
  judge_all([](AreaPoint p) { return AreaPoint{p.x - 16001, p.y + 7919}; });
}

}  // namespace
}  // namespace spanline::area::test
