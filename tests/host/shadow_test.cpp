// Baked shadows against a shadow ray for every pixel, in doubles, on the scene without any.
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

#include "assetc/compile.hpp"
#include "assetc/face_plane.hpp"
#include "assetc/polygon.hpp"
#include "assetc/scene_json.hpp"
#include "host/support.hpp"
#include "oracle/random.hpp"
#include "sim/engine.hpp"
#include "sim/status_text.hpp"

namespace spanline::host {
namespace {

struct Surface {
  std::vector<Ring3> rings;  // world
  Vec3 normal;               // unit length, outward
  MaterialSpec material;
  bool two_sided;
  std::vector<Surface> detail;  // the last on top
};

// A scene as rays see it.
class Rays {
 public:
  explicit Rays(const SceneDescription& scene) : scene_(scene) {
    for (const InstanceSpec& instance : scene.instances) add(instance);
    for (const LightSpec& light : *scene.lights) lights_.push_back({unit_or(light.direction, {}), light.intensity});
  }

  // What a ray from `eye` meets: a surface and what on it, and how light falls there; all of it in a few numbers, so
  // that rays may be compared.
  struct Look {
    const Surface* surface = nullptr;  // null: the background
    const Surface* shown = nullptr;
    std::vector<Vec3> light;  // of each light, what part comes here
    friend bool operator==(const Look& a, const Look& b) {
      if (a.shown != b.shown || a.light.size() != b.light.size()) return false;
      for (std::size_t i = 0; i < a.light.size(); ++i) {
        if (largest(a.light[i] - b.light[i]) > 1e-6) return false;
      }
      return true;
    }
  };

  // The stack of looks that a ray meets, down to the first opaque one.
  std::vector<Look> looks(Vec3 eye, Vec3 way) const {
    std::vector<std::pair<double, const Surface*>> hits;
    for (const Surface& surface : surfaces_) {
      if (!surface.two_sided && dot(surface.normal, way) >= 0) continue;
      if (const double t = distance(surface, eye, way); t > 0) hits.emplace_back(t, &surface);
    }
    std::sort(hits.begin(), hits.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Look> all;
    for (const auto& [t, surface] : hits) {
      const Vec3 place = eye + t * way;
      Look look{surface, surface, {}};
      for (const Surface& detail : surface->detail) {
        if (covers(detail, place)) look.shown = &detail;
      }
      const Vec3 facing = dot(surface->normal, way) < 0 ? surface->normal : -1.0 * surface->normal;
      for (const LightSpec& light : lights_) look.light.push_back(reach(*surface, facing, place, light.direction));
      all.push_back(look);
      if (look.shown->material.transmission == Color{}) break;
    }
    return all;
  }

  Vec3 color(const std::vector<Look>& looks, Vec3 way, Vec3 background) const {
    Vec3 result = background;
    for (std::size_t i = looks.size(); i-- > 0;) {
      const Look& look = looks[i];
      const Color c = look.shown->material.color, t = look.shown->material.transmission;
      const Vec3 facing = dot(look.surface->normal, way) < 0 ? look.surface->normal : -1.0 * look.surface->normal;
      Vec3 light = scene_.ambient;
      for (std::size_t l = 0; l < lights_.size(); ++l) {
        const double amount = std::max(0.0, -dot(facing, lights_[l].direction));
        const Vec3 part = look.light[l], full = lights_[l].intensity;
        light = light + amount * Vec3{part.x * full.x, part.y * full.y, part.z * full.z};
      }
      if (look.shown->material.shading == Shading::kUnlit) light = {1, 1, 1};
      const auto channel = [](double own, double lit, double through, double behind) {
        return std::min(255.0, own * lit) * (1 - through / 255) + behind * through / 255;
      };
      result = {channel(c.r, light.x, t.r, result.x), channel(c.g, light.y, t.g, result.y),
                channel(c.b, light.z, t.b, result.z)};
    }
    return result;
  }

 private:
  void add(const InstanceSpec& instance) {
    const Placement place = instance.placement(0);
    const MeshSource& mesh = scene_.meshes[static_cast<std::size_t>(instance.mesh)];
    const std::size_t first_detail = mesh.faces.size() - mesh.parents.size(), first = surfaces_.size();
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
      const MeshFace& face = mesh.faces[f];
      Surface surface{rings_of(mesh, face), {}, {}, !instance.cull, {}};
      for (Ring3& ring : surface.rings) {
        for (Vec3& p : ring) p = place(p);
      }
      surface.normal = unit_or(place.turn(newell_normal(mesh, face)), {});  // instances only turn and scale evenly
      const std::int32_t material = instance.material == kNone ? face.material : instance.material;
      if (material != kNone) surface.material = scene_.materials[static_cast<std::size_t>(material)];
      if (f < first_detail) {
        surfaces_.push_back(surface);
      } else {
        surfaces_[first + mesh.parents[f - first_detail]].detail.push_back(surface);
      }
    }
  }

