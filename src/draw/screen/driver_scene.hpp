#pragma once
#include "draw/overlay/field_pass.hpp"
#include "draw/overlay/field_textures.hpp"
#include "draw/screen/targets.hpp"
#include "scene/scene.hpp"
#include "sim/core/drawable.hpp"

#include <functional>
#include <memory>

namespace simreel::draw {

/// Draws all but what lies over the finished picture with the driver's rasterizer: shadow maps; fields
/// behind, surfaces, instances and ground into a multisampled linear target; bloom, resolve, tone map, sRGB
/// encoding.
class DriverScene {
 public:
  /// What it shares with what is drawn over the picture. All must outlive it.
  struct Shared {
    const scene::Scene& scene;
    const FieldTextures& fieldTextures;
    FieldPass& fields;
    const Picture& picture;
  };
  /// Throws UserError(device) for limits; inputOutput or usage for textures.
  DriverScene(const Shared& shared, int samples);
  ~DriverScene();
  DriverScene(DriverScene&&) = delete;
  DriverScene& operator=(DriverScene&&) = delete;
  DriverScene(const DriverScene&) = delete;
  DriverScene& operator=(const DriverScene&) = delete;

  using Watch = std::function<void(const char* stage)>;
  /// The frame's uniform block is bound.
  void draw(double seconds, const sim::Drawables& drawables, const Watch& watch);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace simreel::draw
