#include "sim/stats_json.hpp"

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

std::size_t distinct_edges(const MeshSource& mesh) {
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

double ratio(double part, double whole) { return whole == 0 ? 0 : part / whole; }

}  // namespace

SceneCounts count_scene(const SceneDescription& scene) {
  std::vector<std::size_t> edges;
  for (const MeshSource& mesh : scene.meshes) edges.push_back(distinct_edges(mesh));
  SceneCounts counts;
  for (const InstanceSpec& instance : scene.instances) {
    if (instance.hidden) continue;
    counts.polygons += scene.meshes[static_cast<std::size_t>(instance.mesh)].faces.size();
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
  pool("vertices", pools.vertices, s.max_vertices);
  out["bands"] = s.bands;
  return out.dump(2) + "\n";
}

}  // namespace spanline::host
