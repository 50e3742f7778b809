// How the edges of a grid are joined. Compiles as GLSL and as C++ (src/sim/automata/engine/grid_shape.hpp).

struct GridJoin {
  int width, height;
  int across, down;    // left and right, top and bottom edges: 0 apart, 1 joined, 2 joined reversed, 3 a sphere's
  int shiftX, shiftY;  // along the lower, the right edge
};

// The number of the cell that lies at (x, y), which may be outside by up to a width and a height, in rows of `rowCells`;
// -1: nothing lies there.
FUNCTION int joinedCell(GridJoin grid, int x, int y, int rowCells) {
  if (grid.down == 3) {
    // Top to left, right to bottom; corners are met by themselves.
    bool beyondX = x < 0 || x >= grid.width;
    bool beyondY = y < 0 || y >= grid.height;
    int nearX = x < 0 ? 0 : (x >= grid.width ? grid.width - 1 : x);
    int nearY = y < 0 ? 0 : (y >= grid.height ? grid.height - 1 : y);
    if (beyondX != beyondY) {
      int along = beyondY ? nearX : nearY;
      bool low = beyondY ? y < 0 : x < 0;
      // Above the top lies the left column, beyond the left edge the top row; beyond the right one the bottom
      // row, below that the right column.
      nearX = beyondY ? (low ? 0 : grid.width - 1) : along;
      nearY = beyondY ? along : (low ? 0 : grid.height - 1);
    }
    return nearY * rowCells + nearX;
  }
  for (int i = 0; i < 2 && (y < 0 || y >= grid.height); ++i) {
    if (grid.down == 0) return -1;
    bool below = y >= grid.height;
    y = below ? y - grid.height : y + grid.height;
    x = grid.down == 2 ? grid.width - 1 - x + grid.shiftX : (below ? x + grid.shiftX : x - grid.shiftX);
  }
  for (int i = 0; i < 4 && (x < 0 || x >= grid.width); ++i) {
    if (grid.across == 0) return -1;
    bool right = x >= grid.width;
    x = right ? x - grid.width : x + grid.width;
    y = grid.across == 2 ? grid.height - 1 - y + grid.shiftY : (right ? y + grid.shiftY : y - grid.shiftY);
  }
  // The shift of a column may have led beyond a row once more, where nothing is shifted along rows.
  y = y < 0 ? y + grid.height : (y >= grid.height ? y - grid.height : y);
  return y * rowCells + x;
}
