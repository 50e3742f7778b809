// Brush stroke in space: a sphere swept from one position to another. Compiles as GLSL and as C++
// (src/sim/reaction/brushes.hpp).
struct Brush {
  vec3 from;         // Start of the path, in cells of a volume or in the coordinates of a mesh's cell positions
  vec3 to;
  float radius2;
  float perLength2;  // 1 / squared length of the path, or 0 for a point
};

// Returns true if the position is inside the brush. Same as strokeReaches() of grid/stroke.glsl, with a third axis.
FUNCTION bool brushReaches(Brush b, vec3 place) {
  precise float px = place.x - b.from.x;
  precise float py = place.y - b.from.y;
  precise float pz = place.z - b.from.z;
  precise float dx = b.to.x - b.from.x;
  precise float dy = b.to.y - b.from.y;
  precise float dz = b.to.z - b.from.z;
  precise float along = (px * dx + py * dy + pz * dz) * b.perLength2;
  along = clamp(along, 0.0f, 1.0f);
  precise float qx = px - along * dx;
  precise float qy = py - along * dy;
  precise float qz = pz - along * dz;
  precise float distance2 = qx * qx + qy * qy + qz * qz;
  return distance2 <= b.radius2;
}
