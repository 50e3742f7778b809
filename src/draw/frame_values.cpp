#include "draw/frame_values.hpp"

#include "base/ieee.hpp"
#include "draw/black_body.hpp"
#include "draw/camera.hpp"
#include "gl/context.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace simreel::draw {

namespace {

constexpr double radiansPerDegree = 0.017453292519943295;
/// Max width of a penumbra, as a fraction of the shadow map's side. The map has a margin of this width
/// around the casters.
constexpr float penumbraShare = 0.12F;

void setSun(shader::Frame& frame, const scene::Sun& sun, double seconds) {
  const glm::vec3 given = sun.direction.at(seconds);
  const glm::vec3 direction = glm::length(given) > 1e-6F ? glm::normalize(given) : glm::vec3(0, 1, 0);
  const glm::vec3 helper = std::abs(direction.y) > 0.9F ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
  const glm::vec3 right = glm::normalize(glm::cross(helper, direction));
  frame.sunDirection = glm::vec4(direction, 0);
  frame.sunGlow = 0.12F;
  const glm::vec3 color = sun.temperature ? blackBodyColor(*sun.temperature) : sun.color.at(seconds);
  frame.sunLight = glm::vec4(color * (sun.intensity.at(seconds) * 0.31830989F), 0);
  frame.lightRight = glm::vec4(right, 0);
  frame.lightUp = glm::vec4(glm::cross(direction, right), 0);
  frame.shadowTexels = static_cast<float>(sun.shadowSize);
  frame.shadowSoftness = sun.shadowSoftness;
  frame.sunSpread = static_cast<float>(ieee::tan(0.5 * radiansPerDegree * sun.diameter));
  frame.shadowReach = sun.diameter > 0 ? std::max(sun.shadowSoftness, penumbraShare * frame.shadowTexels)
                                       : sun.shadowSoftness;
}

/// Sets sky and ambient light. The exact cosine-weighted mean of the gradient in glsl/draw/sky.glsl would
/// be close to the zenith colour. Shadows would then be too blue, because the gradient contains no clouds
/// and no haze near the sun. The horizon therefore gets a larger weight.
void setSky(shader::Frame& frame, const scene::Sky& sky, double seconds) {
  const glm::vec3 zenith = sky.zenith.at(seconds);
  const glm::vec3 horizon = sky.horizon.at(seconds);
  const glm::vec3 ground = sky.ground.at(seconds);
  const float ambient = sky.ambient.at(seconds);
  frame.ambient = ambient;
  frame.zenith = glm::vec4(zenith, 0);
  frame.horizon = glm::vec4(horizon, 0);
  frame.nadir = glm::vec4(ground, 0);
  frame.ambientUp = glm::vec4(ambient * glm::mix(zenith, horizon, 0.3F), 0);
  frame.ambientSide = glm::vec4(ambient * (0.5F * glm::mix(zenith, horizon, 0.45F) + 0.5F * ground), 0);
  frame.ambientDown = glm::vec4(ambient * ground, 0);
}

void setGround(shader::Frame& frame, const scene::Ground& ground) {
  frame.groundColor = glm::vec4(ground.color, 0);
  frame.groundHeight = ground.height;
  frame.groundRoughness = ground.roughness;
  frame.groundReach = std::max(ground.fadeEnd, ground.fadeStart);
  frame.groundFadeStart = ground.fadeStart;
  frame.perGroundFade = 1.0F / std::max(ground.fadeEnd - ground.fadeStart, 1e-3F);
}

void setHaze(shader::Frame& frame, const scene::Scene& scene, double seconds) {
  if (!scene.haze) return;
  const scene::Haze& haze = *scene.haze;
  frame.haze = {1 / haze.distance.at(seconds), haze.height ? 1 / static_cast<float>(*haze.height) : 0.0F,
                haze.start, scene.ground ? scene.ground->height : 0.0F};
  if (haze.color) frame.hazeColor = glm::vec4(haze.color->at(seconds), 0);
}

}  // namespace

shader::Frame frameValues(const scene::Scene& scene, glm::ivec2 size, double seconds,
                          const sim::Drawables& drawables) {
  shader::Frame frame{};
  const View view = viewAt(scene.camera, seconds, size, drawables, visibleGround(scene));
  frame.viewProjection = view.viewProjection;
  // In orthographic views the eye is so far away that rays are almost parallel. eye.w is 0, so shaders use
  // the same view direction at all positions.
  constexpr float far = 1e6F;
  frame.eye = view.parallel ? glm::vec4(-far * view.forward, 0) : glm::vec4(view.eye, 1);
  frame.target = glm::vec4(view.target, 0);
  frame.rayForward = glm::vec4(view.forward, 0);
  frame.rayRight = glm::vec4(view.parallel ? view.right / far : view.right, 0);
  frame.rayUp = glm::vec4(view.parallel ? view.up / far : view.up, 0);
  setSun(frame, scene.sun, seconds);
  setSky(frame, scene.sky, seconds);
  setGround(frame, scene.ground.value_or(scene::Ground()));
  setHaze(frame, scene, seconds);
  if (!visibleGround(scene)) frame.groundReach = 0;
  frame.size = size;
  frame.exposure = static_cast<float>(ieee::exp2(static_cast<double>(scene.render.exposure.at(seconds))));
  frame.vignette = scene.render.vignette;
  const glm::mat3 balance = scene.render.whiteBalance
                                ? whiteBalance(static_cast<double>(scene.render.whiteBalance->at(seconds)))
                                : glm::mat3(1);
  frame.whiteRed = glm::vec4(balance[0], 0);
  frame.whiteGreen = glm::vec4(balance[1], 0);
  frame.whiteBlue = glm::vec4(balance[2], 0);
  return frame;
}

gl::Defines filmDefines(const scene::Render& render) {
  gl::Defines defines;
  if (render.tone != scene::Tone::aces)
    defines.emplace_back("TONE", std::to_string(static_cast<int>(render.tone)));
  if (render.whiteBalance) defines.emplace_back("WHITE_BALANCE", "1");
  return defines;
}

gl::Defines withFrame(gl::Defines defines) {
  if (gl::memoryPath() == gl::MemoryPath::texel) defines.emplace_back("PASSED_FRAME", "1");
  return defines;
}

}  // namespace simreel::draw
