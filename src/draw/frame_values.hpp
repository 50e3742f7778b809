#pragma once
#include "gl/program.hpp"
#include "glsl/common/cpp.hpp"
#include "scene/scene.hpp"
#include "sim/core/drawable.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

namespace simreel::shader {

using glm::mat4;
#include "glsl/draw/frame.glsl"

}  // namespace simreel::shader

namespace simreel::draw {

/// Everything of the scene that the passes read, at `seconds` of scene time.
[[nodiscard]] shader::Frame frameValues(const scene::Scene& scene, glm::ivec2 size, double seconds,
                                        const sim::Drawables& drawables);

/// Defines of a program with glsl/draw/screen/film.glsl and lens.glsl, for how light becomes a picture.
[[nodiscard]] gl::Defines filmDefines(const scene::Render& render);

/// Defines of a program both of whose shaders know glsl/draw/passed_frame.glsl: says where its fragments
/// find the frame's values.
[[nodiscard]] gl::Defines withFrame(gl::Defines defines);

}  // namespace simreel::draw
