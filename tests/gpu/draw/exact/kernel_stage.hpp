#pragma once
#include "base/hash.hpp"
#include "draw/draw_state.hpp"
#include "draw/frame_values.hpp"
#include "gl/element_array.hpp"
#include "gl/program.hpp"
#include "gpu/draw/instance_stage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

/// Returns constant frame values, so that results depend on no other code. The eye is 7 m in front of the
/// origin.
inline simreel::shader::Frame writtenFrame() {
  simreel::shader::Frame frame{};
  frame.viewProjection[0] = glm::vec4(0.9F, 0, 0, 0);
  frame.viewProjection[1] = glm::vec4(0, 1.6F, 0, 0);
  frame.viewProjection[2] = glm::vec4(0, 0, -1.002F, -1);
  frame.viewProjection[3] = glm::vec4(0, 0, 6.8138F, 7);
  frame.eye = glm::vec4(0, 0, 7, 1);
  frame.rayForward = glm::vec4(0, 0, -1, 0);
  frame.rayRight = glm::vec4(1 / 0.9F, 0, 0, 0);
  frame.rayUp = glm::vec4(0, 0.625F, 0, 0);
  frame.groundReach = 1;  // The sun's map covers all objects if the ground is visible.
  frame.sunDirection = glm::vec4(0.48F, 0.6F, 0.64F, 0);
  frame.lightRight = glm::vec4(0.8F, 0, -0.6F, 0);
  frame.lightUp = glm::vec4(-0.36F, 0.8F, -0.48F, 0);
  frame.shadowTexels = 512;
  frame.shadowSoftness = 1.7F;
  frame.shadowReach = 1.7F;
  frame.groundHeight = -0.3F;
  frame.size = glm::vec2(97, 55);
  return frame;
}

/// Frame values and 701 balls, some of them dead or invalid, bound for kernels.
struct KernelStage {
  static constexpr int count = 701;
  static constexpr float massExponent = 0.4F;
  static constexpr float perMassReference = 0.5F;
  static constexpr float ballSize = 0.37F;
  static constexpr float ballRadius = 0.5F;

  KernelStage() : frame(writtenFrame()), block("frame values", sizeof frame), balls(places(), speeds()) {
    block.write(0, std::as_bytes(std::span(&frame, 1)));
    block.bindUniform(simreel::draw::frameBinding, 0, sizeof frame);
    balls.positionView.bind(simreel::draw::positionUnit);
    balls.velocityView.bind(simreel::draw::velocityUnit);
  }
  static std::vector<glm::vec4> places() {
    Dice dice(11);
    std::vector<glm::vec4> all;
    for (int i = 0; i < count; ++i) all.emplace_back(6.0F * dice.cube(), 0.02F + 5 * dice());
    all[13].y = 3e6F;
    all[14].x = std::numeric_limits<float>::quiet_NaN();
    return all;
  }
  static std::vector<glm::vec4> speeds() {
    Dice dice(12);
    std::vector<glm::vec4> all;
    for (int i = 0; i < count; ++i) all.emplace_back(2.0F * dice.cube(), dice() < 0.2F ? -1.0F : dice());
    return all;
  }
  static bool shown(std::size_t i) { return i != 13 && i != 14 && speeds()[i].w >= 0; }
  static double radius(std::size_t i) {
    return static_cast<double>(ballSize * ballRadius) *
           std::pow(static_cast<double>(places()[i].w * perMassReference),
                    static_cast<double>(massExponent));
  }
  void set(const simreel::gl::Program& program) const {
    program.set("size", ballSize);
    program.set("shapeRadius", ballRadius);
    program.set("massExponent", massExponent);
    program.set("perMassReference", perMassReference);
    program.set("minPixels", 0.8F);
  }
  /// Computes the bounds of the balls, then the shadow map's transform from the bounds. Returns the five
  /// rows of the transform, which is bound to simreel::draw::lightUnit.
  std::vector<glm::vec4> fitted() {
    std::array<GLuint, 10> empty{};
    std::fill_n(empty.begin(), 5, 0xffffffffU);
    bounds = simreel::gl::Buffer::of<GLuint>("bounds", empty);
    bounds.bindStorage(simreel::draw::boundsBinding);
    light.bindStorage(simreel::draw::lightBinding);
    const auto grow =
        simreel::gl::Program::compute("draw/surface/shadow_bounds.comp", {{"INSTANCES", "1"}});
    set(grow);
    grow.set("vertexCount", count);
    grow.set("invocations", 37);
    grow.dispatch(37);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    simreel::gl::Program::compute("draw/surface/shadow_fit.comp").dispatch(1);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
    lightView.bind(simreel::draw::lightUnit);
    return light.readAll<glm::vec4>();
  }

  simreel::gl::Context& context = testContext();
  simreel::shader::Frame frame;
  simreel::gl::Buffer block;
  InstanceStage balls;
  simreel::gl::Buffer bounds;
  simreel::gl::Buffer light{"light", 5 * sizeof(glm::vec4)};
  simreel::gl::Texture lightView = simreel::gl::Texture::view("light", GL_RGBA32F, light);
};

template <class T>
std::string hashOf(const std::vector<T>& items) {
  return simreel::hashHex(std::as_bytes(std::span(items)));
}
