#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "assetc/scene_json.hpp"
#include "assetc/text_file.hpp"
#include "core/area/line_drawing.hpp"
#include "hidden/hidden_json.hpp"
#include "hidden/line_drawing.hpp"
#include "host/support.hpp"
#include "oracle/random.hpp"
#include "sim/engine.hpp"
#include "sim/output_file.hpp"
#include "sim/status_text.hpp"

namespace spanline::host {
namespace {

const std::string kScenes = std::string(SPANLINE_ASSETS) + "/scenes/";

CompiledScene flat_scene(const std::string& name) {
  SceneDescription scene = read_scene(kScenes + name);
  for (MaterialSpec& material : scene.materials) {
    if (material.shading == Shading::kGouraud) material.shading = Shading::kFlat;
  }
  return compile(std::move(scene));
}

constexpr const char* kCube = R"({
  "size": [200, 160], "materials": [ { "name": "paint", "color": [220, 90, 60] } ],
  "meshes": [ { "name": "cube", "material": "paint",
    "vertices": [ [-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1] ],
    "faces": [ [3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [2, 3, 7, 6], [1, 2, 6, 5], [0, 4, 7, 3] ] } ],
  "instances": [ { "mesh": "cube" } ] })";

HiddenView view_of(const CompiledScene& scene, std::uint32_t window, area::Panes panes = area::Panes::named) {
  return remove_hidden(FacetList(scene, Facing::as_culled), scene.description(), window, panes);
}

Picture picture_of(const CompiledScene& scene) {
  EngineOptions options;
  options.width = scene.description().width;
  options.height = scene.description().height;
  Rendering rendering;
  const SceneRecord record = scene.record();
  EXPECT_TRUE(Engine::make(options)->render(validated(record, "scene"), scene.camera(), rendering).ok());
  return rendering.picture;
}

double share_that_differs(const Picture& a, const Picture& b) {
  std::size_t differ = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3) differ += !std::equal(&a.rgb[i], &a.rgb[i] + 3, &b.rgb[i]);
  return 3.0 * static_cast<double>(differ) / static_cast<double>(a.rgb.size());
}

// Borders move by up to half of 1/16 px, which shows where a pixel's centre lies that near; and a gap would.
TEST(HiddenVerb, TheOutputIsASceneThatShowsTheSamePicture) {
  for (const char* name : {"S1.json", "clockwork.json", "island.json"}) {
    const CompiledScene scene = flat_scene(name);
    const Picture before = picture_of(scene);
    for (const std::uint32_t window : {0u, 24u}) {
      const FacetList facets(scene, Facing::as_culled);
      const CompiledScene again =
          compile(parse_scene("again", hidden_json(view_of(scene, window, area::Panes::shown), facets, scene)));
      EXPECT_LT(share_that_differs(before, picture_of(again)), 0.0012) << name << " " << window;
    }
  }
}

std::set<std::pair<std::pair<int, int>, std::pair<int, int>>> as_set(const std::vector<Line>& lines) {
  std::set<std::pair<std::pair<int, int>, std::pair<int, int>>> set;
  for (const Line& line : lines) set.insert({{line.from.x, line.from.y}, {line.to.x, line.to.y}});
  return set;
}

// Pips, lines on the cloth, baked shadows of two lights: surface detail.
TEST(HiddenVerb, SurfaceDetailAndShadowsAreInTheOutput) {
  for (const char* name : {"../demos/dice.json", "../demos/house.json"}) {
    const CompiledScene scene = flat_scene(name);
    const FacetList facets(scene, Facing::as_culled);
    EXPECT_LT(facets.hosts(), facets.facets().size()) << "some facets are detail";
    const CompiledScene again =
        compile(parse_scene("again", hidden_json(view_of(scene, 0, area::Panes::shown), facets, scene)));
    EXPECT_LT(share_that_differs(picture_of(scene), picture_of(again)), 0.0008) << name;
  }
}

// Behind the panes and where there is nothing behind them.
TEST(HiddenVerb, SeeThroughFacesColourWhatLiesBehind) {
  const CompiledScene scene = flat_scene("../demos/panes.json");
  const FacetList facets(scene, Facing::as_culled);
  const HiddenView view = view_of(scene, 0);
  std::size_t most = 0;
  bool background = false;
  for (const VisiblePolygon& polygon : view.polygons) {
    most = std::max(most, polygon.films.size());
    background |= polygon.facet == area::kBackdrop && !polygon.films.empty();
    for (const std::uint16_t film : polygon.films) EXPECT_NE(facets[film].transmission, Rgb8{});
  }
  EXPECT_GE(most, 3u);
  EXPECT_TRUE(background);
}

