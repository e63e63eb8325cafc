#pragma once

#include <cstdint>
#include <new>

#include "core/fx/bits.hpp"
#include "core/scene/format.hpp"
#include "core/shade/brightness.hpp"
#include "core/shade/light_hue.hpp"

namespace spanline {

// The lights as one instance's mesh sees them, so that a normal is lit where it lies: ambient plus up to four
// directional lights, each intensity * max(0, -direction . normal), a channel at a time, saturating at 255.
class LightRig {
 public:
  LightRig() = default;
  // `scene` must outlive it.
  LightRig(const SceneRecord& scene, const Transform& transform);

  // The colour of a surface with this normal and material; `flip` turns the normal round (a back seen from behind).
  Rgb8 shade(const Normal10& normal, const MaterialRecord& material, bool flip) const;

  // How much light falls on a surface with this normal in LightHue's channel, which tells the others where all lights
  // have one hue; Q8.8.
  std::uint32_t sum(const Normal10& normal, bool flip) const;
  // How bright that makes it.
  Brightness brightness(const Normal10& normal, bool flip) const {
    return brightness(single() && !flip ? one().sum(normal) : sum(normal, flip));
  }
  // Whether it is the sum() of one() light where nothing is flipped.
  bool single() const { return uniform_ && scene_->lights.size() == 1; }
  // Whether it is so in every channel, since neither light nor ambient light have a hue.
  bool simple() const { return grey_ && single(); }
  // Whether lit_rgb565_wire() of that sum is the colour of a surface, as it does not saturate.
  bool quick() const { return simple() && one().most() <= 256; }

  // LightHue's channel of a light and of the ambient light, in a mesh that is turned and scaled evenly.
  struct One {
    std::int32_t x, y, z;     // towards the light, as LightRig::direction_
    std::uint32_t intensity;  // Q8.8
    std::uint32_t ambient;    // Q8.23, and half a unit of Q8.8

    static One of(const std::int16_t (&d)[3], std::uint32_t intensity, std::uint32_t ambient) {
      return {-d[0], -d[1], -d[2], intensity, (ambient << 15) + (1u << 14)};
    }
    static constexpr One full() { return {0, 0, 0, 0, std::uint32_t{256} << 15}; }
    std::uint32_t most() const { return (ambient >> 15) + intensity; }  // of sum()
    // Q8.8.
    std::uint32_t sum(const Normal10& normal) const {
      const std::int32_t dot = (x * normal.x() + y * normal.y() + z * normal.z()) >> 8;
      // 2^15 would be all light; a unit less of it is half a unit of light less at most, for intensities below 2^14.
      return (ambient + saturate15(dot) * intensity) >> 15;
    }
  };
  One one() const {  // where single()
    return One::of(direction_[0], scene_->lights[0].intensity[channel_], scene_->ambient[channel_]);
  }
  // What falls on a surface of the material where quick(): all of it is seen of one that is not lit.
  One on(const MaterialRecord& material) const {
    return material.shading == MaterialRecord::kUnlit ? One::full() : one();
  }
  // The brightness of such a sum.
  static Brightness brightness(std::uint32_t sum) {
    return static_cast<Brightness>(((sum < 256 ? sum : 256) * kFullBrightness + 128) >> 8);
  }

 private:
  struct Fall {
    std::uint32_t amount[kMaxLights];
  };
  Fall fall(const Normal10& normal, bool flip) const;
  std::uint32_t sum(const Fall& fall, unsigned channel, const ReachRecord* reach) const;
  std::uint32_t turned_length(const Normal10& normal) const;

  const SceneRecord* scene_ = nullptr;
  bool grey_ = true;                       // ambient and lights have no hue
  std::uint8_t channel_ = 0;               // LightHue::channel()
  bool uniform_ = true;                    // the transform only turns and scales evenly
  std::int16_t direction_[kMaxLights][3];  // in the mesh, Q2.14; scaled by 512 / 511 for Normal10's unit
  std::int32_t normal_matrix_[3][3];       // what turns normals, of 14 bits and a sign
};

// The light of a plain scene (Budget::plain) as one instance's mesh sees it: LightRig::one(), where quick().
class PlainLight {
 public:
  constexpr PlainLight() : one_{}, fits_(false) {}
  PlainLight(const SceneRecord& scene, const Transform& transform);

  // Whether the instance is turned and scaled evenly, and not mirrored.
  bool fits() const { return fits_; }
  bool quick() const { return true; }
  bool single() const { return true; }
  const LightRig::One& one() const { return one_; }
  LightRig::One on(const MaterialRecord& material) const {
    return material.shading == MaterialRecord::kUnlit ? LightRig::One::full() : one_;
  }

 private:
  LightRig::One one_;
  bool fits_;
};

// The rig of the instance that was asked for last.
template <typename Rig>
class Kept {
 public:
  void forget() { instance_ = UINT32_MAX; }
  // Of the scene's instance of this number; `transform` is its.
  [[gnu::noinline]] const Rig& of(const SceneRecord& scene, std::uint32_t instance, const Transform& transform) {
    if (instance_ != instance) {
      instance_ = instance;
      new (&rig_) Rig(scene, transform);  // in its place, not copied there
    }
    return rig_;
  }
  const Rig& last() const { return rig_; }

 private:
  Rig rig_;
  std::uint32_t instance_ = UINT32_MAX;
};
using KeptLights = Kept<LightRig>;

}  // namespace spanline
