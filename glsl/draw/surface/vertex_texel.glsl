// Reads a vertex of a sim::Surface in object space: a stored position, or a point of a height grid.
layout(binding = positionUnit) uniform samplerBuffer positions;
uniform ivec4 heightShape;  // xy: number of vertices along x and z (x 0: no grid, positions are stored); z: component
                            // that holds the height; w: bit mask of the sides where the height is at least heightRim
uniform vec4 heightGrid;    // for grids: x and z of the first vertex, spacing, level of height 0 (m)
uniform float heightRim;    // min height at the rim of the grid (m)

vec3 vertexPlace(int i) {
  vec4 texel = texelFetch(positions, i);
  ivec4 shape = heightShape;
  if (shape.x == 0) return texel.xyz;
  int z = i / shape.x;
  int x = i - z * shape.x;
  float height = shape.z == 3 ? texel.w : texel.y;
  int side = (x == 0 ? 1 : 0) | (x == shape.x - 1 ? 2 : 0) | (z == 0 ? 4 : 0) | (z == shape.y - 1 ? 8 : 0);
  if ((side & shape.w) != 0) height = max(height, heightRim);
  precise float px = heightGrid.x + float(x) * heightGrid.z;
  precise float py = heightGrid.w + height;
  precise float pz = heightGrid.y + float(z) * heightGrid.z;
  return vec3(px, py, pz);
}

#ifdef PALETTE
layout(binding = vertexColorUnit) uniform samplerBuffer vertexColors;
uniform int colorComponent;  // component of the texel that holds the colour index: x for 0, otherwise w

// Returns the index of the vertex's colour in the palette.
int vertexColor(int i) {
  vec4 texel = texelFetch(vertexColors, i);
  return int(colorComponent == 0 ? texel.x : texel.w);
}
#endif
