#pragma once

#include "core/shade/light.hpp"

namespace spanline {

// The colour of a facet that is drawn flat: by its own normal, or where the mesh has none by that of its first corner.
// `flip` as in LightRig::shade.
inline Rgb8 facet_color(const MeshRecord& mesh, std::uint32_t mesh_face, std::uint32_t first_corner,
                        const MaterialRecord& material, const LightRig& rig, bool flip) {
  const Normal10& normal = mesh.face_normals.empty() ? mesh.vertex_normals[first_corner] : mesh.face_normals[mesh_face];
  return rig.shade(normal, material, flip);
}

}  // namespace spanline
