#include "sim/cloth/parameters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>

#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

enum class Weave { none, plain, twill };

/// Appearance of a fabric: its finish, and the threads of its weave that are visible at close range.
struct FabricLook {
  float roughness, translucency;
  float sheen;  ///< grey level of the fibres that stick out of the surface
  float coat, coatRoughness;
  Weave weave;
  float threads;  ///< number of threads per metre
};

FabricLook lookOf(FabricMaterial material) {
  // The threads are two to three times as wide as the threads of the fabrics of fabricOf(), so that the
  // weave is visible from half a metre away.
  constexpr FabricLook table[] = {
      {0.8F, 0.22F, 0.06F, 0, 0.5F, Weave::plain, 1800},      // cotton
      {0.34F, 0.3F, 0.1F, 0.55F, 0.28F, Weave::plain, 2200},  // silk
      {0.95F, 0.03F, 0.1F, 0, 0.5F, Weave::twill, 1000},      // denim
      {0.5F, 0.34F, 0.02F, 0.2F, 0.35F, Weave::plain, 800},   // nylon
      {0.92F, 0.1F, 0.05F, 0, 0.5F, Weave::plain, 700},       // canvas
      {0.55F, 0.0F, 0.0F, 0.12F, 0.4F, Weave::none, 0},       // rubber
  };
  return table[static_cast<std::size_t>(material)];
}

constexpr int threadTexels = 16;  ///< texels across a thread

/// Returns the number of threads after which a weave repeats.
int repeatOf(Weave weave) {
  return weave == Weave::twill ? 4 : 2;
}

/// Returns the height of a woven sheet, in units of the thread width, at a point given in the same units.
/// Warp threads run along y. Each thread is rounded and is either on top or below.
double heightAt(Weave weave, double x, double y) {
  const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
  const int repeat = repeatOf(weave);
  const int step = (((column - row) % repeat) + repeat) % repeat;
  const bool warp = weave == Weave::twill ? step != 0 : step == 0;  // in denim, three of four crossings
                                                                    // show the warp
  const double across = 2 * ((warp ? x - column : y - row) - 0.5);
  const double along = 2 * ((warp ? y - row : x - column) - 0.5);
  // A thread dips below its neighbours at both ends of its visible part.
  const double dip = weave == Weave::plain || !warp ? 0.25 * along * along : 0.0;
  return 0.5 * (1 - across * across) - dip;
}

/// Returns the normal map of one repeat of a weave.
std::shared_ptr<const scene::Image> normalsOf(Weave weave) {
  const int side = repeatOf(weave) * threadTexels;
  auto image = std::make_shared<scene::Image>();
  image->name = weave == Weave::twill ? "twill" : "plain weave";
  image->size = {side, side};
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const double x = (column + 0.5) / threadTexels, y = (row + 0.5) / threadTexels;
      const double reach = 0.5 / threadTexels;
      const auto slope = [&](double low, double high) { return (high - low) / (2 * reach); };
      const glm::dvec3 normal = glm::normalize(
          glm::dvec3(-slope(heightAt(weave, x - reach, y), heightAt(weave, x + reach, y)),
                     slope(heightAt(weave, x, y - reach), heightAt(weave, x, y + reach)), 2.4));
      for (int k = 0; k < 3; ++k)
        image->rgba.push_back(static_cast<std::uint8_t>(std::lround(127.5 + 127.5 * normal[k])));
      image->rgba.push_back(255);
    }
  return image;
}

}  // namespace

std::optional<scene::Material> ClothParameters::look() const {
  if (!fabric || coloring.used()) return std::nullopt;
  const FabricLook look = lookOf(fabric->material);
  scene::Material material;
  material.roughness = look.roughness;
  material.translucency = look.translucency;
  material.finish.sheen = glm::vec3(look.sheen);
  material.finish.sheenRoughness = 0.4F;
  material.finish.coat = look.coat;
  material.finish.coatRoughness = look.coatRoughness;
  // The size in uv is known only for a grid.
  if (look.weave == Weave::none || mesh) return material;
  static const std::array<std::shared_ptr<const scene::Image>, 2> normals = {normalsOf(Weave::plain),
                                                                             normalsOf(Weave::twill)};
  material.finish.normals.image = normals.at(look.weave == Weave::twill ? 1 : 0);
  const float repeats = look.threads / static_cast<float>(repeatOf(look.weave)) * spacing;
  material.textureScale = {std::round(repeats * static_cast<float>(size.x - 1)),
                           std::round(repeats * static_cast<float>(size.y - 1)), 1};
  return material;
}

}  // namespace simreel::sim
