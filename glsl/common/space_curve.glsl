// Sort keys along a space-filling curve: positions that are close in space are close in the sorted list. Compiles as
// GLSL and as C++, after common/exact.glsl.

// Returns the cell of a position in a grid of 65536 cells along each axis. The grid covers a cube with the side of the
// box from `low` to `high` that is longest.
FUNCTION uvec3 cellOf(vec3 position, vec3 low, vec3 high) {
  precise vec3 size = high - low;
  float side = max(size.x, max(size.y, size.z));
  precise float scale = 65536.0f * exactReciprocal(max(side, 1e-18f));
  precise vec3 at = (position - low) * scale;
  at = min(max(at, vec3(0.0f)), vec3(65535.0f));
  return uvec3(uint(at.x), uint(at.y), uint(at.z));
}

// Moves bit i of the lower eight bits to bit 3 i.
FUNCTION uint spread(uint bits) {
  uint b = bits & 0xffu;
  b = (b | (b << 8u)) & 0x00f00fu;
  b = (b | (b << 4u)) & 0x0c30c3u;
  b = (b | (b << 2u)) & 0x249249u;
  return b;
}

// Returns the index of a cell along a Hilbert curve through 65536^3 cells: x holds the lower 24 bits, y the upper 24.
// The curve has no jumps, so every sequence of consecutive sorted bodies is compact in space. From the top level down,
// the loop reflects or exchanges the lower bits to match the orientation of the curve in the octant; a Gray code then
// orders the octants (J. Skilling, "Programming the Hilbert curve", AIP Conf. Proc. 707, 2004).
FUNCTION uvec3 hilbertKey(uvec3 cell) {
  uint x = cell.x;
  uint y = cell.y;
  uint z = cell.z;
  for (int level = 15; level > 0; --level) {
    uint bit = 1u << uint(level);
    uint lower = bit - 1u;
    x = (x & bit) != 0u ? x ^ lower : x;
    uint swapped = (x ^ y) & lower;
    bool reflect = (y & bit) != 0u;
    x = x ^ (reflect ? lower : swapped);
    y = y ^ (reflect ? 0u : swapped);
    swapped = (x ^ z) & lower;
    reflect = (z & bit) != 0u;
    x = x ^ (reflect ? lower : swapped);
    z = z ^ (reflect ? 0u : swapped);
  }
  y = y ^ x;
  z = z ^ y;
  uint parity = z >> 1u;
  parity = parity ^ (parity >> 1u);
  parity = parity ^ (parity >> 2u);
  parity = parity ^ (parity >> 4u);
  parity = parity ^ (parity >> 8u);
  x = x ^ parity;
  y = y ^ parity;
  z = z ^ parity;
  uint low = (spread(x) << 2u) | (spread(y) << 1u) | spread(z);
  uint high = (spread(x >> 8u) << 2u) | (spread(y >> 8u) << 1u) | spread(z >> 8u);
  return uvec3(low, high, 0u);
}
