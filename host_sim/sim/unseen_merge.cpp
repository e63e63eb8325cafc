#include "sim/unseen_merge.hpp"

#include "assetc/input_error.hpp"
#include "sim/engine.hpp"
#include "sim/orbit.hpp"
#include "sim/status_text.hpp"

namespace spanline::host {
namespace {

constexpr int kPictures = 24;
constexpr double kReach = 8;  // bounding radii that the viewer may be off

// What a scene looks like: its own view first, then one step around it, up or down, and on in time with each picture.
class Witness {
 public:
  explicit Witness(const SceneDescription& description) : scene_(compile(description, kReach)) {
    EngineOptions options;
    options.width = description.width;
    options.height = description.height;
    engine_ = Engine::make(options);
    pictures_ = draw();
  }

  // Whether the mesh may be merged: then it is.
  bool merge(std::size_t mesh, std::uint32_t most_corners) {
    MeshTables apart = scene_.meshes()[mesh];
    scene_.merge_coplanar(mesh, most_corners);
    if (scene_.meshes()[mesh].face_count == apart.face_count || draw() == pictures_) return true;
    scene_.replace(mesh, std::move(apart));
    return false;
  }

 private:
  std::vector<std::vector<std::uint8_t>> draw() {
    std::vector<std::vector<std::uint8_t>> pictures;
    for (int i = 0; i < kPictures; ++i) {
      scene_.show(scene_.moves() ? 5 * i : 0);
      if (i != 0) {
        Orbit orbit(scene_.view(), scene_.bounds(), scene_.description().height, kReach);
        orbit.turn(360.0 / kPictures * i, 20.0 * (i % 3 - 1));
        scene_.look(orbit.view());
      }
      Rendering rendering;
      const SceneRecord record = scene_.record();
      const Status status = engine_->render(validated(record, scene_.description().place), scene_.camera(), rendering);
      if (!status.ok()) throw InputError(scene_.description().place, status_text(status));
      pictures.push_back(std::move(rendering.picture.rgb));
    }
    return pictures;
  }

  CompiledScene scene_;
  std::unique_ptr<Engine> engine_;
  std::vector<std::vector<std::uint8_t>> pictures_;
};

}  // namespace

UnseenMerge merge_unseen(CompiledScene& scene, std::uint32_t most_corners) {
  UnseenMerge done{{}, kPictures};
  Witness witness(scene.description());
  for (std::size_t mesh = 0; mesh < scene.meshes().size(); ++mesh) {
    if (witness.merge(mesh, most_corners)) {
      scene.merge_coplanar(mesh, most_corners);
    } else {
      done.kept_apart.push_back(scene.meshes()[mesh].name);
    }
  }
  return done;
}

}  // namespace spanline::host
