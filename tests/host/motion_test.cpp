#include "assetc/motion.hpp"

#include <gtest/gtest.h>

#include "assetc/scene_json.hpp"

namespace spanline::host {
namespace {

Motion ramp() {
  Motion motion;
  motion.frames = 20;
  motion.keys = {{5, {0}}, {15, {10}}};
  return motion;
}

TEST(Motion, HoldsBeforeTheFirstKeyAndAfterTheLast) {
  EXPECT_EQ(ramp().at(0, {})[0], 0);
  EXPECT_EQ(ramp().at(19, {})[0], 10);
}

TEST(Motion, RunsStraightBetweenKeys) {
  EXPECT_DOUBLE_EQ(ramp().at(5, {})[0], 0);
  EXPECT_DOUBLE_EQ(ramp().at(8, {})[0], 3);
  EXPECT_DOUBLE_EQ(ramp().at(15, {})[0], 10);
}

TEST(Motion, LoopsUnlessTold) {
  Motion motion = ramp();
  EXPECT_EQ(motion.at(28, {}), motion.at(8, {}));
  motion.loop = false;
  EXPECT_EQ(motion.at(28, {})[0], 10);
}

TEST(Motion, SmoothIsSlowAtKeysAndStaysBetweenThem) {
  Motion motion = ramp();
  motion.smooth = true;
  EXPECT_LT(motion.at(6, {})[0], 1);
  EXPECT_DOUBLE_EQ(motion.at(10, {})[0], 5);
  for (int frame = 5; frame < 15; ++frame) EXPECT_LE(motion.at(frame, {})[0], motion.at(frame + 1, {})[0]);
}

TEST(Motion, WithoutKeysRests) { EXPECT_EQ(Motion{}.at(7, {3})[0], 3); }

Vec3 placed(const std::string& instance, std::int64_t frame, Vec3 point) {
  const SceneDescription scene =
      parse_scene("s.json", R"({"meshes":[{"name":"m","vertices":[[0,0,0],[1,0,0],[0,1,0]],"faces":[[0,1,2]]}],)"
                            R"("instances":[{"mesh":"m",)" +
                                instance + "}]}");
  return scene.instances[0].placement(frame)(point);
}

void expect_near(Vec3 a, Vec3 b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
  EXPECT_NEAR(a.z, b.z, 1e-12);
}

TEST(Placement, ScalesThenTurnsThenMoves) {
  expect_near(placed(R"("translate":[10,0,0],"rotate":[0,90,0],"scale":[2,3,4])", 0, {1, 1, 1}), {14, 3, -2});
}

TEST(Placement, TurnsAboutXFirst) { expect_near(placed(R"("rotate":[90,90,0])", 0, {0, 1, 0}), {1, 0, 0}); }

TEST(Placement, TurnsAboutAnAxis) { expect_near(placed(R"("rotate":[1,1,1,120])", 0, {1, 0, 0}), {0, 1, 0}); }

TEST(Placement, TakesAMatrixAsItIs) {
  expect_near(placed(R"("matrix":[0,-1,0,5, 1,0,0,6, 0,0,1,7])", 0, {1, 2, 3}), {3, 7, 10});
}

TEST(Placement, KeysInheritWhatTheyLeaveOut) {
  const std::string instance = R"("translate":[1,0,0],"scale":2,"motion":{"loop":false,"keys":[{"frame":0},)"
                               R"({"frame":10,"rotate":[0,0,1,90]},{"frame":20,"translate":[5,0,0]}]})";
  expect_near(placed(instance, 0, {1, 0, 0}), {3, 0, 0});
  expect_near(placed(instance, 10, {1, 0, 0}), {1, 2, 0});
  expect_near(placed(instance, 20, {1, 0, 0}), {5, 2, 0});
  expect_near(placed(instance, 15, {1, 0, 0}), {3, 2, 0});
}

}  // namespace
}  // namespace spanline::host
