#include "draw/bindings.glsl"
#include "draw/frame.glsl"
#ifdef EXACT_PICTURE
#include "common/once.glsl"
layout(std140, binding = frameBinding) uniform FrameBlock {
  Frame frameBlock;
};
Frame frameOnce() {  // Reads each member of Frame once (common/once.glsl).
  Frame one;
  one.viewProjection = once(frameBlock.viewProjection);
  one.eye = once(frameBlock.eye);
  one.target = once(frameBlock.target);
  one.sunDirection = once(frameBlock.sunDirection);
  one.sunLight = once(frameBlock.sunLight);
  one.ambientUp = once(frameBlock.ambientUp);
  one.ambientSide = once(frameBlock.ambientSide);
  one.ambientDown = once(frameBlock.ambientDown);
  one.zenith = once(frameBlock.zenith);
  one.horizon = once(frameBlock.horizon);
  one.nadir = once(frameBlock.nadir);
  one.rayForward = once(frameBlock.rayForward);
  one.rayRight = once(frameBlock.rayRight);
  one.rayUp = once(frameBlock.rayUp);
  one.lightRight = once(frameBlock.lightRight);
  one.lightUp = once(frameBlock.lightUp);
  one.groundColor = once(frameBlock.groundColor);
  one.whiteRed = once(frameBlock.whiteRed);
  one.whiteGreen = once(frameBlock.whiteGreen);
  one.whiteBlue = once(frameBlock.whiteBlue);
#ifdef HAZE
  one.haze = once(frameBlock.haze);
  one.hazeColor = once(frameBlock.hazeColor);
#endif
  one.size = once(frameBlock.size);
  one.exposure = once(frameBlock.exposure);
  one.vignette = once(frameBlock.vignette);
  one.sunGlow = once(frameBlock.sunGlow);
  one.ambient = once(frameBlock.ambient);
  one.shadowTexels = once(frameBlock.shadowTexels);
  one.shadowSoftness = once(frameBlock.shadowSoftness);
  one.sunSpread = once(frameBlock.sunSpread);
  one.shadowReach = once(frameBlock.shadowReach);
  one.groundHeight = once(frameBlock.groundHeight);
  one.groundRoughness = once(frameBlock.groundRoughness);
  one.groundReach = once(frameBlock.groundReach);
  one.groundFadeStart = once(frameBlock.groundFadeStart);
  one.perGroundFade = once(frameBlock.perGroundFade);
  return one;
}
Frame frame = frameOnce();
#else
layout(std140, binding = frameBinding) uniform FrameBlock {
  Frame frame;
};
#endif
