// What every pass reads of one frame. Compiles as GLSL and as C++ (src/draw/frame_values.cpp), std140.
// Directions are world space, unit length; light is linear RGB.
#ifndef DRAW_FRAME
#define DRAW_FRAME

struct STD140 Frame {
  mat4 viewProjection;
  vec4 eye;                // xyz camera position (m), w 1; of a camera whose rays are parallel they come from there whatever place
                           //     they go to, w 0: xyz - w p is the way from a place p to the eye
  vec4 target;             // xyz what the camera looks at
  vec4 sunDirection;       // xyz towards the light
  vec4 sunLight;           // rgb irradiance / pi
  vec4 ambientUp;          // rgb irradiance / pi on a surface facing up,
  vec4 ambientSide;        //     sideways
  vec4 ambientDown;        //     and down
  vec4 zenith;             // rgb sky radiance overhead,
  vec4 horizon;            //     at the horizon
  vec4 nadir;              //     and below
  vec4 rayForward;         // xyz direction of the middle of the picture; add rayRight * x + rayUp * y, where x and y
  vec4 rayRight;           //     run from -1 to 1 over the picture
  vec4 rayUp;
  vec4 lightRight;         // xyz first axis across the light
  vec4 lightUp;            // xyz second axis
  vec4 groundColor;        // rgb albedo
  vec4 whiteRed;           // rgb what red light of 1 becomes by the white balance,
  vec4 whiteGreen;         //     green,
  vec4 whiteBlue;          //     and blue
  vec2 size;               // of the picture (pixels)
  float exposure;          // factor
  float vignette;
  float sunGlow;           // factor of the glow around the sun
  float ambient;           // factor on the light that falls from the sky onto surfaces
  float shadowTexels;      // on a side of the shadow map
  float shadowSoftness;    // radius of the shadow's filter (texels)
  float sunSpread;         // tangent of half the sun's angular diameter
  float shadowReach;       // how far from its caster's edge a shadow may reach (texels)
  float groundHeight;      // m
  float groundRoughness;
  float groundReach;       // half the side of the drawn square (m)
  float groundFadeStart;   // distance from the target where the ground begins to fade (m)
  float perGroundFade;     // 1/width of the fade (1/m)
};

#endif
