// Output of the contour and volume kernels for drawing and for the CPU: the arguments of an indirect draw, followed by
// the counts.
struct ContourDraw {
  uint count, instances, firstIndex, baseVertex;
  uint baseInstance;
  uint indices;    // Number of indices of the solid; the member `count` is 0 if they do not fit
  uint points;     // Number of contour points
  uint sheets;     // Number of uniform squares (four corners of one class)
  uint triangles;  // Number of triangles in squares or cubes that contours cross
  uint spare1, spare2, spare3;
};
