#include <gtest/gtest.h>

#include <filesystem>

#include "assetc/compile.hpp"
#include "assetc/input_error.hpp"
#include "assetc/scene_json.hpp"
#include "frames/code_parts.hpp"
#include "frames/count.hpp"
#include "frames/link_map.hpp"
#include "frames/rivals.hpp"
#include "sim/output_file.hpp"

namespace spanline::bench {
namespace {

std::string file_with(const std::string& text) {
  const std::string path = testing::TempDir() + "frames_test.map";
  host::write_file(path, text);
  return path;
}

TEST(LinkMap, CountsWhatTheEnginePlaced) {
  const std::string path = file_with(
      "Discarded input sections\n\n"
      " .text.gone      0x00000000      0x999 core/libspanline_vsg.a(edge.cpp.obj)\n"
      "Linker script and memory map\n\n"
      ".text           0x00000000     0x4000\n"
      " .text.startup   0x00000040       0x20 main.cpp.obj\n"
      " .text._ZN8spanline5bench4drawEv\n"
      "                0x00000058        0x8 main.cpp.obj\n"
      " .text._ZN8spanline5FrameILb0EE9next_lineEv\n"
      "                0x00000050        0x8 main.cpp.obj\n"
      " .text.first     0x00000060       0x30 core/libspanline_vsg.a(edge.cpp.obj)\n"
      " .text._ZN8spanline20a_long_name_of_its_own\n"
      "                0x00000090       0x0c core/libspanline_frame.a(frame_plane.cpp.obj)\n"
      "                0x00000090                spanline::a_long_name_of_its_own()\n"
      " .rodata.table   0x0000009c        0x4 core/libspanline_fx.a(sine.cpp.obj)\n"
      " .text           0x000000a0       0x10 /usr/lib/gcc/arm/libgcc.a(_udivsi3.o)\n"
      " .bss.pool       0x20000000      0x100 core/libspanline_frame.a(frame_plane.cpp.obj)\n"
      " .debug_info     0x00000000      0x500 core/libspanline_frame.a(frame_plane.cpp.obj)\n");
  EXPECT_EQ(engine_text_bytes(path), 0x08u + 0x30 + 0x0c + 0x04 + 0x10);
}

TEST(CodeParts, AreAllOfTheEngine) {
  const std::string path = file_with(
      "Linker script and memory map\n\n"
      " .text.spanline_flat_walk 0x00000000 0x100 core/libspanline_shade.a(walk_thumb2.cpp.obj)\n"
      " .text._ZN8spanline10EdgeWalker5go_onINS_9MeshLinesEEEv 0x00000100 0x40 main.cpp.obj\n"
      " .text._ZN8spanline9MeshLines9make_lookEt 0x00000140 0x20 core/libspanline_frame.a(frame_edges.cpp.obj)\n"
      " .text._ZN8spanline12check_cameraE 0x00000160 0x8 core/libspanline_geom.a(camera.cpp.obj)\n");
  const std::vector<CodePart> parts = code_parts(path);
  std::uint32_t bytes = 0;
  for (const CodePart& part : parts) bytes += part.bytes;
  EXPECT_EQ(bytes, engine_text_bytes(path));
  EXPECT_EQ(parts.front().bytes, 0x140u);  // the walk
  EXPECT_EQ(parts[4].bytes, 0x20u);        // brightness
  EXPECT_EQ(parts.back().bytes, 0x8u);     // the rest
}

TEST(LinkMap, RefusesWhatIsNone) {
  EXPECT_THROW(engine_text_bytes(file_with("nothing\n")), host::InputError);
  EXPECT_THROW(engine_text_bytes("no/such.map"), host::InputError);
}

TEST(Frames, StandBesideThoseWhoDrewTheSame) {
  const std::vector<Rival> rivals = rivals_of("S3", "m4", "flat");
  ASSERT_EQ(rivals.size(), 3u);
  EXPECT_STREQ(rivals.front().name, "tgx");
  EXPECT_EQ(rivals.front().thousands, 1202u);
  EXPECT_TRUE(rivals_of("mine", "m4", "flat").empty());
}

TEST(Frames, GoIntoTheTableAndTheFile) {
  const FrameCount frame{"m4", {"S3", "flat", 0, 992, 0, 0, 0}, {601'000, 900'000}, 9'000, 1'280, 700, 12'000};
  EXPECT_EQ(frames_json({frame}),
            "[\n  {\n    \"scene\": \"S3\",\n    \"cpu\": \"m4\",\n    \"shading\": \"flat\",\n    \"instructions\": "
            "601000,\n    \"ram_bytes\": 10980,\n    \"text_bytes\": 12000\n  }\n]\n");
  EXPECT_NE(frames_table({frame}).find("tgx 1202 k (0.50)"), std::string::npos);
}

TEST(Units, OfACube) {
  const host::CompiledScene scene = host::compile(host::read_scene(SPANLINE_SCENES "/S1.json"));
  const SceneRecord record = scene.record();
  SceneView view;
  ASSERT_TRUE(SceneView::validate(record, view).ok());
  const Units units = units_of(view, scene.camera(), {320, 240});
  EXPECT_EQ(units.vertices, 24u);  // each side has its own
  EXPECT_EQ(units.faces, 12u);
  EXPECT_EQ(units.fronts, 6u);  // three sides
  EXPECT_EQ(units.edges, 15u);  // four and a diagonal a side
  EXPECT_GT(units.edge_lines, 3u * 100);
  EXPECT_EQ(units.overlaps, 0u);
  EXPECT_EQ(units.overlapping, 0u);
}

}  // namespace
}  // namespace spanline::bench
