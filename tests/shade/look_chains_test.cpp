#include "core/shade/look_chains.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <vector>

#include "oracle/random.hpp"

namespace spanline::test {
namespace {

TEST(LookChains, KeepTheLooksMadeLast) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    oracle::Random random(seed);
    const auto kept = static_cast<std::uint16_t>(random.between(1, 120));
    const int faces = random.between(1, 2000);
    std::vector<FaceLook> looks(kept + 1u, FaceLook{});
    std::vector<std::uint8_t> heads(LookChains::heads_for(static_cast<std::uint32_t>(faces))), links(kept + 1u);
    LookChains chains({looks.data(), kept}, {heads.data(), static_cast<std::uint16_t>(heads.size() - 1)},
                      {links.data(), kept});
    EXPECT_GE(chains.most_faces(), static_cast<std::uint32_t>(faces));
    chains.clear();
    std::deque<FaceId> made;
    const int near = random.between(1, faces + 1);  // faces of one time are near each other
    for (int i = 0; i < 500; ++i) {
      const auto face = static_cast<FaceId>((i + random.below(near)) % (faces + 1));
      bool anew = false;
      const auto make = [&](FaceLook& look) {
        anew = true;
        look = FaceLook::flat(static_cast<std::uint16_t>(face * 7));
      };
      const FaceLook& look = chains.look(face, make);
      ASSERT_EQ(look.face, face);
      ASSERT_EQ(look.color(), static_cast<std::uint16_t>(face * 7));
      ASSERT_EQ(&look, &looks[heads[LookChains::head_of(face)]]);
      ASSERT_EQ(anew, std::find(made.begin(), made.end(), face) == made.end()) << "seed " << seed;
      if (anew) made.push_back(face);
      if (made.size() > kept) made.pop_front();
    }
  }
}

}  // namespace
}  // namespace spanline::test
