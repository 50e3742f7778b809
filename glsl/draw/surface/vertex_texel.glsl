// A vertex of a sim::Surface in its own space: as its positions hold it, or of a grid whose positions hold heights alone.
layout(binding = positionUnit) uniform samplerBuffer positions;
uniform ivec4 heightShape;  // vertices along x (0: positions) and z, component, bits of the sides where heightRim is the least
uniform vec4 heightGrid;    // x and z of the first vertex, spacing, height of 0 (m)
uniform float heightRim;    // m

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
uniform int colorComponent;  // x or w

// Its number in the palette.
int vertexColor(int i) {
  vec4 texel = texelFetch(vertexColors, i);
  return int(colorComponent == 0 ? texel.x : texel.w);
}
#endif
