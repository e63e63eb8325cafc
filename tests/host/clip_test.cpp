// `spanline clip` as a user types it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "assetc/text_file.hpp"
#include "clip/working_grid.hpp"
#include "host/support.hpp"

namespace spanline::host {
namespace {

using nlohmann::json;

class Clip : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.file(name)) << text;
    return folder_.file(name);
  }
  ToolRun run(const std::string& subject, const std::string& clip) const {
    return run_tool({"clip", file("s.geojson", subject), file("c.geojson", clip)});
  }
  json result(const std::string& subject, const std::string& clip) const {
    const ToolRun done = run(subject, clip);
    EXPECT_EQ(done.exit_code, 0) << done.err;
    return json::parse(done.out);
  }
  // The message after the folder's name.
  std::string complaint(const std::string& subject) const {
    const ToolRun done = run(subject, kBox);
    EXPECT_EQ(done.exit_code, 1);
    EXPECT_EQ(done.out, "");
    const std::string start = "spanline: " + folder_.file("");
    EXPECT_TRUE(done.err.starts_with(start) && done.err.ends_with('\n')) << done.err;
    return done.err.substr(start.size(), done.err.size() - start.size() - 1);
  }

  TemporaryFolder folder_;
  const std::string kBox = R"({"type":"Polygon","coordinates":[[[0,0],[10,0],[10,10],[0,10],[0,0]]]})";
};

double area_of(const json& polygons) {
  double sum = 0;
  for (const json& polygon : polygons) {
    for (const json& ring : polygon) {
      for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
        const double x0 = ring[i][0], y0 = ring[i][1], x1 = ring[i + 1][0], y1 = ring[i + 1][1];
        sum += (x0 * y1 - x1 * y0) / 2;
      }
    }
  }
  return sum;
}

const json& coordinates(const json& collection, std::size_t list) {
  return collection["features"][list]["geometry"]["coordinates"];
}

TEST_F(Clip, WritesBothListsAsRfc7946) {
  const json all = result(kBox, R"({"type":"Feature","properties":{"a":1},"geometry":
      {"type":"MultiPolygon","coordinates":[[[[2,2],[2,4],[4,4],[4,2],[2,2]]],[[[9,9],[12,9],[12,12],[9,12],[9,9]]]]}})");
  EXPECT_EQ(all["type"], "FeatureCollection");
  ASSERT_EQ(all["features"].size(), 2u);
  EXPECT_EQ(all["features"][0]["properties"], json::parse(R"({"list":"inside","scale":1})"));
  EXPECT_EQ(all["features"][1]["properties"], json::parse(R"({"list":"outside","scale":1})"));
  EXPECT_EQ(coordinates(all, 0),
            json::parse("[[[[2,2],[4,2],[4,4],[2,4],[2,2]]],[[[9,9],[10,9],[10,10],[9,10],[9,9]]]]"));
  EXPECT_EQ(coordinates(all, 1), json::parse("[[[[0,0],[10,0],[10,9],[9,9],[9,10],[0,10],[0,0]],"
                                             "[[2,2],[2,4],[4,4],[4,2],[2,2]]]]"));
}

TEST_F(Clip, EmptyCoordinatesAreAnEmptyRegion) {
  for (const char* empty :
       {R"({"type":"Polygon","coordinates":[]})", R"({"type":"MultiPolygon","coordinates":[]})",
        R"({"type":"MultiPolygon","coordinates":[[]]})", R"({"type":"Polygon","coordinates":[[]]})"}) {
    EXPECT_EQ(coordinates(result(kBox, empty), 0), json::array());
    EXPECT_EQ(area_of(coordinates(result(kBox, empty), 1)), 100);
    EXPECT_EQ(coordinates(result(empty, kBox), 0), json::array());
    EXPECT_EQ(coordinates(result(empty, kBox), 1), json::array());
  }
}

TEST_F(Clip, DecimalsAreScaledAndComeBackAsTheyWere) {
  const json all =
      result(R"({"type":"Polygon","coordinates":[[[0.1,0.1],[10.3,0.1],[10.3,10.25],[0.1,10.25],[0.1,0.1]]]})",
             R"({"type":"Polygon","coordinates":[[[5,5],[20,5],[20,20],[5,20],[5,5]]]})");
  EXPECT_EQ(all["features"][0]["properties"]["scale"], 100);
  EXPECT_EQ(coordinates(all, 0), json::parse("[[[[5,5],[10.3,5],[10.3,10.25],[5,10.25],[5,5]]]]"));
}

TEST_F(Clip, TheWholeRangeIsNotScaled) {
  const std::string wide =
      R"({"type":"Polygon","coordinates":[[[-32767,-32767],[32767,-32767],[32767,32767],[-32767,32767],
                               [-32767,-32767]]]})";
  const json all = result(wide, kBox);
  EXPECT_EQ(all["features"][0]["properties"]["scale"], 1);
  EXPECT_EQ(area_of(coordinates(all, 0)) + area_of(coordinates(all, 1)), 65534.0 * 65534.0);
}

