// Debian's tinyobjloader as a rival: on good files both read the same; broken ones it lets pass.
#include <gtest/gtest.h>
#include <tiny_obj_loader.h>

#include "assetc/obj.hpp"
#include "host/support.hpp"

namespace spanline::host {
namespace {

struct Rival {
  tinyobj::attrib_t points;
  std::vector<tinyobj::shape_t> shapes;
  bool read = false;

  explicit Rival(const std::string& path) {
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    const std::string folder = path.substr(0, path.rfind('/') + 1);
    read = tinyobj::LoadObj(&points, &shapes, &materials, &warning, &error, path.c_str(), folder.c_str(), false);
  }

  // Faces with their positions, over all shapes in the order of the file.
  std::vector<std::vector<int>> faces() const {
    std::vector<std::vector<int>> all;
    for (const tinyobj::shape_t& shape : shapes) {
      std::size_t next = 0;
      for (const unsigned count : shape.mesh.num_face_vertices) {
        all.emplace_back();
        for (unsigned i = 0; i < count; ++i) all.back().push_back(shape.mesh.indices[next++].vertex_index);
      }
    }
    return all;
  }
};

TEST(Rival, ReadsTheSameFromGoodFiles) {
  for (const char* path : {"good/plain.obj", "good/crlf.obj", "good/screen.obj", "../../assets/bench/teapot4.obj"}) {
    const ObjMesh ours = read_obj(path);
    const Rival theirs(path);
    ASSERT_TRUE(theirs.read) << path;
    ASSERT_EQ(theirs.points.vertices.size(), ours.positions.size() * 3) << path;
    for (std::size_t i = 0; i < ours.positions.size(); ++i) {
      EXPECT_FLOAT_EQ(static_cast<float>(theirs.points.vertices[3 * i]), static_cast<float>(ours.positions[i].x));
      EXPECT_FLOAT_EQ(static_cast<float>(theirs.points.vertices[3 * i + 1]), static_cast<float>(ours.positions[i].y));
      EXPECT_FLOAT_EQ(static_cast<float>(theirs.points.vertices[3 * i + 2]), static_cast<float>(ours.positions[i].z));
    }
    std::vector<std::vector<int>> faces;
    for (const ObjFace& face : ours.faces) {
      faces.emplace_back();
      for (std::uint32_t i = 0; i < face.corner_count; ++i)
        faces.back().push_back(ours.corners[face.first_corner + i].position);
    }
    EXPECT_EQ(theirs.faces(), faces) << path;
  }
}

TEST(Rival, LetsPassWhatWeRefuse) {
  for (const char* path : {"broken/obj/nan.obj", "broken/obj/one-vertex-face.obj", "broken/obj/number-with-tail.obj"}) {
    EXPECT_TRUE(Rival(path).read) << path;
    EXPECT_NE(message_of([&] { read_obj(path); }), "") << path;
  }
}

}  // namespace
}  // namespace spanline::host
