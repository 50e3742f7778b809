#pragma once
#include "draw/camera.hpp"
#include "draw/exact/bindings.hpp"
#include "draw/exact/exact_view.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "gl/buffer.hpp"
#include "gl/limits.hpp"
#include "gl/texture.hpp"
#include "gpu/context.hpp"

#include <cstdlib>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

/// A mesh, stored like one that a simulation publishes.
struct TriangleStage {
  /// Creates the mesh. Normals default to +y.
  TriangleStage(const std::vector<glm::vec3>& places, const std::vector<unsigned>& corners,
                const std::vector<glm::vec3>& directions = {}) {
    testContext();
    std::vector<glm::vec4> texels;
    for (const glm::vec3& place : places) texels.emplace_back(place, 1.0F);
    std::vector<glm::vec4> up(places.size(), glm::vec4(0, 1, 0, 0));
    for (std::size_t i = 0; i < directions.size(); ++i) up[i] = glm::vec4(directions[i], 0);
    positions = simreel::gl::Buffer::of<glm::vec4>("positions", texels);
    normals = simreel::gl::Buffer::of<glm::vec4>("normals", up);
    indices = simreel::gl::Buffer::of<unsigned>("indices", corners);
    positionView = simreel::gl::Texture::view("positions", GL_RGBA32F, positions);
    normalView = simreel::gl::Texture::view("normals", GL_RGBA32F, normals);
    surface.positions = &positionView;
    surface.normals = &normalView;
    surface.vertexCount = static_cast<int>(places.size());
    surface.indices = &indices;
    surface.indexCount = static_cast<int>(corners.size());
    surface.material = &material;
  }
  TriangleStage(const TriangleStage&) = delete;
  TriangleStage& operator=(const TriangleStage&) = delete;
  TriangleStage(TriangleStage&&) = delete;
  TriangleStage& operator=(TriangleStage&&) = delete;
  ~TriangleStage() = default;

  void setUvs(const std::vector<glm::vec2>& places) {
    uvs = simreel::gl::Buffer::of<glm::vec2>("uvs", places);
    uvView = simreel::gl::Texture::view("uvs", GL_RG32F, uvs, sizeof(glm::vec2));
    surface.uvs = &uvView;
  }

  simreel::gl::Buffer positions, normals, indices, uvs;
  simreel::gl::Texture positionView, normalView, uvView;
  simreel::scene::Material material;
  simreel::sim::Surface surface;
};

/// Returns the view of a camera at `eye` that looks at `target`.
inline simreel::shader::ExactView exactViewFrom(glm::vec3 eye, glm::vec3 target, glm::ivec2 size) {
  simreel::scene::Camera camera;
  camera.position = eye;
  camera.target = target;
  return simreel::draw::exactView(simreel::draw::viewAt(camera, 0, size, {}), camera, size);
}

/// Sets the environment variable SIMREEL_JOIN_SURFACES during its lifetime.
struct JoiningForced {
  explicit JoiningForced(const char* word) { setenv("SIMREEL_JOIN_SURFACES", word, 1); }
  ~JoiningForced() { unsetenv("SIMREEL_JOIN_SURFACES"); }
  JoiningForced(const JoiningForced&) = delete;
  JoiningForced& operator=(const JoiningForced&) = delete;
  JoiningForced(JoiningForced&&) = delete;
  JoiningForced& operator=(JoiningForced&&) = delete;
};

/// Sets the environment variable SIMREEL_SAMPLE_LAYOUT (draw::sampleLayout) during its lifetime.
struct LayoutForced {
  explicit LayoutForced(const char* word) { setenv("SIMREEL_SAMPLE_LAYOUT", word, 1); }
  ~LayoutForced() {
    if (before_.empty())
      unsetenv("SIMREEL_SAMPLE_LAYOUT");
    else
      setenv("SIMREEL_SAMPLE_LAYOUT", before_.c_str(), 1);
  }
  LayoutForced(const LayoutForced&) = delete;
  LayoutForced& operator=(const LayoutForced&) = delete;
  LayoutForced(LayoutForced&&) = delete;
  LayoutForced& operator=(LayoutForced&&) = delete;
  /// Returns all layouts that the device supports.
  static std::vector<const char*> words() {
    if (simreel::gl::limits().atomics64) return {"apart", "pairs", "wholes"};
    return {"apart", "pairs"};
  }

 private:
  std::string before_ =
      std::getenv("SIMREEL_SAMPLE_LAYOUT") != nullptr ? std::getenv("SIMREEL_SAMPLE_LAYOUT") : "";
};

/// Keys and ids that the kernels have found.
struct SeenSamples {
  std::vector<GLuint> keys, ids;
};

inline SeenSamples seenBy(const simreel::shader::ExactView& view, int samples,
                          const std::vector<const simreel::sim::Surface*>& surfaces, int smallPixels,
                          int fanRoom = 1000, int mediumPixels = 0,
                          int binRoom = simreel::draw::binnedTriangles()) {
  simreel::gl::Buffer block("view", sizeof view);
  block.write(0, std::as_bytes(std::span(&view, 1)));
  block.bindUniform(simreel::draw::viewBinding, 0, sizeof view);
  const simreel::draw::Visibility visibility("a test", view.size, samples, true);
  simreel::draw::TriangleRaster raster(simreel::draw::TriangleRaster::Into::picture, samples, smallPixels,
                                       fanRoom, mediumPixels, binRoom);
  visibility.clear();
  raster.number(surfaces);
  raster.draw(visibility);
  return {visibility.readKeys(), visibility.readNumbers()};
}