// The output has see-through faces where the input has: what lies behind them, a background that changes from line to
// line too, is seen as there.
TEST(HiddenVerb, SeeThroughFacesAreInTheOutput) {
  const CompiledScene scene = flat_scene("../demos/panes.json");
  const FacetList facets(scene, Facing::as_culled);
  const HiddenView view = view_of(scene, 0, area::Panes::shown);
  for (const VisiblePolygon& polygon : view.polygons) {
    EXPECT_EQ(polygon.transmission, facets[polygon.facet].transmission);
  }
  const CompiledScene again = compile(parse_scene("again", hidden_json(view, facets, scene)));
  EXPECT_LT(share_that_differs(picture_of(scene), picture_of(again)), 0.0008);
}

// A red door behind a pane with a hole in it; on the pane a film that reaches past its outline, and on the film a
// label.
constexpr const char* kWindow = R"({
  "size": [200, 160], "background": { "top": [20, 30, 60], "bottom": [90, 90, 120] },
  "camera": { "eye": [0.7, 0.4, 5], "target": [0, 0, 0], "fov": 35, "near": 2, "far": 20 },
  "materials": [ { "name": "red", "color": [200, 40, 30], "shading": "unlit" },
                 { "name": "label", "color": [240, 240, 200], "shading": "unlit" },
                 { "name": "glass", "color": [40, 160, 90], "shading": "unlit", "transmission": [0.5, 0.9, 0.6] },
                 { "name": "film", "color": [30, 60, 200], "shading": "unlit", "transmission": [0.3, 0.3, 0.8] } ],
  "meshes": [
    { "name": "door", "material": "red", "vertices": [ [-1, -0.8, -1], [0.8, -0.8, -1], [0.8, 0.9, -1], [-1, 0.9, -1] ],
      "faces": [ [0, 1, 2, 3] ] },
    { "name": "pane", "material": "glass",
      "vertices": [ [-1.1, -1, 0.3], [1.1, -1, 0], [1.1, 1, 0], [-1.1, 1, 0.3],
                    [0.1, -0.6, 0.136], [0.7, -0.6, 0.055], [0.7, -0.1, 0.055], [0.1, -0.1, 0.136],
                    [-0.5, -0.4, 0.218], [1.3, -0.2, -0.027], [1.2, 0.7, -0.013], [-0.4, 0.6, 0.205],
                    [-0.2, 0.1, 0.177], [0.3, -0.3, 0.109], [0.5, 0.4, 0.082] ],
      "faces": [ [ [0, 1, 2, 3], [4, 7, 6, 5] ] ],
      "detail": [ { "on": 0, "material": "film", "faces": [ [8, 9, 10, 11] ] },
                  { "on": 0, "material": "label", "faces": [ [12, 13, 14] ] } ] } ],
  "instances": [ { "mesh": "door" }, { "mesh": "pane", "cull": false } ] })";

TEST(HiddenVerb, DetailOfSeeThroughFacesTakesTheirPlace) {
  const CompiledScene scene = compile(parse_scene("window", kWindow));
  const FacetList facets(scene, Facing::as_culled);
  const HiddenView shown = view_of(scene, 0, area::Panes::shown), named = view_of(scene, 0);
  const CompiledScene again = compile(parse_scene("again", hidden_json(shown, facets, scene)));
  EXPECT_LT(share_that_differs(picture_of(scene), picture_of(again)), 0.0008);
  std::set<std::uint32_t> sources, films;
  for (const VisiblePolygon& polygon : shown.polygons) sources.insert(facets[polygon.facet].face);
  EXPECT_EQ(sources, (std::set<std::uint32_t>{0, 1, 2, 3}));
  for (const VisiblePolygon& polygon : named.polygons) {
    for (const std::uint16_t film : polygon.films) films.insert(facets[film].face);
    const bool label = polygon.facet != area::kBackdrop && facets[polygon.facet].face == 3;
    EXPECT_TRUE(!label || polygon.films.empty()) << "nothing lies before the label";
  }
  EXPECT_EQ(films, (std::set<std::uint32_t>{1, 2}));
}

