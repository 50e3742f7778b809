#include "draw/exact/scene/picture_layers.hpp"

#include "draw/exact/exact_view.hpp"
#include "draw/exact/motion/velocities.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>

#include <glm/vec3.hpp>

namespace simreel::draw {

namespace {

constexpr unsigned groundNumber = 0xfffffffeU;  // id of the ground, as in tile_lists.glsl
constexpr unsigned farthestKey = 0x7fffffffU;   // key of an empty sample, as nearKey() in triangle.glsl

}  // namespace

void PictureLayers::keepShown(Layer layer, std::span<const float> sums) {
  std::vector<float>& into = layer == Layer::normal ? normal : layer == Layer::albedo ? albedo : uv;
  const int channels = layer == Layer::uv ? 2 : 3;
  into.assign(sums.size() / 4 * static_cast<std::size_t>(channels), 0.0F);
  for (std::size_t pixel = 0; 4 * pixel < sums.size(); ++pixel) {
    const glm::vec3 sum(sums[4 * pixel], sums[4 * pixel + 1], sums[4 * pixel + 2]);
    const float length = layer == Layer::normal ? std::sqrt(sum.x * sum.x + sum.y * sum.y + sum.z * sum.z)
                                                : sums[4 * pixel + 3];
    for (int i = 0; i < channels && length > 1e-4F; ++i)
      into[static_cast<std::size_t>(channels) * pixel + static_cast<std::size_t>(i)] = sum[i] / length;
  }
}

LayerKeeper::LayerKeeper(PictureLayers& into, std::span<const Layer> wanted, glm::ivec2 size, int samples)
    : layers_(into), wanted_(wanted.begin(), wanted.end()), samples_(samples) {
  const auto pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  layers_ = {};
  layers_.size = size;
  const bool places = wants(Layer::position);
  if (wants(Layer::depth)) layers_.depth.assign(pixels, std::numeric_limits<float>::infinity());
  if (places) layers_.position.assign(3 * pixels, 0.0F);
  if (wants(Layer::velocity)) layers_.velocity.assign(3 * pixels, 0.0F);
  if (wants(Layer::vector)) layers_.vector.assign(2 * pixels, 0.0F);
  if (wants(Layer::primitive)) layers_.primitive.assign(pixels, PictureLayers::noPrimitive);
}

bool LayerKeeper::wants(Layer layer) const {
  return std::find(wanted_.begin(), wanted_.end(), layer) != wanted_.end();
}

/// Stores the index of the primitive within its object. The index is unique within the object and does not
/// depend on other objects.
void LayerKeeper::keepPrimitive(std::size_t pixel, unsigned number, std::span<const DrawnThing> things) {
  if (layers_.primitive.empty()) return;
  layers_.primitive[pixel] = 0;
  if (number >= groundNumber || things.empty()) return;
  const auto after =
      std::upper_bound(things.begin(), things.end(), number,
                       [](unsigned n, const DrawnThing& thing) { return n < thing.firstId; });
  if (after == things.begin()) return;
  const std::string& object = (after - 1)->object;
  const auto first =
      std::find_if(things.begin(), after, [&](const DrawnThing& thing) { return thing.object == object; });
  layers_.primitive[pixel] = number - first->firstId;
}

/// Stores the vector from the current to the previous picture position. Picture rows count downwards.
void LayerKeeper::keepVector(std::size_t pixel, const std::optional<glm::dvec2>& now,
                             const std::optional<glm::dvec2>& before) {
  if (!now || !before) return;
  layers_.vector[2 * pixel] = static_cast<float>(before->x - now->x) + 0.0F;
  layers_.vector[2 * pixel + 1] = static_cast<float>(now->y - before->y) + 0.0F;
}

// The key of a sample is farthestKey minus the float bits of the nearness, so nearer samples have smaller
// keys.
void LayerKeeper::add(const Visibility& visibility, const shader::ExactView& view,
                      std::span<const DrawnThing> things, const Velocities* velocities,
                      const CameraWay* way, float farther) {
  const std::vector<GLuint> keys = visibility.readKeys();
  const std::vector<GLuint> numbers =
      wants(Layer::primitive) || velocities != nullptr ? visibility.readNumbers() : std::vector<GLuint>();
  const auto each = static_cast<std::size_t>(samples_), wide = static_cast<std::size_t>(view.size.x);
  for (int y = view.rows.x; y < view.rows.y; ++y)
    for (std::size_t x = 0; x < wide; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y) * wide + x;
      const std::size_t first = (static_cast<std::size_t>(y - view.rows.x) * wide + x) * each;
      const GLuint* const nearest = std::min_element(&keys[first], &keys[first] + each);
      const unsigned key = *nearest;
      if (key <= farthestKey) {
        const float depth = depthOf(view, std::bit_cast<float>(farthestKey - key));
        const glm::vec3 place =
            placeOf(view, {static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F}, depth);
        if (!layers_.depth.empty()) layers_.depth[pixel] = depth - farther;
        for (int i = 0; i < 3 && !layers_.position.empty(); ++i)
          layers_.position[3 * pixel + static_cast<std::size_t>(i)] = place[i];
        const unsigned number =
            numbers.empty() ? groundNumber : numbers[static_cast<std::size_t>(nearest - keys.data())];
        keepPrimitive(pixel, number, things);
        glm::vec3 velocity(0);
        if (velocities != nullptr && number < groundNumber) {
          velocity = velocities->at(number, glm::dvec3(place));
          for (int i = 0; i < 3 && !layers_.velocity.empty(); ++i)
            layers_.velocity[3 * pixel + static_cast<std::size_t>(i)] = velocity[i] + 0.0F;
        }
        if (way != nullptr)
          keepVector(pixel, pixelOf(way->now, glm::dvec3(place)),
                     pixelOf(way->before, glm::dvec3(place) - way->seconds * glm::dvec3(velocity)));
      } else if (way != nullptr && !isParallel(way->now)) {
        const glm::vec2 at(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
        const glm::dvec3 away(placeOf(way->now, at, 1) - glm::vec3(way->now.eye));
        keepVector(pixel, pixelOfDirection(way->now, away), pixelOfDirection(way->before, away));
      }
    }
}

}  // namespace simreel::draw
