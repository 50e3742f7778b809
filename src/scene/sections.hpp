#pragma once
#include "scene/scene.hpp"
#include "scene/value/fields.hpp"

#include <functional>
#include <optional>
#include <span>

namespace simreel::scene {

inline constexpr std::size_t maxObjects = 1000;

/// Declares all members of a scene except "$schema", "version", "objects", "test" and "checks".
void describeScene(Fields& fields, Scene& scene);
/// Declares "test" and "checks". The scene's objects must have been read. `frameCount`: number of frames of
/// the scene; nullopt if test frames must not be checked against it.
void describeTests(Fields& fields, Scene& scene, std::optional<int> frameCount);

inline constexpr const char* testDoc =
    "Frames and bounds for \"simreel test\", which compares them with baselines.";
inline constexpr const char* checksDoc = "Conditions on states and pictures that \"simreel test\" checks.";

/// Section of a scene that has its own help page.
struct Section {
  const char* name;
  const char* doc;
  std::function<void(Fields&)> describe;
};
/// The sections render, time, camera, panels, stage, sun, sky, ground, lights, material, test and checks,
/// with their defaults.
[[nodiscard]] std::span<const Section> sections();

}  // namespace simreel::scene
