// Block of 2x2 cells with the face openings around it. An invocation keeps it in registers, so that it is loaded only
// once. On a torus, the number of cells per axis must be even. Include after model.glsl and `weights`.
struct Block {
  uvec4 faces;        // Openings of the left and top faces of the block's cells
  uvec2 right, below; // Openings of the cells to the right of the block and of the cells below it
  vec4 rhs;
  int inside;         // Bit mask of the block's cells that lie in the grid
};

// Wraps a block index on a torus.
ivec2 blockWithin(ivec2 block, ivec2 cells) {
#if LEFT == 4
  block.x = (block.x + 8 * (cells.x / 2)) % (cells.x / 2);
#endif
#if TOP == 4
  block.y = (block.y + 8 * (cells.y / 2)) % (cells.y / 2);
#endif
  return block;
}

// Returns the bit mask of the block's cells that lie in the grid. `block` is already wrapped.
int cellsInside(ivec2 block, ivec2 cells) {
  ivec2 room = cells - 2 * block;
  if (block.x < 0 || block.y < 0 || room.x <= 0 || room.y <= 0) return 0;
  return (room.x > 1 ? 3 : 1) * (room.y > 1 ? 5 : 1);
}

// Loads a block except its right-hand side. `block` is already wrapped; `start` is the index of the level's openings.
Block blockAt(ivec2 block, ivec2 cells, int start) {
  Block b = Block(uvec4(0u), uvec2(0u), uvec2(0u), vec4(0.0), cellsInside(block, cells));
  int row = cells.x / 2 + 1, element = start + block.y * row + block.x;
  if (b.inside != 0) b.faces = LOAD_INPUT_WORDS(weights, element);
  if ((b.inside & 2) != 0) b.right = LOAD_INPUT_WORDS(weights, element + 1).xz;
  if ((b.inside & 4) != 0) b.below = LOAD_INPUT_WORDS(weights, element + row).xy;
  return b;
}

// Return the face weights (left, right, top, bottom) of one cell of the block: weights00() of the first cell,
// weights10() of the cell to its right, and so on.
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

// Relaxes the red cells x and w. `beside` holds their neighbours outside the block: left of x, above x, right of w,
// below w.
void sweepReds(Block b, inout vec4 here, vec4 beside) {
  vec4 w = weights00(b);
  here.x = (b.inside & 1) != 0 ? relaxed(b.rhs.x, neighbours(w, beside.x, here.y, beside.y, here.z), diagonal(w)) : 0.0;
  w = weights11(b);
  here.w = (b.inside & 8) != 0 ? relaxed(b.rhs.w, neighbours(w, here.z, beside.z, here.y, beside.w), diagonal(w)) : 0.0;
}

// Relaxes the red cells for the first time on the way to coarser levels, starting from zero.
void sweepFirstReds(Block b, inout vec4 here) {
  here.x = (b.inside & 1) != 0 ? begun(b.rhs.x, diagonal(weights00(b))) : 0.0;
  here.w = (b.inside & 8) != 0 ? begun(b.rhs.w, diagonal(weights11(b))) : 0.0;
}

// Relaxes the black cells y and z. `beside` holds their neighbours outside the block: right of y, above y, left of z,
// below z.
void sweepBlacks(Block b, inout vec4 here, vec4 beside) {
  vec4 w = weights10(b);
  here.y = (b.inside & 2) != 0 ? relaxed(b.rhs.y, neighbours(w, here.x, beside.x, beside.y, here.w), diagonal(w)) : 0.0;
  w = weights01(b);
  here.z = (b.inside & 4) != 0 ? relaxed(b.rhs.z, neighbours(w, beside.z, here.w, here.x, beside.w), diagonal(w)) : 0.0;
}

// Returns the coarse right-hand side from the residuals of the red cells. `beside` has the same meaning as in
// sweepReds().
float leftInReds(Block b, vec4 here, vec4 beside) {
  float first = 0.0, last = 0.0;
  if ((b.inside & 1) != 0) first = residual(b.rhs.x, weights00(b), here.x, beside.x, here.y, beside.y, here.z);
  if ((b.inside & 8) != 0) last = residual(b.rhs.w, weights11(b), here.w, here.z, beside.z, here.y, beside.w);
  return restricted(first, last);
}

// Returns true if a coarse cell is outside the grid, beyond a side that is not open.
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

// Adds the interpolated coarse correction to the block's cells. `above`, `middle` and `under` are three rows of three
// coarse cells; the coarse cell of this block is middle.y.
void raiseBlock(Block b, inout vec4 here, vec3 above, vec3 middle, vec3 under) {
  here.x = (b.inside & 1) != 0 ? raised(here.x, prolonged(middle.y, middle.x, above.y, above.x)) : 0.0;
  here.y = (b.inside & 2) != 0 ? raised(here.y, prolonged(middle.y, middle.z, above.y, above.z)) : 0.0;
  here.z = (b.inside & 4) != 0 ? raised(here.z, prolonged(middle.y, middle.x, under.y, under.x)) : 0.0;
  here.w = (b.inside & 8) != 0 ? raised(here.w, prolonged(middle.y, middle.z, under.y, under.z)) : 0.0;
}
