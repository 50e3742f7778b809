// Topology of a grid, that is, the connections of its edges. Compiles as GLSL and as C++
// (src/sim/automata/engine/grid_shape.hpp).

struct GridJoin {
  int width, height;
  int across, down;    // Connection of left and right edge, and of top and bottom edge: 0 none, 1 connected, 2
                       // connected with reversal, 3 sphere
  int shiftX, shiftY;  // Shift along the lower edge and along the right edge, in cells
};

// Returns the index of the cell at (x, y), in rows of `rowCells`. The position may be outside the grid by up to a width
// and a height. Returns -1 if there is no cell.
FUNCTION int joinedCell(GridJoin grid, int x, int y, int rowCells) {
  if (grid.down == 3) {
    // On a sphere, the top edge is connected to the left edge and the bottom edge to the right edge. A corner is a
    // neighbour of itself.
    bool beyondX = x < 0 || x >= grid.width;
    bool beyondY = y < 0 || y >= grid.height;
    int nearX = x < 0 ? 0 : (x >= grid.width ? grid.width - 1 : x);
    int nearY = y < 0 ? 0 : (y >= grid.height ? grid.height - 1 : y);
    if (beyondX != beyondY) {
      int along = beyondY ? nearX : nearY;
      bool low = beyondY ? y < 0 : x < 0;
      // The left column serves as the row above the top row, and the top row as the column to the left of the left
      // column. The bottom row serves as the column to the right of the right column, and the right column as the row
      // below the bottom row.
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
  // If there is no shift along rows, the shift along columns can move the position out of the grid again.
  y = y < 0 ? y + grid.height : (y >= grid.height ? y - grid.height : y);
  return y * rowCells + x;
}
