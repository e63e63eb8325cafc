// Surface detail and see-through materials for random scenes.
#pragma once

#include "oracle/random.hpp"
#include "oracle/scene_store.hpp"

namespace spanline::oracle {

// Makes none, some or all materials see-through and lays up to 12 details on faces of each mesh: in parts beside their
// parent, over one another, across themselves, and off its plane, which must not show.
void add_random_layers(SceneStore& scene, Random& random);

}  // namespace spanline::oracle
