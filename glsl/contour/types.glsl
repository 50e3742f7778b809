// What the kernels leave for drawing and for the CPU: the arguments of an indirect draw, then what there is of all.
struct ContourDraw {
  uint count, instances, firstIndex, baseVertex;
  uint baseInstance;
  uint indices;    // that the solid has; count is 0 where they do not fit
  uint points;     // of contours
  uint sheets;     // squares of one class
  uint triangles;  // of squares or cubes that contours cross
  uint spare1, spare2, spare3;
};
