#pragma once
#include "scene/scene.hpp"
#include "scene/value/fields.hpp"

#include <functional>
#include <optional>
#include <span>

namespace simreel::scene {

inline constexpr int sceneVersion = 1;
inline constexpr std::size_t maxObjects = 1000;

/// What a scene holds besides "$schema", "version", "objects" and its tests.
void describeScene(Fields& fields, Scene& scene);
/// "test" and "checks"; the scene's objects must be there. `frameCount`: the scene's length, or nothing
/// where frames cannot be held against it.
void describeTests(Fields& fields, Scene& scene, std::optional<int> frameCount);

inline constexpr const char* testDoc =
    "Frames and bounds for \"simreel test\", which compares them with baselines.";
inline constexpr const char* checksDoc = "Conditions on states and pictures that \"simreel test\" checks.";

/// A part of a scene that help is given for.
struct Section {
  const char* name;
  const char* doc;
  std::function<void(Fields&)> describe;
};
/// render, time, camera, stage, sun, sky, ground, lights, material, test and checks, with their defaults.
[[nodiscard]] std::span<const Section> sections();

}  // namespace simreel::scene