TEST_F(Clip, WritesTheFileWholeOrNot) {
  const ToolRun done =
      run_tool({"clip", file("s.geojson", kBox), file("c.geojson", kBox), "--out", folder_.file("o.geojson")});
  EXPECT_EQ(done.exit_code, 0);
  EXPECT_EQ(done.out + done.err, "");
  EXPECT_EQ(area_of(coordinates(json::parse(read_file(folder_.file("o.geojson"))), 0)), 100);
  const ToolRun failed =
      run_tool({"clip", file("s.geojson", kBox), file("c.geojson", "{"), "--out", folder_.file("p.geojson")});
  EXPECT_EQ(failed.exit_code, 1);
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"c.geojson", "o.geojson", "s.geojson"}));
}

TEST_F(Clip, CountsWhatItLeavesOut) {
  const ToolRun done =
      run(R"({"type":"Polygon","coordinates":[[[0,0],[5,0],[5,0],[5,5],[0,0]],[[1,1],[2,2],[1,1]]]})", kBox);
  EXPECT_EQ(done.exit_code, 0);
  EXPECT_EQ(done.err, "spanline: note: 1 ring without area is left out\nspanline: note: 1 repeated point is merged\n");
}

TEST_F(Clip, BadInputIsNamedByFileAndPath) {
  EXPECT_EQ(complaint("{"),
            "s.geojson:1: column 2: not valid JSON: unexpected end "
            "of input; expected string literal");
  EXPECT_EQ(complaint("[]"), "s.geojson: /: must be an object");
  EXPECT_EQ(complaint("{}"), "s.geojson: /: key 'type' is missing");
  EXPECT_EQ(complaint(R"({"type":"Point","coordinates":[1,2]})"),
            "s.geojson: /type: must be Polygon, MultiPolygon or a Feature with one, not 'Point'");
  EXPECT_EQ(complaint(R"({"type":"Feature","geometry":null})"), "s.geojson: /geometry: must be an object");
  EXPECT_EQ(complaint(R"({"type":"Feature","geometry":{"type":"LineString"}})"),
            "s.geojson: /geometry/type: must be Polygon or MultiPolygon, not 'LineString'");
  EXPECT_EQ(complaint(R"({"type":"Polygon"})"), "s.geojson: /: key 'coordinates' is missing");
  EXPECT_EQ(complaint(R"({"type":"Polygon","coordinates":[[[0,0],[1],[1,1]]]})"),
            "s.geojson: /coordinates/0/1: must have at least 2 elements");
  EXPECT_EQ(complaint(R"({"type":"Polygon","coordinates":[[[0,0],[1,"a"],[1,1]]]})"),
            "s.geojson: /coordinates/0/1/1: must be a number");
  EXPECT_EQ(complaint(R"({"type":"Polygon","coordinates":[[[0,0],[32768,0],[1,1]]]})"),
            "s.geojson: /coordinates/0/1/0: must be a whole number from -32767 to 32767: only files with decimals are "
            "scaled");
  EXPECT_EQ(complaint(R"({"type":"Polygon","coordinates":[[[0,0],[1e13,0],[1,0.5]]]})"),
            "s.geojson: /coordinates/0/1/0: must be from -1000000000000 to 1000000000000");
}

TEST_F(Clip, WrongUsageIsTwo) {
  EXPECT_EQ(run_tool({"clip"}).exit_code, 2);
  EXPECT_EQ(run_tool({"clip", "one.geojson"}).exit_code, 2);
  EXPECT_EQ(run_tool({"clip", "a.geojson", "b.geojson", "c.geojson"}).exit_code, 2);
  EXPECT_EQ(run_tool({"clip", "a.geojson", "b.geojson", "--out"}).exit_code, 2);
  EXPECT_EQ(run_tool({"clip", "no-such.geojson", "b.geojson"}).exit_code, 1);
  EXPECT_EQ(run_tool({"clip", "--help"}).exit_code, 0);
}

TEST(WorkingGrid, FitsWhatIsTooFineOrTooFar) {
  const auto far_off = WorkingGrid::holding({{13.40001, 52.5}, {13.5, 52.61234}});
  EXPECT_EQ(far_off.scale(), 1e5) << "all decimals, round a middle";
  EXPECT_EQ(far_off.x_of(far_off.to_grid({13.40001, 52.5}).x), 13.40001);
  EXPECT_EQ(far_off.y_of(far_off.to_grid({0, 52.61234}).y), 52.61234);
  const auto fine = WorkingGrid::holding({{0, 0}, {1.0 / 3, 2.0 / 3}});
  EXPECT_EQ(fine.scale(), 5e4) << "at most 32766 either way of the middle";
  EXPECT_NEAR(fine.x_of(fine.to_grid({1.0 / 3, 0}).x), 1.0 / 3, 0.5 / 5e4);
  const auto wide = WorkingGrid::holding({{-1e12, -1e12}, {1e12, 1e12}, {0.5, 0}});
  EXPECT_EQ(wide.scale(), 2e-8);
  const auto single = WorkingGrid::holding({{0.3, 0.3}, {0.3, 0.3}});
  EXPECT_EQ(single.x_of(single.to_grid({0.3, 0.3}).x), 0.3);
}

}  // namespace
}  // namespace spanline::host
