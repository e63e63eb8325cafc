// Writes the table of expected.hpp: random scenes that fit a small target and leave no pixel to the engine's tolerance,
// with the checksum of the oracle's picture of each.
// usage: spanline_target_pictures OUT.cpp
#include <cstdio>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "assetc/emit_records.hpp"
#include "oracle/compare.hpp"
#include "oracle/random_camera_scene.hpp"
#include "oracle/random_scene.hpp"
#include "pictures/draw.hpp"
#include "vsg/facets_of_core.hpp"
#include "walker/random_mesh_scene.hpp"

// What the pictures are for: none is there yet.
const spanline::Slice<const spanline::target::Expected> spanline::target::kExpected;

namespace spanline::target {
namespace {

constexpr Screen kScreen{64, 48, PixelFormat::rgb565};
constexpr std::size_t kFewestFaces = 4;  // seen in a picture

bool fits(const SceneRecord& scene, const Screen& screen) {
  std::uint32_t vertices = 0, faces = 0, corners = 0;
  for (const InstanceRecord& instance : scene.instances) {
    const MeshRecord& mesh = scene.meshes[instance.mesh];
    vertices += mesh.positions.size();
    faces += mesh.face_count;
    corners += mesh.corners.size();
  }
  return vertices <= kPicturesBudget.vertices && faces <= kPicturesBudget.polygons &&
         corners <= kPicturesBudget.segments && screen.width <= kPicturesBudget.width &&
         screen.height <= kPicturesBudget.height;
}

// Whether every pixel's visible face is in front of all others by more than `tolerance`; 0 asks for nothing.
bool decided(const oracle::Rendering& truth, std::int64_t tolerance) {
  for (int line = 0; line < truth.height(); ++line) {
    for (int column = 0; column < truth.width(); ++column) {
      const auto& candidates = truth.candidates(column, line);
      for (std::size_t i = 1; i < candidates.size(); ++i) {
        if (oracle::closer_than(candidates[i].depth, candidates[0].depth, tolerance)) return false;
      }
    }
  }
  return true;
}

std::uint32_t crc_of(const oracle::Picture& picture, const Screen& screen) {
  FaceSum sum(screen);
  for (const std::uint32_t face : picture.faces) sum.add(static_cast<std::uint16_t>(face));
  return sum.crc();
}

class Writer {
 public:
  // False where the scene is not one to be used.
  bool add(const std::string& name, const SceneRecord& record, const CameraRecord& camera, const Screen& screen,
           std::int64_t tolerance, bool edges = false) {
    SceneView scene;
    if (!fits(record, screen) || !SceneView::validate(record, scene).ok()) return false;
    const oracle::Rendering truth = oracle::render(screen.width, screen.height, test::facets_of(scene, camera, screen));
    const oracle::Picture picture = truth.picture();
    const std::set<std::uint32_t> seen(picture.faces.begin(), picture.faces.end());
    if (seen.size() < kFewestFaces || !decided(truth, tolerance)) return false;
    const Expected expected{name.c_str(), &record, &camera, screen, edges, crc_of(picture, screen)};
    if (edges && !decide_by_edges(expected).status.ok()) return false;
    const std::string space = "picture_" + std::to_string(count_++);
    scenes_ << "namespace " << space << " {\n" << host::emit_records(record, camera) << "}  // namespace\n";
    list_ << "    {\"" << name << "\", &" << space << "::scene, &" << space << "::camera, {" << screen.width << ", "
          << screen.height << ", spanline::PixelFormat::rgb565}, " << (edges ? "true" : "false") << ", " << expected.crc
          << "u},\n";
    return true;
  }

  std::string source() const {
    return "// Made by spanline_target_pictures; do not edit.\n#include \"pictures/expected.hpp\"\n\nnamespace {\n" +
           scenes_.str() + "constexpr spanline::target::Expected kList[] = {\n" + list_.str() +
           "};\n}  // namespace\n\n"
           "const spanline::Slice<const spanline::target::Expected> spanline::target::kExpected = kList;\n";
  }

 private:
  int count_ = 0;
  std::ostringstream scenes_, list_;
};

// add(seed) for rising seeds until it has taken `wanted` of them.
template <typename Add>
void take(int wanted, const Add& add) {
  for (std::uint64_t seed = 0; wanted > 0; ++seed) wanted -= add(seed);
}

void add_facets(Writer& writer, int wanted, const std::string& kind, std::vector<oracle::Facet> (*make)(std::uint64_t),
                std::int64_t tolerance) {
  take(wanted, [&](std::uint64_t seed) {
    oracle::SceneStore store = oracle::screen_scene(make(seed), oracle::random_layout(seed));
    return writer.add(kind + "-" + std::to_string(seed), store.record(), oracle::plain_camera(), kScreen, tolerance);
  });
}

std::string source() {
  Writer writer;
  add_facets(writer, 9, "screen", oracle::random_screen_facets, oracle::kOneUnit);
  add_facets(writer, 5, "level", oracle::random_level_facets, 0);  // ties, which are exact
  take(8, [&](std::uint64_t seed) {
    oracle::CameraScene space = oracle::random_camera_scene(seed);
    return writer.add("camera-" + std::to_string(seed), space.scene.record(), space.camera, kScreen, oracle::kOneUnit);
  });
  take(8, [&](std::uint64_t seed) {
    test::MeshScene mesh = test::random_mesh_scene(seed);
    mesh.screen.format = PixelFormat::rgb565;
    return writer.add("mesh-" + std::to_string(seed), mesh.record(), mesh.camera, mesh.screen, oracle::kOneUnit, true);
  });
  return writer.source();
}

}  // namespace
}  // namespace spanline::target

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: spanline_target_pictures OUT.cpp\n");
    return 2;
  }
  std::ofstream file(argv[1]);
  file << spanline::target::source();
  file.close();
  return file ? 0 : 1;
}
