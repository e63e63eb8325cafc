#include "sim/stats_json.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>

namespace spanline::host {
namespace {

// Appends the edges of one ring, each as (lower vertex, higher vertex).
void add_ring(const MeshSource& mesh, std::size_t first, std::size_t count,
              std::set<std::pair<std::int32_t, std::int32_t>>& edges) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t a = mesh.corners[first + i].position;
    const std::int32_t b = mesh.corners[first + (i + 1) % count].position;
    edges.insert(std::minmax(a, b));
  }
}

// The sides of patches: two share one where they share its four control points, in either direction.
std::size_t distinct_sides(const MeshSource& mesh) {
  constexpr std::size_t kSides[4][4] = {{0, 1, 2, 3}, {12, 13, 14, 15}, {0, 4, 8, 12}, {3, 7, 11, 15}};
  std::set<std::array<std::int32_t, 4>> sides;
  for (const MeshFace& face : mesh.faces) {
    for (const auto& corners : kSides) {
      std::array<std::int32_t, 4> side, back;
      for (std::size_t i = 0; i < 4; ++i) {
        side[i] = back[3 - i] = mesh.corners[face.first_corner + corners[i]].position;
      }
      sides.insert(std::min(side, back));
    }
  }
  return sides.size();
}

std::size_t distinct_edges(const MeshSource& mesh) {
  if (mesh.of_patches()) return distinct_sides(mesh);
  std::set<std::pair<std::int32_t, std::int32_t>> edges;
  for (const MeshFace& face : mesh.faces) {
    if (face.ring_count == 1) {
      add_ring(mesh, face.first_corner, face.corner_count, edges);
      continue;
    }
    std::size_t first = face.first_corner;
    for (std::uint32_t i = 0; i < face.ring_count; ++i) {
      const std::size_t count = mesh.rings[face.first_ring + i];
      add_ring(mesh, first, count, edges);
      first += count;
    }
  }
  return edges.size();
}

// Pixels that show a patch.
std::size_t patch_pixels(const SceneCounts& counts, const Rendering& rendering) {
  return static_cast<std::size_t>(std::count_if(rendering.ids.begin(), rendering.ids.end(),
                                                [&](std::uint32_t id) { return id != 0 && counts.is_patch[id - 1]; }));
}

double ratio(double part, double whole) { return whole == 0 ? 0 : part / whole; }

}  // namespace

SceneCounts count_scene(const SceneDescription& scene) {
  std::vector<std::size_t> edges;
  for (const MeshSource& mesh : scene.meshes) edges.push_back(distinct_edges(mesh));
  SceneCounts counts;
  for (const InstanceSpec& instance : scene.instances) {
    const MeshSource& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
    counts.is_patch.insert(counts.is_patch.end(), mesh.faces.size(), mesh.of_patches());
    if (instance.hidden) continue;
    counts.polygons += mesh.faces.size();
    counts.edges += edges[static_cast<std::size_t>(instance.mesh)];
  }
  return counts;
}

std::string stats_json(const SceneCounts& counts, const Rendering& rendering, const PoolSizes& pools) {
  const Statistics& s = rendering.statistics;
  nlohmann::ordered_json out;
  out["polygons"] = counts.polygons;
  out["edges"] = counts.edges;
  out["edge_crossings"] = s.edge_crossings;
  out["implied_edges"] = s.implied_edges;
  out["output_segments"] = s.output_segments;
  out["segment_blocks"] = s.segment_blocks;
  out["max_segment_blocks"] = s.max_segments;
  out["segment_references"] = s.segment_references;
  out["reference_ratio"] = ratio(s.segment_references, s.edge_crossings);
  out["comparator_cycles"] = s.comparator_cycles;
  out["cycles_per_test"] = ratio(s.comparator_cycles, s.depth_tests);
  out["not_appended_percent"] = 100 * ratio(s.searched_back, double(s.appended) + s.searched_back);
  out["fifo_segments"] = fifo_segments(rendering.lines);
  const auto pool = [&](const char* name, std::uint16_t capacity, std::uint32_t most) {
    out["pools"][name] = {{"capacity", capacity}, {"high_water", most}};
  };
  pool("facets", pools.facets, s.max_facets);
  pool("edges", pools.edges, s.max_edges);
  pool("polygons", pools.polygons, s.max_polygons);
  pool("segments", pools.segments, s.max_segments);
  pool("samples", pools.samples, s.max_samples);
  pool("implied", pools.implied, s.max_implied);
  pool("layers", pools.layers, s.max_layers);
  pool("vertices", pools.vertices, s.max_vertices);
  out["bands"] = s.bands;
  if (std::find(counts.is_patch.begin(), counts.is_patch.end(), true) != counts.is_patch.end()) {
    pool("patch_facets", pools.patch_facets, s.max_patch_facets);
    pool("patch_vertices", pools.patch_vertices, s.max_patch_vertices);
    const std::size_t pixels = patch_pixels(counts, rendering);
    out["points_emitted"] = s.points_emitted;
    out["distinct_pixels"] = pixels;
    out["redundancy"] = ratio(s.points_emitted, static_cast<double>(pixels));
  }
  return out.dump(2) + "\n";
}

}  // namespace spanline::host
