#include "assetc/obj.hpp"

#include <gtest/gtest.h>

#include "host/support.hpp"

namespace spanline::host {
namespace {

TEST(Obj, ReadsEveryForm) {
  const ObjMesh mesh = read_obj("good/cube.obj");
  ASSERT_EQ(mesh.positions.size(), 8u);
  ASSERT_EQ(mesh.faces.size(), 6u);
  EXPECT_EQ(mesh.positions[4], (Vec3{-1, -1, -1}));
  EXPECT_EQ(mesh.position_lines[4], 8u);
  for (const ObjFace& face : mesh.faces) EXPECT_EQ(face.corner_count, 4u);
  // The first face is continued over two lines and carries its normals.
  EXPECT_EQ(mesh.faces[0].line, 19u);
  EXPECT_EQ(mesh.corners[3].position, 3);
  EXPECT_EQ(mesh.corners[3].normal, 0);
  // f -3 -4 -1 -2: counted back from vertex 8.
  EXPECT_EQ(mesh.corners[4].position, 5);
  EXPECT_EQ(mesh.corners[6].position, 7);
  EXPECT_EQ(mesh.corners[6].normal, kNone);
}

TEST(Obj, ReadsColoursOfTheLibrary) {
  const ObjMesh mesh = read_obj("good/cube.obj");
  ASSERT_EQ(mesh.materials.size(), 2u);
  EXPECT_EQ(mesh.materials[0].name, "blue sky");
  EXPECT_EQ(mesh.materials[0].color, (Color{64, 128, 255}));
  EXPECT_EQ(mesh.faces[0].material, 0);
  EXPECT_EQ(mesh.faces[5].material, 1);
}

TEST(Obj, ReadsWindowsLineEndsAndShortNumbers) {
  const ObjMesh mesh = read_obj("good/crlf.obj");
  ASSERT_EQ(mesh.faces.size(), 1u);
  EXPECT_EQ(mesh.faces[0].corner_count, 5u);
  EXPECT_EQ(mesh.positions[3], (Vec3{1, 0.5, 0}));
  EXPECT_EQ(mesh.positions[4], (Vec3{0, 2, 0}));
}

TEST(Obj, TakesFacesBeforeTheirVertices) {
  const ObjMesh mesh = parse_obj("m.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n");
  EXPECT_EQ(mesh.corners[2].position, 2);
}

TEST(Obj, NamesTheLineOfAContinuedStatement) {
  EXPECT_EQ(message_of([] { parse_obj("m.obj", "v 0 0 0\n\nf 1 \\\n1 \\\nx\n"); }),
            "m.obj:3: 'x' is not a vertex index");
}

}  // namespace
}  // namespace spanline::host
