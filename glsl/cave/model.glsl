// Rules of the cave automaton on words of 32 cells, where bit 0 is the leftmost cell and a set bit is rock. Compiles as
// GLSL and, through common/cpp.hpp, as C++, after common/hash.glsl.

const uint nowhere = 0xffffffffu;

// Returns true if a cell is rock initially: always on the border, otherwise with the probability threshold / 2^32.
FUNCTION bool startsAsRock(int x, int y, ivec2 size, uint seed, uint threshold) {
  bool border = x <= 0 || y <= 0 || x >= size.x - 1 || y >= size.y - 1;
  return border || hash3(uvec3(uint(x), uint(y), seed)).x < threshold;
}

// Sum of three bits, one + 2 two, for each of 32 cells.
struct BitSum {
  uint one, two;
};
FUNCTION BitSum sumOf(uint a, uint b, uint c) {
  BitSum sum;
  sum.one = a ^ b ^ c;
  sum.two = (a & b) | (c & (a ^ b));
  return sum;
}

// Returns for each cell the sum of the cell, its left neighbour and its right neighbour. `before` and `after` are the
// adjacent words.
FUNCTION BitSum rowSum(uint before, uint here, uint after) {
  return sumOf((here << 1u) | (before >> 31u), here, (here >> 1u) | (after << 31u));
}

// Returns a word with rock at the cells that have at least 5 rock cells in their 3x3 neighbourhood. The number of rock
// cells is ones + 2 twos, where twos is between 0 and 4.
FUNCTION uint mostlyRock(BitSum above, BitSum here, BitSum below) {
  BitSum ones = sumOf(above.one, here.one, below.one);
  BitSum twos = sumOf(above.two, here.two, below.two);
  // A bit is set if at least three of the four twos are set
  uint three = twos.two & (twos.one | ones.two);
  uint exactlyTwo = (twos.two & ~twos.one & ~ones.two) | (~twos.two & twos.one & ones.two);
  return three | (exactlyTwo & ones.one);
}

// Returns the fraction at which a changing cell passes the contour's level, in 1024ths between 256 and 768. Cells beside
// many cells of the new kind are first. The hash separates cells with equal neighbours, because the contour would jump
// where a whole block of cells passes the level at once.
FUNCTION uint turningPoint(uint newAround, uint hash) {
  return 544u - 32u * newAround + (hash >> 16u) % 193u;
}
// Returns the value, 0 for open and 1 for rock, of a cell that has the bit `before` at fraction 0 and the bit `now` at
// fraction 1. `newAround` is the number of cells, of the 8 around it, that had the bit `now` at fraction 0.
FUNCTION float blendedCell(uint before, uint now, uint newAround, uint hash, float fraction) {
  if (before == now) return float(now);
  precise float turn = 0.0009765625f * float(turningPoint(newAround, hash));
  precise float since = 2.0f * (fraction - turn);
  precise float value = now == 1u ? 0.5f + since : 0.5f - since;
  return clamp(value, 0.0f, 1.0f);
}
