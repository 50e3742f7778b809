// What every pass reads of one frame. Compiles as GLSL and as C++ (src/draw/frame_values.cpp). Only
// 16-byte members, so std140 and std430 agree. Directions are world space, unit length; light is linear RGB.
#ifndef DRAW_FRAME
#define DRAW_FRAME

struct Frame {
  mat4 viewProjection;
  vec4 eye;           // xyz camera position; w 1/fade width of the ground (1/m)
  vec4 target;        // xyz what the camera looks at; w distance where the ground begins to fade (m)
  vec4 sunDirection;  // xyz towards the light; w factor of the glow around the sun
  vec4 sunLight;      // rgb irradiance / pi
  vec4 ambientUp;     // rgb irradiance / pi on a surface facing up,
  vec4 ambientSide;   //     sideways
  vec4 ambientDown;   //     and down
  vec4 zenith;        // rgb sky radiance overhead,
  vec4 horizon;       //     at the horizon
  vec4 nadir;         //     and below
  vec4 rayForward;    // xyz direction of the middle of the picture; add rayRight * x + rayUp * y, where x and y
  vec4 rayRight;      //     run from -1 to 1 over the picture
  vec4 rayUp;
  vec4 lightRight;    // xyz first axis across the light; w texels on a side of the shadow map
  vec4 lightUp;       // xyz second axis; w radius of the shadow's filter (texels)
  vec4 groundColor;   // rgb albedo; w height (m)
  vec4 groundShape;   // x roughness, y half the side of the drawn square (m), z 1 if there is a ground
  vec4 lens;          // x exposure factor, y vignette, zw picture size (pixels)
};

#endif
