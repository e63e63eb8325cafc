#pragma once

#include "core/shade/light.hpp"

namespace spanline {

// By what a facet is lit that is drawn flat: its own normal, or where the mesh has none that of its first corner.
inline const Normal10& facet_normal(const MeshRecord& mesh, std::uint32_t mesh_face, std::uint32_t first_corner) {
  return mesh.face_normals.empty() ? mesh.vertex_normals[first_corner] : mesh.face_normals[mesh_face];
}

// Its colour; `flip` as in LightRig::shade.
inline Rgb8 facet_color(const MeshRecord& mesh, std::uint32_t mesh_face, std::uint32_t first_corner,
                        const MaterialRecord& material, const LightRig& rig, bool flip) {
  return rig.shade(facet_normal(mesh, mesh_face, first_corner), material, flip);
}

}  // namespace spanline
