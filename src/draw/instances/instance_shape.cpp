#include "draw/instances/instance_shape.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

namespace {

constexpr int sphereLevels = 5;
constexpr std::size_t batchIndices = 4096;  // min number of indices per drawn instance; larger batches of
                                            // copies keep the GPU busy

struct Triangles {
  std::vector<glm::vec3> points;
  std::vector<unsigned> corners;
};

Triangles icosahedron() {
  const float g = 0.5F * (1.0F + std::sqrt(5.0F));
  Triangles t;
  for (const glm::vec3 p : {glm::vec3(-1, g, 0),
                            {1, g, 0},
                            {-1, -g, 0},
                            {1, -g, 0},
                            {0, -1, g},
                            {0, 1, g},
                            {0, -1, -g},
                            {0, 1, -g},
                            {g, 0, -1},
                            {g, 0, 1},
                            {-g, 0, -1},
                            {-g, 0, 1}})
    t.points.push_back(glm::normalize(p));
  t.corners = {0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
               4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
               6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
  return t;
}

float depthOfFacets(const Triangles& sphere) {
  float depth = 0;
  for (std::size_t i = 0; i < sphere.corners.size(); i += 3) {
    const glm::vec3 sum = sphere.points[sphere.corners[i]] + sphere.points[sphere.corners[i + 1]] +
                          sphere.points[sphere.corners[i + 2]];
    depth = std::max(depth, 1.0F - glm::length(sum) / 3.0F);
  }
  return depth;
}

/// Returns the scale factor at which the outline of the faceted sphere has, averaged over all view
/// directions, the area of the unit sphere's outline. The mean outline area of a convex body is a quarter
/// of its surface area (Cauchy). Without scaling, icospheres would look too small by up to 2% of the
/// radius.
float fullScale(const Triangles& sphere) {
  double twice = 0;
  for (std::size_t i = 0; i < sphere.corners.size(); i += 3) {
    const glm::vec3& a = sphere.points[sphere.corners[i]];
    twice += glm::length(
        glm::cross(sphere.points[sphere.corners[i + 1]] - a, sphere.points[sphere.corners[i + 2]] - a));
  }
  return static_cast<float>(std::sqrt(8.0 * std::numbers::pi / twice));
}

/// Divides each triangle into four and moves the new vertices onto the unit sphere.
Triangles divided(const Triangles& coarse) {
  Triangles fine;
  fine.points = coarse.points;
  std::map<std::pair<unsigned, unsigned>, unsigned> middles;
  const auto middle = [&](unsigned a, unsigned b) {
    const auto [place, fresh] =
        middles.try_emplace(std::minmax(a, b), static_cast<unsigned>(fine.points.size()));
    if (fresh) fine.points.push_back(glm::normalize(coarse.points[a] + coarse.points[b]));
    return place->second;
  };
  for (std::size_t i = 0; i < coarse.corners.size(); i += 3) {
    const unsigned a = coarse.corners[i];
    const unsigned b = coarse.corners[i + 1];
    const unsigned c = coarse.corners[i + 2];
    const unsigned ab = middle(a, b);
    const unsigned bc = middle(b, c);
    const unsigned ca = middle(c, a);
    fine.corners.insert(fine.corners.end(), {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca});
  }
  return fine;
}

}  // namespace

struct InstanceShape::Builder {
  std::vector<glm::vec4> vertices;  ///< positions and normals, alternating
  std::vector<std::vector<unsigned>> levels;

  void add(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
           std::span<const unsigned> corners, float scale) {
    const auto first = static_cast<unsigned>(vertices.size() / 2);
    for (std::size_t i = 0; i < positions.size(); ++i) {
      vertices.emplace_back(scale * positions[i], 1.0F);
      vertices.emplace_back(normals[i], 0.0F);
    }
    auto& level = levels.emplace_back(corners.begin(), corners.end());
    for (unsigned& corner : level) corner += first;
  }

  [[nodiscard]] InstanceShape build(unsigned vertexCount) const {
    InstanceShape shape;
    shape.vertexBits_ = std::bit_width(std::max(vertexCount, 2U) - 1U);
    const std::size_t maxCopies = std::size_t{1} << static_cast<unsigned>(30 - shape.vertexBits_);
    std::vector<unsigned> all;
    for (const auto& level : levels) {
      const std::size_t copies =
          std::clamp(batchIndices / std::max<std::size_t>(level.size(), 1), std::size_t{1}, maxCopies);
      shape.levels_.push_back({GL_TRIANGLES, static_cast<int>(all.size()),
                               static_cast<int>(copies * level.size()), static_cast<int>(copies), 0.0F});
      for (std::size_t copy = 0; copy < copies; ++copy)
        for (const unsigned corner : level)
          all.push_back(static_cast<unsigned>(copy) << static_cast<unsigned>(shape.vertexBits_) | corner);
    }
    shape.indices_ = gl::Buffer::of<unsigned>("instance indices", all);
    if (vertices.empty()) return shape;
    shape.vertices_ = gl::Buffer::of<glm::vec4>("instance vertices", vertices);
    shape.view_ = gl::Texture::view("instance vertices", GL_RGBA32F, shape.vertices_);
    return shape;
  }
};

InstanceShape InstanceShape::sprite(bool points) {
  const std::vector<unsigned> square = {0, 1, 2, 2, 1, 3};
  Builder builder;
  builder.levels = {points ? std::vector<unsigned>{0} : square, square};
  InstanceShape shape = builder.build(4);
  if (points) shape.levels_[0].mode = GL_POINTS;
  return shape;
}

InstanceShape InstanceShape::sphere() {
  Builder builder;
  std::vector<float> depths;
  Triangles t = icosahedron();
  for (int level = 0; level < sphereLevels; ++level) {
    if (level > 0) t = divided(t);
    const float scale = fullScale(t);
    builder.add(t.points, t.points, t.corners, 0.5F * scale);
    depths.push_back(scale * depthOfFacets(t));
  }
  InstanceShape shape = builder.build(static_cast<unsigned>(builder.vertices.size() / 2));
  for (std::size_t level = 0; level < depths.size(); ++level) shape.levels_[level].swell = depths[level];
  return shape;
}

InstanceShape InstanceShape::mesh(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                                  std::span<const unsigned> indices) {
  Builder builder;
  builder.add(positions, normals, indices, 1.0F);
  InstanceShape shape = builder.build(static_cast<unsigned>(positions.size()));
  shape.radius_ = 0;
  for (const glm::vec3& p : positions) shape.radius_ = std::max(shape.radius_, glm::length(p));
  return shape;
}

}  // namespace simreel::draw
