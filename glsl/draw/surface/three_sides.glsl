// A surface seen along the three axes of its own space: where a picture that is laid on from there lies, and how much of
// each of the three shows.
in vec3 objectPosition;  // m
in vec3 objectNormal;

// Along x, y and z, m: to the right and down as it is seen from outside.
struct ThreeSides {
  vec3 side;  // 1 or -1: from where each is seen
  vec2 x, y, z;
  vec3 weight;  // of sum 1
};

ThreeSides threeSides() {
  ThreeSides three;
  vec3 p = objectPosition;
  three.side = vec3(greaterThan(objectNormal, vec3(0))) * 2.0 - 1.0;
  three.x = vec2(-three.side.x * p.z, -p.y);
  three.y = vec2(p.x, three.side.y * p.z);
  three.z = vec2(three.side.z * p.x, -p.y);
  vec3 weight = objectNormal * objectNormal;  // to the 16th power: sharp borders, yet no edges
  weight *= weight;
  weight *= weight;
  weight *= weight;
  three.weight = weight / max(weight.x + weight.y + weight.z, 1e-30);
  return three;
}
