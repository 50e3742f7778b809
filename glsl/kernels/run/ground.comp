// Computes the vertices of a terrain from the heights of a user's grid. One invocation per vertex. Vertices between
// the heights lie on a Catmull-Rom surface through them, which continues straight beyond the borders.
#include "common/exact.glsl"
#include "common/memory.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(0, HeightBlock, heights)  // x: height value
STATE_ARRAY(1, VertexBlock, vertices)
uniform ivec2 given;  // number of heights along x and z
uniform int finer;    // number of steps between vertices from one height to the next
uniform vec3 corner;  // position of vertex (0, 0) at the height 0, m
uniform float cell;   // distance between vertices, m
uniform float scale;  // height in metres per unit of the height value

float between(float a, float b, float c, float d, float t) {
  precise float first = c - a;
  precise float second = 2.0 * a - 5.0 * b + 4.0 * c - d;
  precise float third = 3.0 * (b - c) + d - a;
  precise float value = b + 0.5 * t * (first + t * (second + t * third));
  return value;
}

float heightAt(int x, int z) {
  return LOAD_INPUT(heights, z * given.x + x).x;
}

// Returns the height in row z at x + t, where t is a fraction.
float onRow(int x, float t, int z) {
  if (t == 0.0) return heightAt(x, z);
  float b = heightAt(x, z), c = heightAt(x + 1, z);
  precise float before = x > 0 ? heightAt(x - 1, z) : 2.0 * b - c;
  precise float behind = x + 2 < given.x ? heightAt(x + 2, z) : 2.0 * c - b;
  return between(before, b, c, behind, t);
}

void main() {
  ivec2 size = (given - 1) * finer + 1;
  int i = int(gl_GlobalInvocationID.x);
  if (i >= size.x * size.y) return;
  ivec2 at = ivec2(i % size.x, i / size.x);
  ivec2 from = at / finer;
  precise vec2 t = vec2(at - from * finer) * exactReciprocal(float(finer));
  float height = onRow(from.x, t.x, from.y);
  if (t.y > 0.0) {
    float next = onRow(from.x, t.x, from.y + 1);
    precise float before = from.y > 0 ? onRow(from.x, t.x, from.y - 1) : 2.0 * height - next;
    precise float behind = from.y + 2 < given.y ? onRow(from.x, t.x, from.y + 2) : 2.0 * next - height;
    height = between(before, height, next, behind, t.y);
  }
  precise float x = corner.x + float(at.x) * cell;
  precise float y = corner.y + height * scale;
  precise float z = corner.z + float(at.y) * cell;
  STORE_STATE(vertices, i, vec4(x, y, z, 1.0));
}
