// Returns the surface to which a triangle of joined surfaces belongs (join.comp).
layout(binding = ownerUnit) uniform usamplerBuffer owners;
int ownerOf(uint number) {
  return int(texelFetch(owners, int(number)).x >> 1);
}
bool showsBothSides(uint number) {
  return (texelFetch(owners, int(number)).x & 1u) != 0u;
}
