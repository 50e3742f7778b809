// Uniform values of one frame. All passes read them. Compiles as GLSL and as C++ (src/draw/frame_values.cpp), std140
// layout. Directions are unit vectors in world space; light is linear RGB.
#ifndef DRAW_FRAME
#define DRAW_FRAME

struct STD140 Frame {
  mat4 viewProjection;
  vec4 eye;                // xyz - w p points from p to the eye. Perspective camera: xyz is the position (m) and w is
                           // 1. Orthographic camera: xyz is a point very far behind the camera and w is 0.
  vec4 target;             // xyz: point that the camera looks at
  vec4 sunDirection;       // xyz: direction towards the sun
  vec4 sunLight;           // rgb: irradiance / pi of the sun
  vec4 ambientUp;          // rgb: ambient irradiance / pi on a surface that faces up
  vec4 ambientSide;        // rgb: ambient irradiance / pi on a surface that faces sideways
  vec4 ambientDown;        // rgb: ambient irradiance / pi on a surface that faces down
  vec4 zenith;             // rgb: sky radiance overhead
  vec4 horizon;            // rgb: sky radiance at the horizon
  vec4 nadir;              // rgb: sky radiance below the horizon
  vec4 rayForward;         // xyz: ray through the picture's centre; the ray at x, y (-1 to 1) is rayForward + rayRight
                           // x + rayUp y
  vec4 rayRight;           // xyz: vector to the right with the length of half the picture's width at depth 1
  vec4 rayUp;
  vec4 lightRight;         // xyz: first axis perpendicular to the sun's direction
  vec4 lightUp;            // xyz: second axis perpendicular to the sun's direction
  vec4 groundColor;        // rgb: albedo of the ground
  vec4 whiteRed;           // rgb: result of the white balance for red light of 1
  vec4 whiteGreen;         // rgb: result of the white balance for green light of 1
  vec4 whiteBlue;          // rgb: result of the white balance for blue light of 1
  vec4 haze;               // x: extinction at the height w (1/m), y: 1 / scale height (1/m), 0 if uniform, z: radius of
                           // the clear air around the eye (m), w: height of the ground (m)
  vec4 hazeColor;          // rgb: radiance of dense haze, if the scene gives its colour
  vec2 size;               // picture size in pixels
  float exposure;          // exposure: factor on the light
  float vignette;
  float sunGlow;           // factor on the glow around the sun
  float ambient;           // factor on the sky's light on surfaces
  float shadowTexels;      // side of the sun's shadow map in texels
  float shadowSoftness;    // radius of the shadow filter in texels
  float sunSpread;         // tangent of half the sun's angular diameter
  float shadowReach;       // max distance (texels) of a penumbra from the caster's edge
  float groundHeight;      // height of the ground plane in metres
  float groundRoughness;
  float groundReach;       // half the side of the ground square (m)
  float groundFadeStart;   // distance from the target at which the ground starts to fade, in metres
  float perGroundFade;     // 1 / width of the fade, in 1/m
};

#endif
