// Every broken file is refused with one line that begins with the file, and its line or path where there is one.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "assetc/compile.hpp"
#include "assetc/patch_mesh.hpp"
#include "assetc/scene_json.hpp"
#include "host/support.hpp"

namespace spanline::host {
namespace {

void load(const std::string& path) {
  compile(path.ends_with(".obj")   ? describe_obj(path, MeshShading::automatic)
          : path.ends_with(".bpt") ? describe_bpt(path, MeshShading::automatic)
                                   : read_scene(path));
}

TEST(BrokenFiles, EachGivesTheExpectedLine) {
  for (const BrokenFile& file : broken_files()) {
    const std::string message = message_of([&] { load(file.path); });
    EXPECT_TRUE(message.starts_with(file.message)) << file.message << "\n" << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << file.path;
  }
}

TEST(BrokenFiles, TheListIsWhole) {
  std::set<std::string> listed;
  for (const BrokenFile& file : broken_files()) listed.insert(file.path);
  EXPECT_GE(listed.size(), 60u);
  for (const char* folder : {"broken/bpt", "broken/obj", "broken/scene"}) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".mtl") continue;  // read by the .obj beside it
      EXPECT_TRUE(listed.contains(entry.path().string())) << entry.path();
    }
  }
}

TEST(BrokenFiles, AnyCutOfAGoodSceneIsRefusedOrRead) {
  const std::string whole = R"({"size":[8,8],"meshes":[{"name":"m","vertices":[[0,0,0],[1,0,0],[1,1,0]],)"
                            R"("faces":[[0,1,2]]}],"instances":[{"mesh":"m","rotate":[0,10,0]}]})";
  EXPECT_EQ(message_of([&] { compile(parse_scene("s.json", whole)); }), "");
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const std::string message = message_of([&] { compile(parse_scene("s.json", whole.substr(0, length))); });
    EXPECT_TRUE(message.starts_with("s.json:1: ")) << length << ": " << message;
  }
}

TEST(BrokenFiles, MoreFacesThanNumbersAreRefused) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 65535; ++i) text += "f 1 2 3\n";
  EXPECT_EQ(parse_obj("big.obj", text).faces.size(), 65535u);
  EXPECT_EQ(message_of([&] { parse_obj("big.obj", text + "f 1 2 3\n"); }),
            "big.obj:65539: more than 65535 faces in one mesh");
}

TEST(BrokenFiles, MoreFacesInAllInstancesAreRefused) {
  std::string text = R"({"meshes":[{"name":"m","vertices":[[0,0,0],[1,0,0],[1,1,0]],"faces":[)";
  for (int i = 0; i < 40000; ++i) text += i == 0 ? "[0,1,2]" : ",[0,1,2]";
  text += R"(]}],"instances":[{"mesh":"m"},{"mesh":"m"}]})";
  EXPECT_EQ(message_of([&] { compile(parse_scene("s.json", text)); }),
            "s.json: the instances have 80000 faces, a scene holds at most 65535");
}

}  // namespace
}  // namespace spanline::host