TEST(HiddenVerb, WhereNothingIsVisibleTheOutputIsASceneStill) {
  std::string text = kCube;
  text.replace(
      text.find("200, 160"), 8,
      R"(40, 30], "camera": { "eye": [0, 0, 5], "target": [0, 0, 9], "near": 1, "far": 9 }, "ambient": [1, 1, 1)");
  const CompiledScene scene = compile(parse_scene("cube", text));
  const FacetList facets(scene, Facing::as_culled);
  const HiddenView view = view_of(scene, 0, area::Panes::shown);
  EXPECT_TRUE(view.polygons.empty());
  const CompiledScene again = compile(parse_scene("again", hidden_json(view, facets, scene)));
  EXPECT_EQ(share_that_differs(picture_of(scene), picture_of(again)), 0);
}

// A town of 64 towers, of which no two touch.
std::string town() {
  oracle::Random random(7);
  std::string towers;
  for (int i = 0; i < 64; ++i) {
    const auto number = [&](int low, int high) { return std::to_string(random.between(low, high) / 100.0); };
    const std::string wide = number(20, 45), high = number(40, 300), deep = number(20, 45);
    towers += std::string(i == 0 ? "" : ",") + R"({"mesh":"tower","matrix":[)" + wide + ",0,0," +
              std::to_string(i % 8) + ",0," + high + ",0," + high + ",0,0," + deep + "," + std::to_string(i / 8) + "]}";
  }
  return R"({"camera":{"eye":[12,7,14],"target":[3.5,0.6,3.5],"fov":45,"near":2,"far":40},)"
         R"("materials":[{"name":"brick","color":[190,120,90]}],"meshes":[{"name":"tower","material":"brick",)"
         R"("vertices":[[-1,-1,-1],[1,-1,-1],[1,1,-1],[-1,1,-1],[-1,-1,1],[1,-1,1],[1,1,1],[-1,1,1]],)"
         R"("faces":[[3,2,1,0],[4,5,6,7],[0,1,5,4],[1,2,6,5],[2,3,7,6],[3,0,4,7]]}],"instances":[)" +
         towers + "]}";
}

// What docs/hidden.md says of a town.
TEST(HiddenVerb, SolidsGoIntoTheSortWhole) {
  const CompiledScene scene = compile(parse_scene("town", town()));
  const FacetList each(scene, Facing::as_culled, Solids::face_by_face), whole(scene, Facing::as_culled);
  EXPECT_EQ(whole.count(), 64u);
  EXPECT_EQ(each.count(), each.hosts());
  const HiddenView by_face = remove_hidden(each, scene.description(), 0, area::Panes::shown),
                   by_solid = remove_hidden(whole, scene.description(), 0, area::Panes::shown);
  EXPECT_LT(3 * by_solid.clips, 2 * by_face.clips) << by_solid.clips << " " << by_face.clips;
  const CompiledScene again = compile(parse_scene("again", hidden_json(by_solid, whole, scene)));
  EXPECT_LT(share_that_differs(picture_of(scene), picture_of(again)), 0.0012);
}

TEST(HiddenVerb, WhatIsNotConvexOrIsSeenFromBothSidesGoesFaceByFace) {
  const auto units = [](const std::string& instance) {
    std::string text = kCube;
    const std::string plain = R"({ "mesh": "cube" })";
    const std::size_t at = text.find(plain);
    if (at != std::string::npos) text.replace(at, plain.size(), instance);
    const CompiledScene scene = compile(parse_scene("cube", text));
    return FacetList(scene, Facing::as_culled).count();
  };
  EXPECT_EQ(units(R"({"mesh":"cube"})"), 1u);
  EXPECT_EQ(units(R"({"mesh":"cube","cull":false})"), 6u);
  const CompiledScene gears = flat_scene("clockwork.json");
  EXPECT_EQ(FacetList(gears, Facing::as_culled).count(), FacetList(gears, Facing::as_culled).hosts());
}

