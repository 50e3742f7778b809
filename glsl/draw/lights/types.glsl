// Lamp: one entry of a scene's "lights", in the layout that shaders read. Compiles as GLSL and as C++
// (src/draw/lights), std140 layout.
#ifndef DRAW_LIGHTS_TYPES
#define DRAW_LIGHTS_TYPES

struct STD140 Lamp {
  vec4 place;     // xyz: position (m); w: radius of the luminous ball (m)
  vec4 power;     // rgb: luminous intensity / pi (cd); w: 1 / radius^2 (1/m^2)
  vec4 maps;      // location of the lamp's six shadow maps in the atlas. xy: size of one map; z: lower edge of the row,
                  // all as fractions of the atlas; w: fraction of a map's side that spans 90 degrees (the rest is
                  // margin for the filter)
  vec4 sampling;  // x: distance of the nearest caster (m); y: texel size of a map at distance 1 (m); z: filter radius
                  // (texels); w: 1 / texels per side of a map
  vec4 across;    // xyz: for a rectangle, half its width vector (m); for a ball, 0. w: 1 / range^2 (1/m^2), or 0
                  // without a range
  vec4 up;        // for a rectangle, xyz: half its height vector (m), w: 1 / its area (1/m^2); for a ball, 0
  vec4 cone;      // for a spotlight, the fraction of light is clamp(w + dot(xyz, direction from the lamp), 0, 1)^2; for
                  // other lamps, xyz is 0 and w is 1
};

const int lampTexels = 7;  // vec4 texels per Lamp in a buffer
const int lampFaces = 6;   // number of shadow maps of a lamp
// Size of the grid whose cells store the lamps that have the cell within their range.
const int lampCellsAcross = 16, lampCellsUp = 8;
// Number of words before the cells: three floats for the corner of the grid, three for cells per metre, two unused
// words.
const int lampCellHead = 8;

#endif
