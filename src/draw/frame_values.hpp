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

/// Returns the uniform values of a scene at `seconds` of scene time. All passes read them.
[[nodiscard]] shader::Frame frameValues(const scene::Scene& scene, glm::ivec2 size, double seconds,
                                        const sim::Drawables& drawables);

/// Returns the defines of programs that include glsl/draw/screen/film.glsl and lens.glsl, which convert
/// light to pictures.
[[nodiscard]] gl::Defines filmDefines(const scene::Render& render);

/// Returns `defines` with additions for programs whose vertex and fragment shaders include
/// glsl/draw/passed_frame.glsl. The additions select how fragments receive the frame's values.
[[nodiscard]] gl::Defines withFrame(gl::Defines defines);

}  // namespace simreel::draw
