// A block of 2x2 cells with the openings around it, as an invocation keeps it, so that it is loaded once for all that is done with it. On
// a torus there is an even number of cells around. After model.glsl and `weights`.
struct Block {
  uvec4 faces;        // of its cells, left and top
  uvec2 right, below; // of those right of it and below
  vec4 rhs;
  int inside;         // a bit for each of its cells that the grid has
};

// Which block of the grid that is.
ivec2 blockWithin(ivec2 block, ivec2 cells) {
#if LEFT == 4
  block.x = (block.x + 8 * (cells.x / 2)) % (cells.x / 2);
#endif
#if TOP == 4
  block.y = (block.y + 8 * (cells.y / 2)) % (cells.y / 2);
#endif
  return block;
}

// Its cells, as bits; `block` is within.
int cellsInside(ivec2 block, ivec2 cells) {
  ivec2 room = cells - 2 * block;
  if (block.x < 0 || block.y < 0 || room.x <= 0 || room.y <= 0) return 0;
  return (room.x > 1 ? 3 : 1) * (room.y > 1 ? 5 : 1);
}

// All but what is missing, of a block within; `start`: where the level's openings are.
Block blockAt(ivec2 block, ivec2 cells, int start) {
  Block b = Block(uvec4(0u), uvec2(0u), uvec2(0u), vec4(0.0), cellsInside(block, cells));
  int row = cells.x / 2 + 1, element = start + block.y * row + block.x;
  if (b.inside != 0) b.faces = LOAD_INPUT_WORDS(weights, element);
  if ((b.inside & 2) != 0) b.right = LOAD_INPUT_WORDS(weights, element + 1).xz;
  if ((b.inside & 4) != 0) b.below = LOAD_INPUT_WORDS(weights, element + row).xy;
  return b;
}

// Weights of the faces of its first cell and so on: left, right, top, bottom.
vec4 weights00(Block b) {
  vec2 own = faceWeights(b.faces.x);
  return vec4(own.x, faceWeights(b.faces.y).x, own.y, faceWeights(b.faces.z).y);
}
vec4 weights10(Block b) {
  vec2 own = faceWeights(b.faces.y);
  return vec4(own.x, faceWeights(b.right.x).x, own.y, faceWeights(b.faces.w).y);
}
vec4 weights01(Block b) {
  vec2 own = faceWeights(b.faces.z);
  return vec4(own.x, faceWeights(b.faces.w).x, own.y, faceWeights(b.below.x).y);
}
vec4 weights11(Block b) {
  vec2 own = faceWeights(b.faces.w);
  return vec4(own.x, faceWeights(b.right.y).x, own.y, faceWeights(b.below.y).y);
}

// Of x and w, the red cells; `beside`: left of the first, above it, right of the last and below it.
void sweepReds(Block b, inout vec4 here, vec4 beside) {
  vec4 w = weights00(b);
  here.x = (b.inside & 1) != 0 ? relaxed(b.rhs.x, neighbours(w, beside.x, here.y, beside.y, here.z), diagonal(w)) : 0.0;
  w = weights11(b);
  here.w = (b.inside & 8) != 0 ? relaxed(b.rhs.w, neighbours(w, here.z, beside.z, here.y, beside.w), diagonal(w)) : 0.0;
}

// On the way down, from nothing.
void sweepFirstReds(Block b, inout vec4 here) {
  here.x = (b.inside & 1) != 0 ? begun(b.rhs.x, diagonal(weights00(b))) : 0.0;
  here.w = (b.inside & 8) != 0 ? begun(b.rhs.w, diagonal(weights11(b))) : 0.0;
}

// Of y and z, the black cells; `beside`: right of the upper one, above it, left of the lower one and below it.
void sweepBlacks(Block b, inout vec4 here, vec4 beside) {
  vec4 w = weights10(b);
  here.y = (b.inside & 2) != 0 ? relaxed(b.rhs.y, neighbours(w, here.x, beside.x, beside.y, here.w), diagonal(w)) : 0.0;
  w = weights01(b);
  here.z = (b.inside & 4) != 0 ? relaxed(b.rhs.z, neighbours(w, beside.z, here.w, here.x, beside.w), diagonal(w)) : 0.0;
}

// What is missing then in the red cells, for the coarser level; `beside` as in sweepReds.
float leftInReds(Block b, vec4 here, vec4 beside) {
  float first = 0.0, last = 0.0;
  if ((b.inside & 1) != 0) first = residual(b.rhs.x, weights00(b), here.x, beside.x, here.y, beside.y, here.z);
  if ((b.inside & 8) != 0) last = residual(b.rhs.w, weights11(b), here.w, here.z, beside.z, here.y, beside.w);
  return restricted(first, last);
}

// Whether there is no coarse cell: beyond walls.
bool walledOff(ivec2 c, ivec2 count) {
  bool walled = false;
#if LEFT != 4
  walled = (c.x < 0 && LEFT != openSide) || (c.x >= count.x && RIGHT != openSide);
#endif
#if TOP != 4
  walled = walled || (c.y < 0 && TOP != openSide) || (c.y >= count.y && BOTTOM != openSide);
#endif
  return walled;
}

// Adds to its cells what the coarse cells say: the one that is this block, and those around it row by row.
void raiseBlock(Block b, inout vec4 here, vec3 above, vec3 middle, vec3 under) {
  here.x = (b.inside & 1) != 0 ? raised(here.x, prolonged(middle.y, middle.x, above.y, above.x)) : 0.0;
  here.y = (b.inside & 2) != 0 ? raised(here.y, prolonged(middle.y, middle.z, above.y, above.z)) : 0.0;
  here.z = (b.inside & 4) != 0 ? raised(here.z, prolonged(middle.y, middle.x, under.y, under.x)) : 0.0;
  here.w = (b.inside & 8) != 0 ? raised(here.w, prolonged(middle.y, middle.z, under.y, under.z)) : 0.0;
}
