// Pools for meshes drawn in bands.
#pragma once

#include <vector>

#include "core/frame/storage.hpp"

namespace spanline::test {

// The storage of a BandPools whose sizes are chosen here.
struct BandMemory {
  struct Sizes {
    std::uint16_t vertices, lines, looks, tables, planes, edges = 2000;
    bool gouraud = true;
    std::uint32_t points = 0;
    std::uint16_t instances = 1;
  };

  BandMemory(const SceneView& view, const Screen& screen, const Sizes& sizes)
      : drawn(BitPool::words_for(view.face_count()) + 1u),
        keys(view.vertex_count() + 1u),
        vertices(sizes.vertices + 1u),
        buckets(sizes.lines + 1u),
        colors(sizes.looks + 1u),
        heads(LookChains::heads_for(view.face_count())),
        links(sizes.looks + 1u),
        edges(sizes.edges + 1u),
        planes(sizes.planes + 1u),
        reaches(PlaneCache::reaches_for(sizes.planes) + 1u),
        looks(sizes.looks + 1u),
        tables(sizes.tables + 1u),
        points(sizes.points + 1u),
        instances(sizes.instances + 1u) {
    storage.screen = screen;
    storage.mesh.walker.edges[0] = ref(edges);
    storage.mesh.walker.planes = ref(planes);
    storage.mesh.walker.reaches = ref(reaches);
    storage.mesh.walker.points = ref(points);
    storage.bands = {ref(drawn),  ref(keys),  ref(vertices), ref(buckets),
                     ref(colors), ref(heads), ref(links),    ref(instances)};
    if (sizes.gouraud) storage.smooth = {ref(looks), ref(tables)};
  }
  template <typename T>
  static PoolRef<T> ref(std::vector<T>& items) {
    return {items.data(), static_cast<std::uint16_t>(items.size() - 1)};
  }
  std::vector<std::uint32_t> drawn;
  std::vector<std::uint8_t> keys;
  std::vector<BandVertex> vertices;
  std::vector<std::uint8_t> buckets;
  std::vector<FaceColor> colors;
  std::vector<std::uint8_t> heads, links;
  std::vector<ActiveEdge> edges;
  std::vector<CachedPlane> planes;
  std::vector<DepthReach> reaches;
  std::vector<FaceLook> looks;
  std::vector<ColorTable> tables;
  std::vector<ScreenXY> points;
  std::vector<BandInstance> instances;
  FrameStorage storage{};
};

}  // namespace spanline::test
