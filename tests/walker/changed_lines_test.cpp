// Frames that draw only what may have changed, against whole ones: what a panel shows that keeps what it was sent is
// the same in every byte after every frame of random animations. SPANLINE_FULL=1 looks at more of them, SPANLINE_SEED=N
// at one.
#include <gtest/gtest.h>

#include "oracle/random.hpp"
#include "oracle/random_camera_scene.hpp"
#include "vsg/scale.hpp"
#include "walker/decisions.hpp"

namespace spanline::test {
namespace {

using oracle::Random;

constexpr int kFrames = 6;

// Things that move, turn, hide and change their colours, or stand still, before a camera that mostly does.
class Motion {
 public:
  Motion(std::uint64_t seed, std::vector<InstanceRecord> instances, const CameraRecord& camera)
      : random_(seed), restless_(random_.between(0, 60)), instances_(std::move(instances)), camera_(camera) {}

  // Where the instances stand from now on.
  Slice<const InstanceRecord> instances() const {
    return {instances_.data(), static_cast<std::uint32_t>(instances_.size())};
  }
  const CameraRecord& camera() const { return camera_; }

  void step(std::uint32_t materials) {
    for (InstanceRecord& instance : instances_) {
      if (random_.percent(restless_)) move(instance, materials);
    }
    if (random_.percent(10)) camera_.eye[random_.below(3)].raw += random_.between(-20000, 20000);
  }

 private:
  void move(InstanceRecord& instance, std::uint32_t materials) {
    if (random_.percent(15)) instance.flags ^= InstanceRecord::kHidden;
    if (random_.percent(15)) {
      instance.material = static_cast<std::uint16_t>(random_.below(static_cast<int>(materials)));
    }
    if ((instance.flags & InstanceRecord::kScreen) != 0) return;
    if (random_.percent(50)) instance.transform.translation[random_.below(3)].raw += random_.between(-40000, 40000);
    if (random_.percent(50)) {  // a quarter turn keeps the matrix in range
      for (Fx16(&row)[3] : instance.transform.matrix) {
        const Fx16 first = row[0];
        row[0].raw = -row[1].raw;
        row[1] = first;
      }
    }
  }

  Random random_;
  int restless_;
  std::vector<InstanceRecord> instances_;
  CameraRecord camera_;
};

// What is known between the frames of one animation.
class Kept {
 public:
  Kept(const Screen& screen, std::size_t instances) : instances_(instances), lines_((screen.height + 31u) / 32) {}
  ChangesStorage storage() {
    return {{instances_.data(), static_cast<std::uint32_t>(instances_.size())},
            {lines_.data(), static_cast<std::uint32_t>(lines_.size())}};
  }

