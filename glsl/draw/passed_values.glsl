// Interface block with the members of Frame (frame.glsl) that fragment shaders read. The linker drops members that a
// fragment shader does not read.
PASSED PassedFrame {
  flat vec4 eye;
  flat vec4 target;
  flat vec4 sunDirection;
  flat vec4 sunLight;
  flat vec4 ambientUp;
  flat vec4 ambientSide;
  flat vec4 ambientDown;
  flat vec4 zenith;
  flat vec4 horizon;
  flat vec4 nadir;
  flat vec4 groundColor;
  flat vec4 whiteRed;
  flat vec4 whiteGreen;
  flat vec4 whiteBlue;
  flat vec2 size;
  flat float exposure;
  flat float vignette;
  flat float sunGlow;
  flat float shadowTexels;
  flat float shadowSoftness;
  flat float groundRoughness;
  flat float groundFadeStart;
  flat float perGroundFade;
} PASSED_NAME;