TEST(HiddenVerb, ACubeHasNineVisibleEdgesAndThreeHiddenOnes) {
  const CompiledScene scene = compile(parse_scene("cube", kCube));
  const std::vector<Line> visible = visible_lines(view_of(scene, 0));
  EXPECT_EQ(visible.size(), 9u);
  EXPECT_EQ(as_set(visible).size(), 9u);
  const SceneDescription& d = scene.description();
  EXPECT_EQ(hidden_lines(FacetList(scene, Facing::all), visible, d.width, d.height).size(), 3u);
}

// What a board draws (core/area/line_drawing.hpp) and what the host does, which has no bounds: the same lines.
TEST(HiddenVerb, TheLinesAreThoseOfABoard) {
  for (const char* name : {"clockwork.json", "../demos/dice.json", "../demos/plot.json"}) {
    for (const std::uint32_t window : {0u, 16u}) {
      const HiddenView view = view_of(flat_scene(name), window);
      std::vector<area::DrawnEdge> edges(40001);
      std::vector<area::GridPoint> corners(40001);
      area::LineDrawing drawing({edges.data(), 40000}, {corners.data(), 40000});
      drawing.clear();
      for (const VisiblePolygon& polygon : view.polygons) {
        for (const auto& ring : polygon.rings) {
          for (std::size_t i = 0; i < ring.size(); ++i) {
            drawing.edge(ring[i].at, ring[(i + 1) % ring.size()].at, polygon.facet);
          }
        }
      }
      ASSERT_TRUE(drawing.solve().ok());
      struct Collect {
        std::vector<Line> lines;
        void line(area::GridPoint from, area::GridPoint to) { lines.push_back({from, to}); }
      } collect;
      drawing.read(collect);
      const std::vector<Line> expected = visible_lines(view);
      EXPECT_EQ(collect.lines.size(), expected.size()) << name;
      EXPECT_EQ(as_set(collect.lines), as_set(expected)) << name;
    }
  }
}

// Lines that share more than a point would be drawn twice.
TEST(HiddenVerb, EveryEdgeIsDrawnOnce) {
  for (const std::uint32_t window : {0u, 16u}) {
    const std::vector<Line> lines = visible_lines(view_of(flat_scene("clockwork.json"), window));
    ASSERT_GT(lines.size(), 500u);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (std::size_t j = i + 1; j < lines.size(); ++j) {
        const Line &a = lines[i], &b = lines[j];
        if (area::orientation(a.from, a.to, b.from) != 0 || area::orientation(a.from, a.to, b.to) != 0) continue;
        const area::GridPoint low = b.from < a.from ? a.from : b.from, high = a.to < b.to ? a.to : b.to;
        ASSERT_FALSE(low < high) << "lines overlap at " << low.x << ", " << low.y;
      }
    }
  }
}

TEST(HiddenVerb, WritesDrawings) {
  const TemporaryFolder folder;
  const std::string svg = folder.file("a.svg"), json = folder.file("a.json"), lines = folder.file("l.svg");
  const std::string cube = folder.file("cube.json");
  write_file(cube, kCube);
  ToolRun run = run_tool({"hidden", cube, "--svg", svg, "--json", json});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(read_file(svg).find("data-source=\"1\""), std::string::npos);
  const auto document = nlohmann::json::parse(read_file(json));
  EXPECT_EQ(document["hidden"]["polygons"].size(), 3u);
  EXPECT_EQ(document["meshes"].size(), 3u);
  run = run_tool({"hidden", cube, "--lines", "--dashed", "--svg", lines});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(read_file(lines).find("stroke-dasharray"), std::string::npos);
  run = run_tool({"render", json, "--out", folder.file("a.ppm")});
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

TEST(HiddenVerb, WrongUsageIsSaid) {
  const TemporaryFolder folder;
  const std::string scene = kScenes + "S1.json", svg = folder.file("a.svg"), json = folder.file("a.json");
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"hidden"},
                                                    {"hidden", scene},
                                                    {"hidden", scene, "--lines", "--json", json},
                                                    {"hidden", scene, "--dashed", "--svg", svg},
                                                    {"hidden", scene, "--svg", svg, "--window", "0"},
                                                    {"hidden", scene, "--svg", svg, "--window", "many"}}) {
    EXPECT_EQ(run_tool(arguments).exit_code, 2);
  }
  EXPECT_EQ(run_tool({"hidden", "absent.json", "--svg", svg}).exit_code, 1);
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace spanline::host