 private:
  std::vector<KeptInstance> instances_;
  std::vector<std::uint32_t> lines_;
};

// A panel that keeps what it was sent.
struct Panel {
  explicit Panel(std::uint16_t height) : lines(height) {}
  std::vector<std::vector<std::uint8_t>> lines;
  int drawn = 0;  // lines of the last frame
};

template <typename TheFrame>
Status draw_frame(TheFrame& frame, const SceneView& view, const CameraRecord& camera, Panel& panel) {
  std::vector<std::uint32_t> words(frame.line_bytes() / 4 + 1);
  const Slice<std::uint8_t> line(reinterpret_cast<std::uint8_t*>(words.data()), frame.line_bytes());
  panel.drawn = 0;
  for (Band rest{0, static_cast<std::uint16_t>(panel.lines.size())}; !rest.empty();) {
    const Band band = frame.prepare(view, camera, rest);
    if (band.empty()) break;
    for (std::uint16_t at = band.top; frame.next_line(line); ++at, ++panel.drawn) {
      panel.lines.at(at).assign(line.begin(), line.end());
    }
    rest.top = band.bottom;
  }
  return frame.status();
}

// Of all animations of a test.
struct Totals {
  int lines = 0, drawn = 0, animations = 0;
};

template <Walker kWalker>
void compare(const SceneRecord& scene_as_made, const std::vector<InstanceRecord>& instances, const Screen& screen,
             const CameraRecord& camera, std::uint64_t seed, Totals& totals) {
  SceneRecord record = scene_as_made;
  Motion motion(seed, instances, camera);
  record.instances = motion.instances();
  SceneView view;
  ASSERT_TRUE(SceneView::validate(record, view).ok());
  Memory pools(screen), whole_pools(screen);
  Kept kept(screen, instances.size());
  FrameStorage storage = pools.memory.storage();
  storage.changes = kept.storage();
  Frame<FrameOptions{.walker = kWalker, .changes = true}> some(storage);
  Frame<FrameOptions{.walker = kWalker}> whole(whole_pools.memory.storage());
  Panel panel(screen.height), expected(screen.height);
  for (int frame = 0; frame < kFrames; ++frame) {
    SCOPED_TRACE(testing::Message() << "frame " << frame);
    ASSERT_TRUE(SceneView::validate(record, view).ok());
    if (!check_camera(motion.camera()).ok()) return;
    const Status all = draw_frame(whole, view, motion.camera(), expected);
    const Status changed = draw_frame(some, view, motion.camera(), panel);
    if (!all.ok()) return;  // what this walker cannot draw
    ASSERT_TRUE(changed.ok());
    ASSERT_EQ(expected.drawn, screen.height);
    ASSERT_TRUE(panel.lines == expected.lines);
    if (frame != 0) {
      totals.drawn += panel.drawn;
      totals.lines += screen.height;
      totals.animations += frame == kFrames - 1;
    } else {
      ASSERT_EQ(panel.drawn, screen.height);
    }
    motion.step(record.materials.size());
    if (frame == kFrames / 2 && !record.lights.empty()) {
      record.lights =
          record.lights.size() > 1 ? Slice<const LightRecord>(record.lights.data(), 1) : Slice<const LightRecord>();
      some.forget();
    }
  }
}

class ChangedLinesOf : public testing::TestWithParam<int> {
 protected:
  template <typename Check>
  void for_each_seed(std::uint64_t few, std::uint64_t many, const Check& check) {
    const char* only = std::getenv("SPANLINE_SEED");
    const auto first = static_cast<std::uint64_t>(only != nullptr ? std::atoll(only) : GetParam());
    const std::uint64_t end = only != nullptr ? first + 1 : scene_count(few, many);
    for (std::uint64_t seed = first; seed < end && !HasFailure(); seed += kShards) {
      SCOPED_TRACE(testing::Message() << "seed " << seed);
      check(seed);
    }
    if (only != nullptr) return;
    EXPECT_LT(totals.drawn * 10, totals.lines * 9) << "too few lines are left out to see anything";
    EXPECT_GT(totals.animations, 0);
  }
  Totals totals;
};

TEST_P(ChangedLinesOf, MeshesByTheEdgeWalker) {
  for_each_seed(960, 20000, [&](std::uint64_t seed) {
    MeshScene scene = random_mesh_scene(seed);
    compare<Walker::edges>(scene.record(), scene.instances, scene.screen, scene.camera, seed, totals);
  });
}

TEST_P(ChangedLinesOf, MeshesByBothWalkers) {
  for_each_seed(480, 20000, [&](std::uint64_t seed) {
    MeshScene scene = random_mesh_scene(seed);
    compare<Walker::both>(scene.record(), scene.instances, scene.screen, scene.camera, seed, totals);
  });
}

TEST_P(ChangedLinesOf, PolygonsByTheSegmentWalker) {
  for_each_seed(480, 20000, [&](std::uint64_t seed) {
    oracle::CameraScene scene = oracle::random_camera_scene(seed);
    const SceneRecord record = scene.scene.record();
    const std::vector<InstanceRecord> instances(record.instances.begin(), record.instances.end());
    compare<Walker::segments>(record, instances, {64, 48}, scene.camera, seed, totals);
  });
}

INSTANTIATE_TEST_SUITE_P(Shards, ChangedLinesOf, testing::Range(0, kShards));

}  // namespace
}  // namespace spanline::test
