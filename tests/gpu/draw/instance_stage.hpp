#pragma once
#include "gpu/draw/draw_stage.hpp"

#include <cstdint>

/// A deterministic random number generator that returns floats in [0, 1).
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : state_(seed) {}
  float operator()() {
    state_ = state_ * 747796405U + 2891336453U;
    const std::uint32_t word = ((state_ >> ((state_ >> 28U) + 4U)) ^ state_) * 277803737U;
    return static_cast<float>(((word >> 22U) ^ word) >> 8U) / 16777216.0F;
  }
  /// Returns a random point in the cube from (-1, -1, -1) to (1, 1, 1).
  glm::vec3 cube() {
    const float x = (*this)() * 2 - 1;
    const float y = (*this)() * 2 - 1;
    return {x, y, (*this)() * 2 - 1};
  }

 private:
  std::uint32_t state_;
};

/// Instances, stored like those that a simulation publishes.
struct InstanceStage {
  InstanceStage(const std::vector<glm::vec4>& places, const std::vector<glm::vec4>& speeds)
      : positions(simreel::gl::Buffer::of<glm::vec4>("instance positions", places)),
        velocities(simreel::gl::Buffer::of<glm::vec4>("instance velocities", speeds)),
        positionView(simreel::gl::Texture::view("instance positions", GL_RGBA32F, positions)),
        velocityView(simreel::gl::Texture::view("instance velocities", GL_RGBA32F, velocities)) {
    instances.positions = &positionView;
    instances.velocities = &velocityView;
    instances.capacity = static_cast<int>(places.size());
    instances.material = &material;
  }
  /// Creates instances with a velocity of 0, a mass of 1 kg and an age of 0.
  explicit InstanceStage(const std::vector<glm::vec3>& places)
      : InstanceStage(
            [&] {
              std::vector<glm::vec4> four;
              for (const glm::vec3& p : places) four.emplace_back(p, 1.0F);
              return four;
            }(),
            std::vector<glm::vec4>(places.size(), glm::vec4(0))) {}
  InstanceStage(const InstanceStage&) = delete;
  InstanceStage& operator=(const InstanceStage&) = delete;
  InstanceStage(InstanceStage&&) = delete;
  InstanceStage& operator=(InstanceStage&&) = delete;
  ~InstanceStage() = default;

  simreel::gl::Buffer positions, velocities;
  simreel::gl::Texture positionView, velocityView;
  simreel::scene::Material material;
  simreel::sim::Instances instances;
};
