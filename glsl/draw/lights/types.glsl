// A lamp: one of a scene's "lights" as shaders read it. Compiles as GLSL and as C++ (src/draw/lights), std140.
#ifndef DRAW_LIGHTS_TYPES
#define DRAW_LIGHTS_TYPES

struct STD140 Lamp {
  vec4 place;     // xyz position (m), w radius of the ball that shines (m)
  vec4 power;     // rgb luminous intensity / pi (cd), w 1 / radius^2 (1/m^2)
  vec4 maps;      // of its six shadow maps in the atlas: xy size of one, z where they begin upwards, all as fractions of
                  // the atlas; w fraction of a map's side that 90 degrees span, the rest being margin for the filter
  vec4 sampling;  // x distance of the nearest caster (m), y texel of a map at distance 1 (m), z filter's radius (texels),
                  // w 1 / texels on a side of a map
  vec4 across;    // of a rectangle: xyz half its width (m), 0 of a ball; w 1 / range^2 (1/m^2), 0: it has none
  vec4 up;        // xyz half its height (m), w 1 / its area (1/m^2)
  vec4 cone;      // xyz times the direction from a spot light, plus w: its share, within 0 and 1, before it is squared
};

const int lampTexels = 7;  // texels of a Lamp in a buffer of vec4
const int lampFaces = 6;   // shadow maps of a lamp
// Cells of the scene for which it is known which lamps with a range reach into them.
const int lampCellsAcross = 16, lampCellsUp = 8;
const int lampCellHead = 8;  // words before them: the box's corner and cells a metre, three floats each, and two of nothing

#endif
