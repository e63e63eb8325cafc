#include "assetc/bpt.hpp"

#include <gtest/gtest.h>

#include "host/support.hpp"

namespace spanline::host {
namespace {

// 16 points, (i, i + 0.5, -i), `between` numbers and `after` each point.
std::string points(const char* between = " ", const char* after = "\n") {
  std::string text;
  for (int i = 0; i < 16; ++i) {
    const std::string n = std::to_string(i);
    text.append(n).append(between).append(n).append(".5").append(between).append("-").append(n).append(after);
  }
  return text;
}

void expect_points(const BptPatch& patch) {
  for (std::size_t i = 0; i < 16; ++i) {
    const double n = static_cast<double>(i);
    EXPECT_EQ(patch.points[i / 4][i % 4], (Vec3{n, n + 0.5, -n})) << i;
  }
}

std::string error_of(const std::string& text) {
  return message_of([&] { parse_bpt("t.bpt", text); });
}

TEST(Bpt, ReadsPatchesWithDegrees) {
  const auto patches = parse_bpt("t.bpt", "2\n3 3\n" + points() + "3 3\n" + points());
  ASSERT_EQ(patches.size(), 2u);
  expect_points(patches[0]);
  expect_points(patches[1]);
  EXPECT_EQ(patches[0].line, 3u);
  EXPECT_EQ(patches[1].line, 20u);
}

TEST(Bpt, ReadsPatchesWithoutDegrees) {
  const auto patches = parse_bpt("t.bpt", "2\n" + points() + points());
  ASSERT_EQ(patches.size(), 2u);
  expect_points(patches[1]);
}

TEST(Bpt, ReadsCommasCommentsAndAnyLineEnds) {
  expect_points(parse_bpt("t.bpt", "# a patch\n1\n" + points(",", ",\n"))[0]);
  expect_points(parse_bpt("t.bpt", "1\r\n3, 3\r\n" + points(", ", "\r\n"))[0]);
  expect_points(parse_bpt("t.bpt", "1\n3 3\n" + points(" ", " "))[0]);  // all on one line
  expect_points(parse_bpt("t.bpt", "1\n" + points("\n", "\n\n"))[0]);   // a number a line
  expect_points(parse_bpt("t.bpt", "1\n" + points(" ", " ") + "\n\n")[0]);
}

TEST(Bpt, ReadsIndexedPatches) {
  const std::string text = "2\n1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16\n16,15,14,13,12,11,10,9,8,7,6,5,4,3,2,1\n16\n";
  const auto patches = parse_bpt("t.bpt", text + points(","));
  ASSERT_EQ(patches.size(), 2u);
  expect_points(patches[0]);
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_EQ(patches[1].points[i / 4][i % 4], patches[0].points[(15 - i) / 4][(15 - i) % 4]);
  }
  EXPECT_EQ(patches[1].line, 3u);
}

TEST(Bpt, ReadsTheTeapot) {
  const auto patches = read_bpt(std::string(SPANLINE_ASSETS) + "/teapot.bpt");
  ASSERT_EQ(patches.size(), 32u);
  EXPECT_EQ(patches[0].points[0][0], (Vec3{1.4, 0, 2.4}));
}

TEST(Bpt, NamesTheLineOfWhatIsWrong) {
  EXPECT_EQ(error_of(""), "t.bpt:1: the file is empty; its first line is the number of patches");
  EXPECT_EQ(error_of("x\n"), "t.bpt:1: 'x' is not a number of patches from 1 to 65535");
  EXPECT_EQ(error_of("0\n"), "t.bpt:1: '0' is not a number of patches from 1 to 65535");
  EXPECT_EQ(error_of("-1\n"), "t.bpt:1: '-1' is not a number of patches from 1 to 65535");
  EXPECT_EQ(error_of("1e30\n"), "t.bpt:1: '1e30' is not a number of patches from 1 to 65535");
  EXPECT_EQ(error_of("3 3\n" + points()), "t.bpt:1: the number of patches stands alone on its line");
  EXPECT_EQ(error_of("1\n3 3\n0 0 nan\n"), "t.bpt:3: 'nan' is not a number between -1e12 and 1e12");
  EXPECT_EQ(error_of("1\n3 3\n0 0 1\n0 1e30 0\n"), "t.bpt:4: '1e30' is not a number between -1e12 and 1e12");
  EXPECT_EQ(error_of("1\n2 3\n" + points()), "t.bpt:2: '2' is not the degree 3: only bicubic patches are read");
  EXPECT_EQ(error_of("2\n3 3\n" + points() + points()),
            "t.bpt:19: '0' is not the degree 3: only bicubic patches are read");
}

TEST(Bpt, RefusesCountsThatDoNotMatch) {
  EXPECT_EQ(error_of("1\n"), "t.bpt:1: the file ends in patch 1 of 1");
  EXPECT_EQ(error_of("2\n3 3\n" + points()), "t.bpt:18: the file ends in patch 2 of 2");
  EXPECT_EQ(error_of("65535\n" + points()), "t.bpt:17: the file ends in patch 2 of 65535");
  EXPECT_EQ(error_of("1\n" + points() + "0\n"),
            "t.bpt:18: there is more after the 1 patches that the first line promises");
  EXPECT_EQ(error_of("1\n" + points(" ", " ") + "7\n"),
            "t.bpt:2: there is more after the 1 patches that the first line promises");
  const std::string indexed = "1\n1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16\n";
  EXPECT_EQ(error_of(indexed + "16\n" + points() + "0 0 0\n"),
            "t.bpt:20: there is more after the 1 patches that the first line promises");
  EXPECT_EQ(error_of(indexed + "17\n" + points()), "t.bpt:19: the file ends in vertex 17 of 17");
  EXPECT_EQ(error_of(indexed + "1\n0 0 0\n"), "t.bpt:2: vertex 2 does not exist: the file has 1");
}

TEST(Bpt, AnyCutOfAGoodFileIsRefused) {
  const std::string whole = "1\n3 3\n" + points();
  for (std::size_t length = 0; length + 3 < whole.size(); ++length) {
    const std::string message = error_of(whole.substr(0, length));
    EXPECT_TRUE(message.starts_with("t.bpt:")) << length << ": " << message;
  }
}

}  // namespace
}  // namespace spanline::host
