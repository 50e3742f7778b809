#pragma once
#include "scene/scene.hpp"

#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::scene {

/// Extent of an object that an automatically placed camera must show.
struct Framed {
  Box box;
  std::vector<glm::vec3> points = {};  ///< outermost points in metres; if empty, `box` is used
};

/// Returns the extent to show, or nullopt if the object's parameters define no extent (Parameters::framed,
/// DrawnOn, FramedInPart). `all`: all objects of the scene.
[[nodiscard]] std::optional<Framed> framedOf(const Object& object, std::span<const Object> all);
/// Returns the extents of all objects that have one.
[[nodiscard]] std::vector<Framed> framedObjects(const Scene& scene);
/// Returns the smallest box around all extents. `framed` must not be empty.
[[nodiscard]] Box boxAround(const std::vector<Framed>& framed);

/// Moves objects whose place the scene leaves out, such as text, above all others (SetApart), one above the
/// other.
void setApart(Scene& scene);

/// Returns the widths of the strips at the right and at the bottom, as fractions of the picture, that
/// objects over the picture need (TakesRoom). Returns 0 for a picture of panels.
[[nodiscard]] glm::vec2 roomBeside(const Scene& scene);
/// Draws the fields that cover the picture beside the objects that need room.
void makeRoom(Scene& scene);

/// If the scene does not place its camera, places it so that all extents are in view with a margin. Flat
/// scenes are seen from the front and above, tall scenes almost level and slightly from the side. On a
/// stage, the camera looks diagonally through a longer lens, and the visible extent is centred. A camera
/// that stands still and has no target leaves roomBeside() free.
void frameObjects(Scene& scene, const std::vector<Framed>& framed);

/// Returns the unit vector from the objects on a stage to the camera.
[[nodiscard]] glm::vec3 stageBack(const Box& box);

}  // namespace simreel::scene
