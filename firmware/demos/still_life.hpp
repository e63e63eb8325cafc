// Things that stand still while the viewer sways round them: dice with pips, a house and coloured panes. Pips, windows
// and all shadows are surface detail that the scene compiler has made; the panes shine through one another.
#pragma once

#include "demos/demo.hpp"
#include "dice_scene.hpp"
#include "dice_small_scene.hpp"
#include "house_scene.hpp"
#include "house_small_scene.hpp"
#include "panes_scene.hpp"
#include "panes_small_scene.hpp"

namespace spanline::demos {

void pose_still_life(std::uint32_t frame, const Shot& shot, const Moving& moving);

inline constexpr Budget kStillLifeBudget{.facets = 192,
                                         .vertices = 256,
                                         .polygons = 48,
                                         .edges = 96,
                                         .segments = 64,
                                         .implied = 8,
                                         .layers = 24,
                                         .gouraud = false,
                                         .scan_out = ScanPolicy::tiles};

inline constexpr Layouts::Layout kDice{{&dice_scene::scene, &dice_scene::camera, &dice_scene::kTarget,
                                        dice_scene::kOrigins, dice_scene::kWidth, dice_scene::kHeight},
                                       kStillLifeBudget};
inline constexpr Layouts::Layout kDiceSmall{
    {&dice_small_scene::scene, &dice_small_scene::camera, &dice_small_scene::kTarget, dice_small_scene::kOrigins,
     dice_small_scene::kWidth, dice_small_scene::kHeight},
    kStillLifeBudget};
inline constexpr Layouts::Layout kHouse{{&house_scene::scene, &house_scene::camera, &house_scene::kTarget,
                                         house_scene::kOrigins, house_scene::kWidth, house_scene::kHeight},
                                        kStillLifeBudget};
inline constexpr Layouts::Layout kHouseSmall{
    {&house_small_scene::scene, &house_small_scene::camera, &house_small_scene::kTarget, house_small_scene::kOrigins,
     house_small_scene::kWidth, house_small_scene::kHeight},
    kStillLifeBudget};
inline constexpr Layouts::Layout kPanes{{&panes_scene::scene, &panes_scene::camera, &panes_scene::kTarget,
                                         panes_scene::kOrigins, panes_scene::kWidth, panes_scene::kHeight},
                                        kStillLifeBudget};
inline constexpr Layouts::Layout kPanesSmall{
    {&panes_small_scene::scene, &panes_small_scene::camera, &panes_small_scene::kTarget, panes_small_scene::kOrigins,
     panes_small_scene::kWidth, panes_small_scene::kHeight},
    kStillLifeBudget};

inline constexpr Layouts dice{"dice", pose_still_life, kDice, kDice, kDice, kDiceSmall};
inline constexpr Layouts house{"house", pose_still_life, kHouse, kHouse, kHouse, kHouseSmall};
inline constexpr Layouts panes{"panes", pose_still_life, kPanes, kPanes, kPanes, kPanesSmall};

}  // namespace spanline::demos
