#include <gtest/gtest.h>

#include <algorithm>

#include "assetc/emit_cpp.hpp"

namespace spanline::host {
namespace {

TEST(EmitCpp, NamesAreIdentifiers) {
  EXPECT_EQ(identifier_from("a/b/tea-pot.v2.hpp"), "tea_pot_v2");
  EXPECT_EQ(identifier_from("3d.hpp"), "scene_3d");
  EXPECT_EQ(identifier_from(".hpp"), "_hpp");
}

TEST(EmitCpp, SourceIncludesTheHeaderOrDeclaresItself) {
  const CompiledScene scene = compile(describe_obj("good/cube.obj", MeshShading::flat));
  const std::string with = emit_source(scene, "cube", "cube.hpp");
  EXPECT_NE(with.find("#include \"cube.hpp\""), std::string::npos);
  EXPECT_EQ(with.find("kWidth"), std::string::npos);
  const std::string without = emit_source(scene, "cube", "");
  EXPECT_NE(without.find("extern const spanline::SceneRecord scene;"), std::string::npos);
  EXPECT_NE(emit_header(scene, "cube").find("namespace cube {"), std::string::npos);
}

TEST(EmitCpp, KeepsToTheColumns) {
  const CompiledScene scene = compile(describe_obj("good/cube.obj", MeshShading::gouraud));
  const std::string source = emit_source(scene, "cube", "cube.hpp");
  EXPECT_EQ(std::count(source.begin(), source.end(), '{'), std::count(source.begin(), source.end(), '}'));
  EXPECT_NE(source.find("kPositions0[" + std::to_string(scene.meshes()[0].positions.size()) + "]"), std::string::npos);
}

TEST(EmitCpp, ReportAddsUp) {
  const CompiledScene scene = compile(describe_obj("good/cube.obj", MeshShading::flat));
  const std::string report = emit_report(scene, table_sizes(scene));
  EXPECT_NE(report.find("positions  48 bytes"), std::string::npos) << report;
  EXPECT_NE(report.find("faces      6 of 24 corners, at most 4 in one; before merging 6 of 24"), std::string::npos)
      << report;
}

}  // namespace
}  // namespace spanline::host
