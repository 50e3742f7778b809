#pragma once
#include "scene/fields.hpp"
#include "scene/scene.hpp"

#include <functional>
#include <span>

namespace simreel::scene {

inline constexpr int sceneVersion = 1;
inline constexpr std::size_t mostObjects = 1000;

/// What a scene holds besides "$schema", "version" and "objects".
void describeScene(Fields& fields, Scene& scene);

/// A part of a scene that help is given for.
struct Section {
  const char* name;
  const char* doc;
  std::function<void(Fields&)> describe;
};
/// render, time, camera, sun, sky, ground and material, with their defaults.
[[nodiscard]] std::span<const Section> sections();

}  // namespace simreel::scene
