#pragma once
#include "draw/exact/bindings.hpp"
#include "draw/exact/exact_view.hpp"
#include "draw/exact/visibility.hpp"
#include "draw/frame_values.hpp"
#include "draw/instances/instance_values.hpp"
#include "gl/element_array.hpp"
#include "gpu/draw/instance_stage.hpp"

#include <vector>

/// Returns a scene that is seen from the side by a nearby camera.
inline simreel::scene::Scene sideScene() {
  simreel::scene::Scene scene;
  scene.camera.position = glm::vec3(0.7F, 1.1F, 4.3F);
  scene.camera.target = glm::vec3(-0.1F, 0.2F, 0.3F);
  scene.camera.near = 0.3F;
  scene.camera.far = 9;
  return scene;
}

/// A visibility buffer for kernels of the exact rasterizer. Gives access to the results.
struct ExactStage {
  ExactStage(const simreel::scene::Scene& scene, glm::ivec2 pixels, int count)
      : size(pixels), samples(count), target("a test", pixels, count, true) {
    using namespace simreel;
    const shader::Frame values = draw::frameValues(scene, size, 0, {});
    view = draw::exactView(draw::viewAt(scene.camera, 0, size, {}), scene.camera, size);
    frame = gl::Buffer("frame values", sizeof values);
    frame.write(0, std::as_bytes(std::span(&values, 1)));
    viewBuffer = gl::Buffer("view", sizeof view);
    viewBuffer.write(0, std::as_bytes(std::span(&view, 1)));
    clear();
  }

  void clear() {
    using namespace simreel;
    frame.bindUniform(draw::frameBinding, 0, frame.bytes());
    viewBuffer.bindUniform(draw::viewBinding, 0, viewBuffer.bytes());
    target.clear();
    gl::barrier();
  }

  [[nodiscard]] std::vector<unsigned> keys() const { return target.readKeys(); }
  [[nodiscard]] std::vector<unsigned> ids() const { return target.readNumbers(); }

  /// Returns the picture position (pixels) of sample `i`, where i counts the samples of all pixels.
  [[nodiscard]] glm::vec2 place(std::size_t i) const {
    // sample patterns of glsl/draw/exact/fixed.glsl, in 1/16 pixel
    static constexpr int four[4][2] = {{6, 2}, {14, 6}, {2, 10}, {10, 14}};
    const int pixel = static_cast<int>(i) / samples;
    const std::size_t s = i % static_cast<std::size_t>(samples);
    const glm::ivec2 aside = samples == 1 ? glm::ivec2(8) : glm::ivec2(four[s][0], four[s][1]);
    return glm::vec2(glm::ivec2(pixel % size.x, pixel / size.x) * 16 + aside) * 0.0625F;
  }

  glm::ivec2 size;
  int samples;
  simreel::shader::ExactView view{};
  simreel::gl::Buffer frame, viewBuffer;
  simreel::draw::Visibility target;
};

/// A dart-shaped mesh whose faces differ in size.
struct DartStage {
  std::vector<glm::vec3> positions = {{0, 0, 0.6F},       {0.34F, 0.03F, -0.4F}, {-0.34F, 0.03F, -0.4F},
                                      {0, -0.14F, -0.4F}, {0.05F, 0.04F, -0.3F}, {-0.05F, 0.04F, -0.3F}};
  std::vector<unsigned> corners = {0, 4, 1, 0, 2, 5, 0, 5, 4, 0, 1, 3, 0, 3, 2, 1, 4, 3, 2, 3, 5, 4, 5, 3};
  simreel::draw::InstanceShape shape = simreel::draw::InstanceShape::mesh(
      positions, std::vector<glm::vec3>(positions.size(), glm::vec3(0, 1, 0)), corners);
};

/// A surface with the triangles of all live copies and the same ids.
struct DartSurface {
  DartSurface(const DartStage& mesh, const std::vector<glm::vec3>& places, float size) {
    std::vector<glm::vec4> points;
    std::vector<unsigned> all;
    for (std::size_t k = 0; k < places.size(); ++k) {
      for (const unsigned corner : mesh.corners)
        all.push_back(static_cast<unsigned>(k * mesh.positions.size()) + corner);
      for (const glm::vec3& p : mesh.positions) points.emplace_back(places[k] + size * p, 1.0F);
    }
    buffer = simreel::gl::Buffer::of<glm::vec4>("points", points);
    indices = simreel::gl::Buffer::of<unsigned>("corners", all);
    view = simreel::gl::Texture::view("points", GL_RGBA32F, buffer);
    surface.positions = &view;
    surface.normals = &view;
    surface.vertexCount = static_cast<int>(points.size());
    surface.indices = &indices;
    surface.indexCount = static_cast<int>(all.size());
    surface.doubleSided = true;
    surface.material = &material;
  }
  simreel::gl::Buffer buffer, indices;
  simreel::gl::Texture view;
  simreel::scene::Material material;
  simreel::sim::Surface surface;
};
