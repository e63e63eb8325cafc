#include "oracle/compare.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace spanline::oracle {
namespace {

std::vector<Vertex> column_of(int left, std::int64_t z) {
  return {{left, 0, z}, {left + 16, 0, z}, {left + 16, 16, z}, {left, 16, z}};
}

// Column 0 is covered by faces 0 (depth 1000/256) and 1 (depth 1200/256), column 1 by face 2, column 2 by none.
Rendering truth() {
  return render(3, 1, {{0, {column_of(0, 1000)}}, {1, {column_of(0, 1200)}}, {2, {column_of(16, 0)}}});
}

TEST(Compare, TheOraclesOwnPictureIsRight) { EXPECT_TRUE(compare(truth().picture(), truth(), 0).empty()); }

TEST(Compare, AnotherFaceIsRightOnlyWithinTheTolerance) {
  Picture picture = truth().picture();
  picture.at(0, 0) = 0;
  EXPECT_TRUE(compare(picture, truth(), 256).empty());
  EXPECT_TRUE(compare(picture, truth(), 201).empty());
  EXPECT_EQ(compare(picture, truth(), 200).size(), 1u);
}

TEST(Compare, BackgroundForAFaceIsWrong) {
  Picture picture = truth().picture();
  picture.at(1, 0) = kNone;
  const std::vector<WrongPixel> wrong = compare(picture, truth());
  ASSERT_EQ(wrong.size(), 1u);
  EXPECT_EQ(wrong[0].column, 1);
  EXPECT_EQ(describe(wrong), "1 wrong pixels\n  column 1, line 0: expected face 2 at depth 0, drawn background\n");
}

TEST(Compare, AFaceThatDoesNotCoverIsWrong) {
  Picture picture = truth().picture();
  picture.at(2, 0) = 2;
  EXPECT_EQ(describe(compare(picture, truth())),
            "1 wrong pixels\n  column 2, line 0: expected background, drawn face 2, which does not cover it\n");
}

TEST(Compare, SizesMustAgree) { EXPECT_THROW(compare(Picture(2, 1), truth()), std::invalid_argument); }

}  // namespace
}  // namespace spanline::oracle
