// Shadows as surface detail (seed 2): what each light reaches of a face and what it does not become detail on that
// face, so that whoever draws the scene needs to know nothing of shadows.
#pragma once

#include <cstdint>

#include "assetc/scene_description.hpp"

namespace spanline::host {

// The scene as it stands in `frame`, with its shadows baked in. Each light has a view of it, sorted in exact integers;
// what it sees of a face is lit, and is carried back onto the face (core/area/light_view.hpp). The largest part that
// all lights reach alike stays the face itself, the other parts become surface detail with a ReachRecord of their own;
// detail that the face had is clipped to the parts. See-through polygons throw shadows of the colour that they let
// through, one behind the other too; surface detail throws none. Parts reach past the face's outline a little: the
// parent cuts them off, so that no seam can show.
//
// Instances of polygons with InstanceSpec::shadows, not hidden and not on the screen take part and get a mesh of their
// own where shadows fall on them. The scene must say what its lights are. Throws InputError where it does not, and
// where the shadows are too intricate for the sort or, on one face, for the clipper.
SceneDescription bake_shadows(const SceneDescription& scene, std::int64_t frame);

// Whether bake_shadows() of another frame may give something else.
bool shadows_move(const SceneDescription& scene);

}  // namespace spanline::host
