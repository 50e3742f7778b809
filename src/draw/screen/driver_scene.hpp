#pragma once
#include "draw/overlay/field_pass.hpp"
#include "draw/overlay/field_textures.hpp"
#include "draw/screen/targets.hpp"
#include "scene/scene.hpp"
#include "sim/core/drawable.hpp"

#include <functional>
#include <memory>

namespace simreel::draw {

/// Draws a scene, except the overlays on the finished picture, with the driver's rasterizer. First draws
/// the shadow maps. Then draws fields behind the scene, surfaces, instances and ground into a multisampled
/// linear target. Finally applies bloom, resolve, tone mapping and sRGB encoding.
class DriverScene {
 public:
  /// Objects that DriverScene shares with the overlay passes. All must outlive the DriverScene.
  struct Shared {
    const scene::Scene& scene;
    const FieldTextures& fieldTextures;
    FieldPass& fields;
    const Picture& picture;
  };
  /// Throws UserError(device) if a device limit is exceeded, and UserError(inputOutput) or UserError(usage)
  /// if a texture cannot be loaded.
  DriverScene(const Shared& shared, int samples);
  ~DriverScene();
  DriverScene(DriverScene&&) = delete;
  DriverScene& operator=(DriverScene&&) = delete;
  DriverScene(const DriverScene&) = delete;
  DriverScene& operator=(const DriverScene&) = delete;

  using StageCallback = std::function<void(const char* stage)>;
  /// Draws the frame. The frame's uniform block must be bound.
  void draw(double seconds, const sim::Drawables& drawables, const StageCallback& watch);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace simreel::draw
