#include "core/geom/mesh_points.hpp"

namespace spanline {

PackedXY place_vertex(MeshPoints& points, std::uint32_t vertex) { return PackedXY(points[vertex]); }

}  // namespace spanline
