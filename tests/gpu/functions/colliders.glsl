#include "collide/field_types.glsl"
#include "collide/types.glsl"

struct Stepped {
  Collider colliders[3];
  int colliderCount;
  float dt;
};
Stepped stepData;
MeshColliders meshData;

// Returns four field distances between -6 and 6 units.
FUNCTION uvec4 loadFieldCell(int i) {
  uvec3 a = diced(i, 20), b = diced(i, 21);
  return uvec4(a.x, a.y, b.x, b.y) % 786432u - 393216u + (uvec4(a.z, b.z, b.x, a.x) >> 16u) % 12u;
}

#include "collide/model.glsl"

FUNCTION void prepare(int i) {
  stepData.dt = 0.125f;
  stepData.colliderCount = 3;
  for (int k = 0; k < 3; ++k) {
    stepData.colliders[k].a = vec4(somePlace(i, 30 + k), 0.0f);
    stepData.colliders[k].b = k == 1 ? stepData.colliders[k].a : vec4(somePlace(i, 40 + k), 0.0f);
    precise vec3 axis = vec3(stepData.colliders[k].b) - vec3(stepData.colliders[k].a);
    float square = exactDot(axis, axis);
    stepData.colliders[k].perLengthSquared = square > 0.0f ? exactReciprocal(square) : 0.0f;
    stepData.colliders[k].velocityA = vec4(somePlace(i, 50 + k), 0.0f);
    stepData.colliders[k].velocityB = vec4(somePlace(i, 60 + k), 0.0f);
    stepData.colliders[k].reach = 0.25f;
    stepData.colliders[k].grip = 0.5f;
    stepData.colliders[k].plane = 0;
    stepData.colliders[k].friction = float(someOf(i, 70 + k, 3) - 1) * 0.5f;
  }
  if (i % 2 == 0) {
    stepData.colliders[2].a = vec4(0.6f, 0.0f, 0.8f, 0.0f);
    stepData.colliders[2].plane = 1;
  }
  // The mesh is rotated by 90 degrees about y, which maps x to z and z to -x.
  meshData.count = 1;
  meshData.meshes[0].into[0] = vec4(0.0f, 0.0f, -1.0f, 0.25f);
  meshData.meshes[0].into[1] = vec4(0.0f, 1.0f, 0.0f, -0.125f);
  meshData.meshes[0].into[2] = vec4(1.0f, 0.0f, 0.0f, 0.0f);
  meshData.meshes[0].rate[0] = vec4(0.0f, 0.5f, 0.0f, 0.25f);
  meshData.meshes[0].rate[1] = vec4(-0.5f, 0.0f, 0.0f, 0.0f);
  meshData.meshes[0].rate[2] = vec4(0.0f, 0.0f, 0.0f, -0.5f);
  meshData.meshes[0].corner = vec4(-0.5f, -0.75f, -0.5f, 2.0f);
  meshData.meshes[0].cells = ivec4(2, 3, 2, 5);
  meshData.meshes[0].cell = 0.5f;
  meshData.meshes[0].unit = 0.0625f;
  meshData.meshes[0].grip = 0.75f;
  meshData.meshes[0].friction = float(someOf(i, 80, 3) - 1) * 0.5f;
}

// Tests the analytic shapes, the distance field by itself, and the resolution of mesh penetrations after short moves,
// long moves and moves from the side.
FUNCTION vec4 asked(int i) {
  prepare(i);
  Motion m;
  m.position = somePlace(i, 0);
  m.velocity = 4.0f * somePlace(i, 1);
  precise vec3 near = m.position - m.velocity * 0.03125f;
  precise vec3 within = 0.5f * somePlace(i, 2);
  vec3 before = i % 5 < 2 ? near : i % 5 == 2 ? 8.0f * within : within;
  if (i % 3 == 0) {
    FieldPoint p = fieldAt(0, 1.5f * m.position);
    return vec4(p.slope, p.there ? p.distance_ : -1.0f - p.distance_);
  }
  m = i % 3 == 1 ? outOfShapes(m, before, 0.0625f, 0.25f) : outOfMesh(0, m, before, 0.0625f, 0.25f);
  return i % 2 == 0 ? vec4(m.position, m.velocity.x) : vec4(m.velocity, m.position.x);
}
