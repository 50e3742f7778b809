#include "draw/exact/rays/ray_emitters.hpp"

#include "draw/exact/reserve.hpp"
#include "gl/element_array.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

void RayEmitters::begin() {
  parts_.clear();
  all_ = 0;
}

void RayEmitters::add(const gl::Buffer& places, const gl::Buffer& corners, int first, int count,
                      double brightness) {
  if (count == 0) return;
  std::vector<std::uint32_t> vertices(3 * static_cast<std::size_t>(count));
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  corners.read(3 * static_cast<std::size_t>(first) * sizeof(std::uint32_t),
               std::as_writable_bytes(std::span(vertices)));
  const auto [minimum, maximum] = std::minmax_element(vertices.begin(), vertices.end());
  const std::size_t low = *minimum;
  std::vector<glm::vec4> positions(*maximum - low + 1);
  places.read(low * sizeof(glm::vec4), std::as_writable_bytes(std::span(positions)));
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const auto corner = [&](std::size_t k) { return glm::dvec4(positions[vertices[3 * i + k] - low]); };
    const glm::dvec4 a = corner(0), b = corner(1), c = corner(2);
    if (std::min({a.w, b.w, c.w}) <= 0) continue;
    const glm::dvec3 across = glm::cross(glm::dvec3(b - a), glm::dvec3(c - a));
    const double light = 0.5 * std::sqrt(glm::dot(across, across)) * brightness;
    if (!(light > 0)) continue;
    parts_.push_back({static_cast<std::uint32_t>(first) + static_cast<std::uint32_t>(i), light});
    all_ += light;
  }
}

void RayEmitters::finish() {
  constexpr double parts = 16777216;
  std::vector<glm::uvec2> texels;
  texels.reserve(parts_.size() + 1);
  double before = 0;
  for (const Part& part : parts_) {
    before += part.light;
    texels.emplace_back(static_cast<std::uint32_t>(std::min(before / all_ * parts, parts)), part.triangle);
  }
  if (texels.empty()) texels.emplace_back(0, 0);
  reserve(buffer_, view_, "what shines by itself", texels.size() * sizeof(glm::uvec2), GL_RG32UI,
          sizeof(glm::uvec2));
  buffer_.write(0, std::as_bytes(std::span(texels)));
}

EmitterFields RayEmitters::fields(const gl::Texture& places) const {
  return {.emitters = view_,
          .places = places,
          .count = static_cast<int>(parts_.size()),
          .perEmission = all_ > 0 ? static_cast<float>(1 / all_) : 0.0F};
}

}  // namespace simreel::draw
