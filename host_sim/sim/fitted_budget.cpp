#include "sim/fitted_budget.hpp"

#include <algorithm>
#include <bit>
#include <set>

#include "assetc/input_error.hpp"
#include "core/frame/frame_impl.hpp"
#include "sim/engine.hpp"
#include "sim/status_text.hpp"

namespace spanline::host {
namespace {

void raise(std::uint16_t& capacity, std::uint32_t need) {
  capacity = static_cast<std::uint16_t>(std::max<std::uint32_t>(capacity, need));
}

void widen(Budget& budget, const Statistics& need) {
  raise(budget.facets, need.max_facets);
  raise(budget.vertices, need.max_vertices);
  raise(budget.polygons, need.max_polygons);
  raise(budget.edges, need.max_edges);
  raise(budget.segments, need.max_segments);
  raise(budget.active, need.max_active);
  raise(budget.samples, need.max_samples);
  raise(budget.implied, need.max_implied);
  raise(budget.layers, need.max_layers);
  raise(budget.patch_facets, need.max_patch_facets);
  raise(budget.patch_vertices, need.max_patch_vertices);
}

bool has_gouraud(const CompiledScene& scene) {
  const auto& all = scene.materials();
  return std::any_of(all.begin(), all.end(), [](const MaterialRecord& m) { return m.shading == Shading::kGouraud; });
}

}  // namespace

Budget fitted_budget(CompiledScene& scene, std::int64_t first, std::int64_t last, std::uint16_t point_lines) {
  const SceneDescription& description = scene.description();
  Budget budget{.width = description.width, .height = description.height};
  budget.facets = budget.polygons = budget.segments = budget.active = 1;  // these cannot be empty
  budget.vertices = budget.edges = budget.samples = budget.implied = 0;
  budget.gouraud = has_gouraud(scene);
  budget.point_lines = point_lines;

  EngineOptions options;
  if (point_lines != 0) options.surface = Surface::points;
  options.pools.point_lines = point_lines;
  options.width = budget.width;
  options.height = budget.height;
  options.observe = true;
  const std::unique_ptr<Engine> engine = Engine::make(options);
  Rendering rendering;
  for (std::int64_t frame = first; frame <= last; ++frame) {
    scene.show(frame);
    const SceneRecord record = scene.record();
    Status status = engine->render(validated(record, description.place), scene.camera(), rendering);
    if (status.ok()) status = rendering.status;
    if (!status.ok()) throw InputError(description.place, status_text(status));
    widen(budget, rendering.statistics);
  }
  return budget;
}

namespace {

constexpr std::uint32_t kPadding = 16;  // between pools, at most

constexpr FrameOptions kOfMeshes{.statistics = true, .walker = Walker::edges};
constexpr FrameOptions kPlain{.walker = Walker::edges, .paint = Paint::flat_words, .plain = true};
constexpr FrameOptions kPlainSmooth{.walker = Walker::edges, .paint = Paint::smooth_words, .plain = true};
constexpr FrameOptions kOfBands{.statistics = true, .walker = Walker::edges, .bands = true};
constexpr FrameOptions kOfPatches{.statistics = true, .patches = true, .walker = Walker::edges};

// What the frame needs; nothing where it is not for the edge walker.
template <FrameOptions kOptions>
std::optional<Statistics> needs_of_frame(const SceneView& view, const CameraRecord& camera, const Screen& screen) {
  HostMemory memory(screen, screen.height, {.band_vertices = kOptions.bands ? BandVertices::kMost : std::uint16_t{0}});
  Frame<kOptions> frame(memory.storage());
  if (frame.prepare(view, camera, {0, screen.height}).empty()) return std::nullopt;
  std::vector<std::uint32_t> line(frame.line_bytes() / sizeof(std::uint32_t) + 1);
  while (frame.next_line({reinterpret_cast<std::uint8_t*>(line.data()), frame.line_bytes()})) {
  }
  if (!frame.status().ok()) return std::nullopt;
  return frame.statistics();
}

// Whether a frame of plain scenes takes it: kOptions are of one.
template <FrameOptions kOptions>
bool is_plain(const SceneView& view, const CameraRecord& camera, const Screen& screen) {
  constexpr bool kSmooth = kOptions.paint == Paint::smooth_words;
  HostMemory memory(screen, screen.height, {.gouraud = kSmooth});
  Frame<kOptions> frame(memory.storage());
  return !frame.prepare(view, camera, {0, screen.height}).empty();
}

// The materials whose faces are smooth, each of which has a table.
std::size_t smooth_materials(const SceneRecord& scene) {
  std::set<std::uint16_t> found;
  for (const InstanceRecord& instance : scene.instances) {
    for (const FaceGroup& group : scene.meshes[instance.mesh].groups) {
      const bool own = instance.material == InstanceRecord::kOwnMaterials;
      const std::uint16_t material = own ? group.material : instance.material;
      if (scene.materials[material].shading == MaterialRecord::kGouraud) found.insert(material);
    }
  }
  return found.size();
}

// Caches are of powers of two less one.
std::uint16_t cache_for(std::size_t things, std::size_t most) {
  return static_cast<std::uint16_t>(std::min(std::bit_ceil(things + 1), most + 1) - 1);
}

}  // namespace

std::optional<Budget> fitted_edge_budget(CompiledScene& scene, std::int64_t first, std::int64_t last) {
  const SceneDescription& description = scene.description();
  const Screen screen{description.width, description.height};
  std::uint32_t edges = 0, grid = 0;
  std::size_t materials = 1;
  bool plain = true;
  SceneView view;
  for (std::int64_t number = first; number <= last; ++number) {
    scene.show(number);
    const SceneRecord record = scene.record();
    view = validated(record, description.place);
    materials = std::max(materials, smooth_materials(record));
    const auto needed = view.has_patches() ? needs_of_frame<kOfPatches>(view, scene.camera(), screen)
                                           : needs_of_frame<kOfMeshes>(view, scene.camera(), screen);
    if (!needed) return std::nullopt;
    plain = plain && (has_gouraud(scene) ? is_plain<kPlainSmooth>(view, scene.camera(), screen)
                                         : is_plain<kPlain>(view, scene.camera(), screen));
    edges = std::max(edges, needed->max_edges);
    grid = std::max(grid, needed->max_patch_grid);
  }
  constexpr std::size_t kMostPlanes = 15, kMostLooks = 103, kMostTables = 15;
  Budget budget{.width = screen.width, .height = screen.height};
  budget.walker = Walker::edges;
  if (view.has_patches()) {
    budget.facets = budget.vertices = 0;
    budget.patch_grid = static_cast<std::uint16_t>(grid);
  } else {
    budget.facets = static_cast<std::uint16_t>(view.face_count());
    budget.vertices = static_cast<std::uint16_t>(view.vertex_count());
  }
  budget.edges = static_cast<std::uint16_t>(edges);
  budget.gouraud = has_gouraud(scene);
  budget.plain = plain && !view.has_patches();
  // Of closed meshes half the faces are seen; where they are few, all may pierce others, of many most do not.
  budget.planes = cache_for(view.face_count() / 2, kMostPlanes);
  budget.looks = static_cast<std::uint16_t>(view.has_patches() ? kMostLooks
                                                               : std::min<std::size_t>(view.face_count(), kMostLooks));
  budget.tables = cache_for(materials - 1, kMostTables);
  return budget;
}

namespace {

constexpr std::size_t kPlaneBytes = sizeof(CachedPlane) + PlaneCache::kReachesPerPlane * sizeof(DepthReach);

// On any board: three rows of ClipRow make the difference.
constexpr std::size_t kInstanceBytes = 156;

// What BandPools and SmoothPools take of it whatever its band_vertices and looks are.
std::size_t band_bytes(const Budget& b) {
  const std::size_t smooth = b.gouraud ? (b.tables + 1u) * sizeof(ColorTable) + LookChains::heads_for(b.facets) : 1;
  return (BitPool::words_for(b.facets) + 1u) * sizeof(std::uint32_t) + (b.vertices + 1u) + (b.band_lines + 1u) +
         (b.edges + 1u) * sizeof(ActiveEdge) + (b.planes + 1u) * kPlaneBytes +
         (b.band_instances + 1u) * kInstanceBytes + smooth + kPadding;
}

}  // namespace

std::uint32_t whole_bytes(const Budget& b) {
  const std::size_t vertex = sizeof(ScreenXY) + sizeof(std::uint16_t) + (b.gouraud ? sizeof(Brightness) : 0);
  const std::size_t face = b.gouraud ? sizeof(std::uint8_t) : sizeof(std::uint16_t);
  const std::size_t smooth = b.gouraud ? (b.looks + 1u) * sizeof(FaceLook) + (b.tables + 1u) * sizeof(ColorTable) : 0;
  const std::size_t bytes = (b.vertices + 1u) * vertex + (b.facets + 1u) * face +
                            (b.height + 1u) * sizeof(std::uint16_t) + 2 * (b.edges + 1u) * sizeof(ActiveEdge) +
                            (b.planes + 1u) * kPlaneBytes + smooth + kPadding;
  return static_cast<std::uint32_t>(bytes);
}

std::optional<Budget> shrunk_budget(CompiledScene& scene, std::int64_t first, std::int64_t last, const Budget& fitted,
                                    std::uint32_t bytes) {
  if (whole_bytes(fitted) <= bytes) return fitted;
  Budget budget = fitted;
  budget.edges = 0;
  budget.band_instances = scene.record().instances.size() > 1 ? 1 : 0;
  for (std::int64_t number = first; number <= last; ++number) {
    scene.show(number);
    const SceneRecord record = scene.record();
    const auto needed = needs_of_frame<kOfBands>(validated(record, scene.description().place), scene.camera(),
                                                 {fitted.width, fitted.height});
    if (!needed) return std::nullopt;
    raise(budget.edges, needed->max_edges);
  }
  // A byte a line: not more than a small part of them.
  constexpr std::uint32_t kFewestLines = 16, kMostLines = 64;
  const std::uint32_t lines = std::clamp(bytes / 32, kFewestLines, kMostLines);
  budget.band_lines = static_cast<std::uint16_t>(std::min<std::uint32_t>(fitted.height, lines));
  const std::size_t look = fitted.gouraud ? sizeof(FaceLook) + 1 : sizeof(FaceColor);
  // Planes are made anew where faces pierce others or meet them at edges. They yield to vertices where there are few.
  constexpr std::size_t kMostPlanes = 7;
  std::size_t planes = std::min<std::size_t>({std::bit_ceil(budget.edges / 16u) - 1, fitted.planes, kMostPlanes});
  std::size_t left = 0, looks = 0, vertices = 0;
  for (;; planes /= 2) {
    budget.planes = static_cast<std::uint16_t>(planes);
    const std::size_t taken = band_bytes(budget) + sizeof(BandVertex);
    constexpr std::uint32_t kFewestVertices = 4;
    const bool enough = taken + kFewestVertices * sizeof(BandVertex) + look <= bytes;
    if (!enough && planes == 0) return std::nullopt;
    if (!enough) continue;
    left = bytes - taken;
    // A look is made anew more often than a vertex, and takes longer: there are as many as faces on a line, or nearly
    // so.
    const std::size_t most_looks = left * (fitted.gouraud ? 7 : 4) / 8 / look;
    looks = fitted.gouraud ? std::clamp<std::size_t>(most_looks, 2, budget.edges / 2u + 2)
                           : std::bit_floor(std::clamp<std::size_t>(most_looks, 1, 256));
    vertices =
        std::min<std::size_t>({(left - looks * look) / sizeof(BandVertex), fitted.vertices, BandVertices::kMost});
    if (vertices >= budget.edges * 2u / 3 || planes == 0) break;
  }
  budget.looks = static_cast<std::uint16_t>(looks - 1);
  budget.band_vertices = static_cast<std::uint16_t>(vertices);
  std::size_t rest = left - looks * look - vertices * sizeof(BandVertex);
  const std::size_t more_planes = std::bit_floor(planes + 1 + rest / kPlaneBytes) - 1;
  budget.planes = static_cast<std::uint16_t>(std::min<std::size_t>(more_planes, fitted.planes));
  rest -= (budget.planes - planes) * kPlaneBytes;
  // With more room edges are moved less often.
  budget.edges =
      static_cast<std::uint16_t>(budget.edges + std::min<std::size_t>(rest / sizeof(ActiveEdge), budget.edges));
  return budget;
}

std::string emit_budget(const Budget& budget, const std::string& name, const std::string& frames) {
  std::string text = "// Fitted to " + frames + ": ";
  text += budget.band_vertices == 0 ? "one band, every vertex projected once." : "in bands, for want of memory.";
  text += "\n#pragma once\n\n";
  text += "#include \"core/frame/budget.hpp\"\n\nnamespace " + name + " {\n\n";
  text += "inline constexpr spanline::Budget kBudget{\n";
  const auto field = [&](const char* key, std::uint16_t value) {
    text += std::string("    .") + key + " = " + std::to_string(value) + ",\n";
  };
  field("width", budget.width);
  field("height", budget.height);
  if (budget.band_vertices != 0) field("band_lines", budget.band_lines);
  field("facets", budget.facets);
  field("vertices", budget.vertices);
  const auto gouraud = [&] { text += std::string("    .gouraud = ") + (budget.gouraud ? "true" : "false"); };
  if (budget.walker == Walker::edges) {
    field("edges", budget.edges);
    field("patch_grid", budget.patch_grid);
    gouraud();
    text += ",\n    .walker = spanline::Walker::edges,\n";
    if (budget.band_vertices != 0) {
      field("band_vertices", budget.band_vertices);
      field("band_instances", budget.band_instances);
    }
    field("looks", budget.looks);
    field("tables", budget.tables);
    text += "    .planes = " + std::to_string(budget.planes);
    if (budget.plain) text += ",\n    .plain = true";
  } else {
    field("polygons", budget.polygons);
    field("edges", budget.edges);
    field("segments", budget.segments);
    field("active", budget.active);
    field("samples", budget.samples);
    field("implied", budget.implied);
    field("patch_facets", budget.patch_facets);
    field("patch_vertices", budget.patch_vertices);
    field("point_lines", budget.point_lines);
    field("layers", budget.layers);
    gouraud();
  }
  text += "};\n\n}  // namespace " + name + "\n";
  return text;
}

}  // namespace spanline::host
