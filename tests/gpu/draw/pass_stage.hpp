#pragma once
#include "draw/camera.hpp"
#include "draw/frame_values.hpp"
#include "draw/instances/instances_pass.hpp"
#include "draw/screen/targets.hpp"
#include "gpu/draw/instance_stage.hpp"

#include <span>

/// An instances pass without a renderer. The frame's uniform values are bound.
struct PassStage {
  PassStage(const simreel::scene::Scene& scene, glm::ivec2 size)
      : values(simreel::draw::frameValues(scene, size, 0, {})),
        buffer("frame values", sizeof values),
        targets(size, 1),
        lamps(scene),
        shadow(scene.sun),
        pass(shadow, lamps, targets.scene, size, 1) {
    buffer.write(0, std::as_bytes(std::span(&values, 1)));
    buffer.bindUniform(0, 0, sizeof values);
  }
  simreel::shader::Frame values;
  simreel::gl::Buffer buffer;
  simreel::draw::Targets targets;
  simreel::draw::Lamps lamps;
  simreel::draw::ShadowPass shadow;
  simreel::draw::InstancesPass pass;
};

/// Returns darkScene() without shadows.
inline simreel::scene::Scene plainScene() {
  simreel::scene::Scene scene = darkScene();
  scene.sun.shadow = false;
  return scene;
}
