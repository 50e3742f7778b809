// How the exact rasterizer sees the scene. Compiles as GLSL and as C++ (src/draw/exact), std140. Pixels count from the
// top left corner of the picture, to the right and down; depth is the distance from the eye along its direction. PARALLEL: of a camera
// whose rays all go along that; its eye is the middle of the plane that they come from.
#ifndef DRAW_EXACT_TYPES
#define DRAW_EXACT_TYPES

struct STD140 ExactView {
  vec4 eye;        // xyz (m); w of a lamp's map: its first row among those of all maps
  vec4 across;     // xyz: pixels to the right times depth (PARALLEL: from the middle, alone), for each metre from the eye; w: the
                   // map's first column there
  vec4 down;       // xyz: the same downwards
  vec4 forward;    // xyz: depth for each metre from the eye; unit; w, PARALLEL: how much less near what is 1 m farther away is, else 0
  vec4 ray;        // xyz: ray of depth 1 through the picture's top left corner (PARALLEL: where it begins, from the eye)
  vec4 rayAcross;  // xyz: what a pixel to the right adds to it
  vec4 rayDown;    // xyz: what a pixel downwards adds to it
  ivec2 size;      // of the picture (pixels)
  float near;      // m
  float nearOverFar;
  ivec2 rows;      // of the picture, from and to before which: the band whose visibility is being found
};
const int maxFaceViews = 48;  // of all lamps' maps

#endif
