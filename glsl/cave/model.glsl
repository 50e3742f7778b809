// Rules of the cave automaton on words of 32 cells, bit 0 leftmost; a set bit is rock. Compiles as GLSL and, through
// common/cpp.hpp, as C++, after common/hash.glsl.

const uint nowhere = 0xffffffffu;

// True if a cell starts as rock: always on the border, otherwise with the probability threshold / 2^32.
FUNCTION bool startsAsRock(int x, int y, ivec2 size, uint seed, uint threshold) {
  bool border = x <= 0 || y <= 0 || x >= size.x - 1 || y >= size.y - 1;
  return border || hash3(uvec3(uint(x), uint(y), seed)).x < threshold;
}

// Sum of three bits: one + 2 two.
struct BitSum {
  uint one, two;
};
FUNCTION BitSum sumOf(uint a, uint b, uint c) {
  BitSum sum;
  sum.one = a ^ b ^ c;
  sum.two = (a & b) | (c & (a ^ b));
  return sum;
}

// Returns the sum of each cell with its left and right neighbour. `before` and `after` are the adjacent words.
FUNCTION BitSum rowSum(uint before, uint here, uint after) {
  return sumOf((here << 1u) | (before >> 31u), here, (here >> 1u) | (after << 31u));
}

// Returns rock for cells with at least 5 rock cells in the 3x3 neighbourhood. The count is ones + 2 twos, with twos
// from 0 to 4.
FUNCTION uint mostlyRock(BitSum above, BitSum here, BitSum below) {
  BitSum ones = sumOf(above.one, here.one, below.one);
  BitSum twos = sumOf(above.two, here.two, below.two);
  // Set where at least three of the four twos are set
  uint three = twos.two & (twos.one | ones.two);
  uint exactlyTwo = (twos.two & ~twos.one & ~ones.two) | (~twos.two & twos.one & ones.two);
  return three | (exactlyTwo & ones.one);
}
