// View of the exact rasterizer. Compiles as GLSL and as C++ (src/draw/exact), std140 layout. Pixels count from the
// picture's top left corner, to the right and down. Depth is the distance from the eye along the view direction.
// PARALLEL: all rays go along the view direction, and the eye is the centre of the plane where they start.
#ifndef DRAW_EXACT_TYPES
#define DRAW_EXACT_TYPES

struct STD140 ExactView {
  vec4 eye;        // xyz: position of the eye (m). For a lamp's shadow map, w: first row in the atlas
  vec4 across;     // xyz: its dot product with the vector from the eye (m) gives pixels to the right, times depth
                   // (PARALLEL: pixels from the centre). For a lamp's shadow map, w: first column in the atlas
  vec4 down;       // xyz: like `across`, for pixels downwards
  vec4 forward;    // xyz: unit view direction; its dot product with the vector from the eye gives the depth. w: 1 /
                   // depth range (1/m) if PARALLEL, otherwise 0
  vec4 ray;        // xyz: ray of depth 1 through the picture's top left corner (PARALLEL: start of that ray, relative
                   // to the eye)
  vec4 rayAcross;  // xyz: change of the ray per pixel to the right
  vec4 rayDown;    // xyz: change of the ray per pixel downwards
  ivec2 size;      // picture size in pixels
  float near;      // depth of the near plane in metres
  float nearOverFar;
  ivec2 rows;      // band of rows that is being rasterized: first row, end row (exclusive)
};
const int maxFaceViews = 48;  // max number of shadow map faces of all lamps

#endif