  static bool covers(const Surface& surface, Vec3 p) {
    const Vec3 n = surface.normal;
    const double x = std::fabs(n.x), y = std::fabs(n.y), z = std::fabs(n.z);
    const auto flat = [&](Vec3 v) {
      if (x >= y && x >= z) return std::pair(v.y, v.z);
      return y >= z ? std::pair(v.z, v.x) : std::pair(v.x, v.y);
    };
    const auto [u, v] = flat(p);
    bool inside = false;
    for (const Ring3& ring : surface.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto [ua, va] = flat(ring[i]);
        const auto [ub, vb] = flat(ring[(i + 1) % ring.size()]);
        if ((va > v) != (vb > v) && u < ua + (ub - ua) * (v - va) / (vb - va)) inside = !inside;
      }
    }
    return inside;
  }

  // Along the ray; 0 where it misses.
  static double distance(const Surface& surface, Vec3 from, Vec3 way) {
    const double slope = dot(surface.normal, way);
    if (slope == 0) return 0;
    const double t = dot(surface.normal, surface.rings[0][0] - from) / slope;
    return t > 0 && covers(surface, from + t * way) ? t : 0;
  }

  // What part of a light comes to a place; a side that the light falls behind of gets none anyway.
  Vec3 reach(const Surface& surface, Vec3 facing, Vec3 place, Vec3 direction) const {
    Vec3 part{1, 1, 1};
    if (dot(facing, direction) >= 0) return part;
    for (const Surface& other : surfaces_) {
      if (&other == &surface || distance(other, place, -1.0 * direction) < 1e-6) continue;
      const Color t = other.material.transmission;
      part = {part.x * t.r / 255, part.y * t.g / 255, part.z * t.b / 255};
    }
    return part;
  }

