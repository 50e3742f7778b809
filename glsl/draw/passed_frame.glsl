// Passes the frame's values from a vertex shader to fragment_frame.glsl. Must be included after frame_block.glsl.
#ifdef PASSED_FRAME
#define PASSED out
#define PASSED_NAME passed
#include "draw/passed_values.glsl"
#endif

void passFrame() {
#ifdef PASSED_FRAME
  passed.eye = frame.eye;
  passed.target = frame.target;
  passed.sunDirection = frame.sunDirection;
  passed.sunLight = frame.sunLight;
  passed.ambientUp = frame.ambientUp;
  passed.ambientSide = frame.ambientSide;
  passed.ambientDown = frame.ambientDown;
  passed.zenith = frame.zenith;
  passed.horizon = frame.horizon;
  passed.nadir = frame.nadir;
  passed.groundColor = frame.groundColor;
  passed.whiteRed = frame.whiteRed;
  passed.whiteGreen = frame.whiteGreen;
  passed.whiteBlue = frame.whiteBlue;
  passed.size = frame.size;
  passed.exposure = frame.exposure;
  passed.vignette = frame.vignette;
  passed.sunGlow = frame.sunGlow;
  passed.shadowTexels = frame.shadowTexels;
  passed.shadowSoftness = frame.shadowSoftness;
  passed.groundRoughness = frame.groundRoughness;
  passed.groundFadeStart = frame.groundFadeStart;
  passed.perGroundFade = frame.perGroundFade;
#endif
}
