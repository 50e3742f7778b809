#include "api/arrays.hpp"
#include "api/failure.hpp"
#include "api/scene_state.hpp"
#include "scene/json/words.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace simreel {

namespace {

using draw::Layer;

/// Returns the layer with this name, or nothing for "light".
std::optional<Layer> layerNamed(const std::string& name) {
  if (name == "light") return std::nullopt;
  std::vector<std::string> known(draw::layerNames.begin(), draw::layerNames.end());
  const auto found = std::find(known.begin(), known.end(), name);
  if (found != known.end()) return static_cast<Layer>(found - known.begin());
  known.emplace_back("light");
  api::fail(ErrorKind::usage,
            fmt::format("there is no layer \"{}\"; {}", name, scene::suggestion(name, known)));
}

Array objectLayer(const draw::PictureLayers& layers, std::vector<std::size_t> shape) {
  std::vector<std::uint32_t> objects(shape[0] * shape[1], draw::PictureLayers::noPrimitive);
  const auto ranks = static_cast<std::size_t>(layers.ranks);
  for (std::size_t i = 0; ranks > 0 && i < objects.size(); ++i)
    if (layers.shares[i * ranks].coverage > 0) objects[i] = layers.shares[i * ranks].object;
  return api::denseArray("object", "", NumberType::uint32, std::move(shape), objects);
}

Array layerArray(const draw::PictureLayers& layers, const std::string& name,
                 const std::optional<Layer>& layer) {
  const std::vector<std::size_t> one = {static_cast<std::size_t>(layers.size.y),
                                        static_cast<std::size_t>(layers.size.x)};
  const auto many = [&](std::size_t channels) {
    std::vector<std::size_t> shape = one;
    shape.push_back(channels);
    return shape;
  };
  constexpr auto real = NumberType::float32;
  if (!layer) return api::denseArray(name, "", real, many(4), layers.light);
  switch (*layer) {
    case Layer::depth:
      return api::denseArray(name, "m", real, one, layers.depth);
    case Layer::position:
      return api::denseArray(name, "m", real, many(3), layers.position);
    case Layer::normal:
      return api::denseArray(name, "", real, many(3), layers.normal);
    case Layer::albedo:
      return api::denseArray(name, "", real, many(3), layers.albedo);
    case Layer::uv:
      return api::denseArray(name, "", real, many(2), layers.uv);
    case Layer::velocity:
      return api::denseArray(name, "m/s", real, many(3), layers.velocity);
    case Layer::vector:
      return api::denseArray(name, "pixels", real, many(2), layers.vector);
    case Layer::primitive:
      return api::denseArray(name, "", NumberType::uint32, one, layers.primitive);
    case Layer::object:
      break;
  }
  return objectLayer(layers, one);
}

}  // namespace

std::vector<Array> Scene::layers(const std::vector<std::string>& names) {
  return state_->device->run([&] {
    std::vector<std::optional<Layer>> chosen;
    std::vector<Layer> wanted;
    for (const std::string& name : names) {
      chosen.push_back(layerNamed(name));
      if (!chosen.back()) continue;
      const bool moves = *chosen.back() == Layer::velocity || *chosen.back() == Layer::vector;
      if (moves && !state_->motion)
        api::fail(ErrorKind::usage,
                  fmt::format("the layer \"{}\" needs the frame before; load the scene with motion", name));
      wanted.push_back(*chosen.back());
    }
    const draw::PictureLayers layers = state_->layers(wanted);
    std::vector<Array> arrays;
    for (std::size_t i = 0; i < names.size(); ++i)
      arrays.push_back(layerArray(layers, names[i], chosen[i]));
    return arrays;
  });
}

std::vector<std::string> Scene::layerObjects() const {
  return state_->layerObjects;
}

}  // namespace simreel