  const SceneDescription& scene_;
  std::vector<Surface> surfaces_;
  std::vector<LightSpec> lights_;
};

// The engine's picture of the baked scene, and where rays through a pixel's centre and round about agree that no edge
// is near, what they say of it. How many pixels lie in a shadow, once for each light.
int pixels_in_shadow(SceneDescription description, int width, int height, double most_near_edges) {
  description.width = static_cast<std::uint16_t>(width);
  description.height = static_cast<std::uint16_t>(height);
  const Rays rays(description);
  CompiledScene scene = compile(description);
  EngineOptions options;
  options.width = description.width;
  options.height = description.height;
  Rendering out;
  const SceneRecord record = scene.record();
  const Status status = Engine::make(options)->render(validated(record, description.place), scene.camera(), out);
  EXPECT_TRUE(status.ok()) << status_text(status);

  const View& view = scene.view();
  const Axes axes = axes_of(view);
  const double focal = options.height / 2.0 / std::tan(radians(view.fov / 2));
  const auto way = [&](double x, double y) {
    return (x - options.width / 2.0) * axes.right + (options.height / 2.0 - y) * axes.up - focal * axes.back;
  };
  int near_edges = 0, shaded = 0, wrong = 0;
  for (int y = 0; y < options.height; ++y) {
    for (int x = 0; x < options.width; ++x) {
      const Vec3 middle = way(x + 0.5, y + 0.5);
      const std::vector<Rays::Look> looks = rays.looks(view.eye, middle);
      if (looks.empty()) continue;
      // Whether all of so many rays a side, within a quarter of a pixel of its centre, meet the same.
      const auto all_alike = [&](int rays_a_side) {
        for (int i = 0; i < rays_a_side * rays_a_side; ++i) {
          const auto off = [&](int k) { return 0.5 * k / (rays_a_side - 1) - 0.25; };
          if (looks != rays.looks(view.eye, way(x + 0.5 + off(i % rays_a_side), y + 0.5 + off(i / rays_a_side)))) {
            return false;
          }
        }
        return true;
      };
      if (!all_alike(2)) {
        ++near_edges;
        continue;
      }
      for (const Vec3& light : looks.back().light) shaded += light != Vec3{1, 1, 1} ? 1 : 0;
      const auto background = [&](std::uint8_t top, std::uint8_t bottom) {
        return top + (bottom - top) * double{1} * y / (options.height - 1);
      };
      const BackgroundRecord& b = description.background;
      const Vec3 expected = rays.color(
          looks, middle,
          {background(b.top.r, b.bottom.r), background(b.top.g, b.bottom.g), background(b.top.b, b.bottom.b)});
      const std::uint8_t* drawn = &out.picture.rgb[3 * static_cast<std::size_t>(y * options.width + x)];
      constexpr double kStep = 9;  // RGB565 has steps of 8
      if (std::fabs(drawn[0] - expected.x) > kStep || std::fabs(drawn[1] - expected.y) > kStep ||
          std::fabs(drawn[2] - expected.z) > kStep) {
        if (!all_alike(9)) continue;  // a corner reaches in between those four
        if (++wrong < 5) {
          ADD_FAILURE() << "column " << x << ", line " << y << ": drawn " << +drawn[0] << " " << +drawn[1] << " "
                        << +drawn[2] << ", expected " << expected.x << " " << expected.y << " " << expected.z;
        }
      }
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_LT(near_edges, most_near_edges * options.width * options.height);
  return shaded;
}

void expect_shadows_of_rays(const std::string& path) {
  SCOPED_TRACE(path);
  EXPECT_GT(pixels_in_shadow(read_scene(path), 320, 240, 0.06), 2000);
}

TEST(Shadows, OfTheDiceAreThoseOfRays) { expect_shadows_of_rays(SPANLINE_ASSETS "/demos/dice.json"); }
TEST(Shadows, OfTheHouseAreThoseOfRays) { expect_shadows_of_rays(SPANLINE_ASSETS "/demos/house.json"); }
TEST(Shadows, OfColouredPanesAreThoseOfRays) { expect_shadows_of_rays(SPANLINE_ASSETS "/demos/panes.json"); }

// A table, and over it boxes, frames with a hole, and panes, turned any way; they may pierce one another.
std::string random_scene(std::uint64_t seed) {
  oracle::Random random(seed);
  const auto number = [&](double low, double high) {
    return std::to_string(low + (high - low) * random.between(0, 10000) / 10000);
  };
  const auto triple = [&](double low, double high) {
    return "[" + number(low, high) + "," + number(low, high) + "," + number(low, high) + "]";
  };
  std::string materials, instances = R"({"mesh":"table"})";
  const auto add = [&](const char* mesh, const std::string& more) {
    instances += std::string(R"(,{"mesh":")") + mesh + R"(","rotate":)" + triple(0, 360) + R"(,"scale":)" +
                 number(0.3, 1) + R"(,"translate":[)" + number(-2, 2) + "," + number(0, 2.5) + "," + number(-2, 2) +
                 "]" + more + "}";
  };
  for (int i = 0; i < 4; ++i) add("box", "");
  for (int i = 0; i < 3; ++i) add("frame", R"(,"cull":false)");
  for (int i = 0; i < 4; ++i) {
    const std::string name = "glass" + std::to_string(i);
    materials += R"(,{"name":")" + name + R"(","color":[40,60,80],"transmission":)" + triple(0.2, 0.9) + "}";
    add("pane", R"(,"cull":false,"material":")" + name + R"(")");
  }
  std::string lights;
  for (int i = 1 + random.between(0, 2); i > 0; --i) {
    lights += std::string(lights.empty() ? "" : ",") + R"({"direction":[)" + number(-1, 1) + "," + number(-1.5, -0.4) +
              "," + number(-1, 1) + R"(],"intensity":)" + triple(0.3, 0.6) + "}";
  }
  return R"({"camera":{"eye":[3,7,8],"target":[0,0.6,0],"fov":40,"near":3,"far":30},"ambient":[0.15,0.15,0.15],)"
         R"("shadows":true,"lights":[)" +
         lights + R"(],"materials":[{"name":"chalk","color":[210,200,190]})" + materials +
         R"(],"meshes":[)"
         R"({"name":"table","vertices":[[-3.5,0,-3.5],[-3.5,0,3.5],[3.5,0,3.5],[3.5,0,-3.5]],"faces":[[0,1,2,3]]},)"
         R"({"name":"pane","material":"chalk","vertices":[[-1,-1,0],[1,-1,0],[1,1,0],[-1,1,0]],"faces":[[0,1,2,3]]},)"
         R"({"name":"frame","material":"chalk","vertices":[[-1,-1,0],[1,-1,0],[1,1,0],[-1,1,0],)"
         R"([-0.5,-0.6,0],[0.5,-0.5,0],[0.6,0.5,0],[0,0,0]],"faces":[[[0,1,2,3],[7,6,5,4]]]},)"
         R"({"name":"box","material":"chalk","vertices":[[-1,-1,-1],[1,-1,-1],[1,1,-1],[-1,1,-1],[-1,-1,1],[1,-1,1],)"
         R"([1,1,1],[-1,1,1]],"faces":[[3,2,1,0],[4,5,6,7],[0,1,5,4],[1,2,6,5],[2,3,7,6],[3,0,4,7]]}],)"
         R"("instances":[)" +
         instances + "]}";
}

TEST(Shadows, OfRandomScenesAreThoseOfRays) {
  const std::uint64_t scenes = std::getenv("SPANLINE_FULL") != nullptr ? 200 : 12;
  std::uint64_t in_shadow = 0;
  for (std::uint64_t seed = 0; seed < scenes; ++seed) {
    SCOPED_TRACE(seed);
    in_shadow +=
        static_cast<std::uint64_t>(pixels_in_shadow(parse_scene("random", random_scene(seed)), 160, 120, 0.35));
  }
  EXPECT_GT(in_shadow, 500 * scenes);
}

// A table full of boxes. What a light sees is sorted in windows where it has more than 400 faces.
std::string crowd(int boxes) {
  oracle::Random random(3);
  const auto number = [&](double low, double high) {
    return std::to_string(low + (high - low) * random.between(0, 10000) / 10000);
  };
  std::string instances = R"({"mesh":"table"})";
  for (int i = 0; i < boxes; ++i) {
    instances += R"(,{"mesh":"box","rotate":[)" + number(-20, 20) + "," + number(0, 360) + "," + number(-20, 20) +
                 R"(],"scale":[)" + number(0.08, 0.3) + "," + number(0.1, 0.5) + "," + number(0.08, 0.3) +
                 R"(],"translate":[)" + number(-3.2, 3.2) + "," + number(0, 0.5) + "," + number(-3.2, 3.2) + "]}";
  }
  return R"({"camera":{"eye":[3,7,8],"target":[0,0.2,0],"fov":40,"near":3,"far":30},"ambient":[0.15,0.15,0.15],)"
         R"("shadows":true,"lights":[{"direction":[0.5,-1,0.3]},{"direction":[-0.8,-0.7,0.2],"intensity":[0.4,0.4,0.5]}],)"
         R"("materials":[{"name":"chalk","color":[210,200,190]}],"meshes":[)"
         R"({"name":"table","vertices":[[-3.5,0,-3.5],[-3.5,0,3.5],[3.5,0,3.5],[3.5,0,-3.5]],"faces":[[0,1,2,3]]},)"
         R"({"name":"box","material":"chalk","vertices":[[-1,-1,-1],[1,-1,-1],[1,1,-1],[-1,1,-1],[-1,-1,1],[1,-1,1],)"
         R"([1,1,1],[-1,1,1]],"faces":[[3,2,1,0],[4,5,6,7],[0,1,5,4],[1,2,6,5],[2,3,7,6],[3,0,4,7]]}],)"
         R"("instances":[)" +
         instances + "]}";
}

TEST(Shadows, OfManyFacesAreThoseOfRays) {
  EXPECT_GT(pixels_in_shadow(parse_scene("crowd", crowd(90)), 160, 120, 0.35), 1000);
}

const std::string kTable = R"("meshes":[{"name":"table","vertices":[[-4,0,-4],[-4,0,4],[4,0,4],[4,0,-4]],)"
                           R"("faces":[[0,1,2,3]]},{"name":"plate","vertices":[[-1,1,-1],[-1,1,1],[1,1,1],[1,1,-1]],)"
                           R"("faces":[[0,1,2,3]]}],)";
const std::string kDown = R"({"shadows":true,"lights":[{"direction":[0,-1,0]}],)" + kTable;

TEST(Shadows, BecomeDetailOfTheFaceTheyFallOn) {
  const CompiledScene compiled =
      compile(parse_scene("s", kDown + R"("instances":[{"mesh":"table"},{"mesh":"plate"}]})"));
  const SceneRecord record = compiled.record();
  ASSERT_EQ(record.meshes[0].parents.size(), 1u);
  EXPECT_EQ(record.meshes[0].face_count, 2u);
  EXPECT_TRUE(record.meshes[1].parents.empty());
  ASSERT_EQ(record.reaches.size(), 1u);
  EXPECT_EQ(record.reaches[0].light[0], (Rgb8{0, 0, 0}));
}

TEST(Shadows, AreThrownByAndOnWhoTakesPart) {
  const auto detail = [](const std::string& instances) {
    const CompiledScene scene = compile(parse_scene("s", kDown + R"("instances":[)" + instances + "]}"));
    return scene.record().meshes[0].parents.size();
  };
  EXPECT_EQ(detail(R"({"mesh":"table"},{"mesh":"plate"})"), 1u);
  EXPECT_EQ(detail(R"({"mesh":"table","shadows":false},{"mesh":"plate"})"), 0u);
  EXPECT_EQ(detail(R"({"mesh":"table"},{"mesh":"plate","shadows":false})"), 0u);
  EXPECT_EQ(detail(R"({"mesh":"table"},{"mesh":"plate","hidden":true})"), 0u);
  EXPECT_EQ(detail(R"({"mesh":"table"},{"mesh":"plate","translate":[0,-3,0]})"), 0u);  // below it
}

TEST(Shadows, FollowWhatMoves) {
  CompiledScene scene =
      compile(parse_scene("s", kDown + R"("instances":[{"mesh":"table"},{"mesh":"plate","motion":{"keys":[{"frame":0},)"
                                       R"({"frame":10,"translate":[20,0,0]}],"loop":false}}]})"));
  EXPECT_EQ(scene.record().meshes[0].parents.size(), 1u);
  scene.show(10);
  EXPECT_EQ(scene.record().meshes[0].parents.size(), 0u);
  scene.show(0);
  EXPECT_EQ(scene.record().meshes[0].parents.size(), 1u);
}

TEST(Shadows, NeedLights) {
  const std::string text = R"({"shadows":true,)" + kTable + R"("instances":[{"mesh":"table"}]})";
  EXPECT_EQ(message_of([&] { compile(parse_scene("s.json", text)); }),
            "s.json: shadows need lights: without 'lights' there is but one that goes with the viewer");
}

}  // namespace
}  // namespace spanline::host
