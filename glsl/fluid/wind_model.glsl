// Wind of a fluid at a point of the world. Compiles as GLSL and as C++. The including file provides windGrid (WindGrid)
// and loadWindCell(x, y), which returns a cell of the flow, with x from -1 to size.x because the ring is also read.
//
// Each component is interpolated bilinearly from its staggered positions: u from the centres of left faces, v from the
// centres of top faces. The wind does not depend on the distance from the fluid's plane. Outside the fluid's rectangle
// there is no wind.
FUNCTION float windBetween(float a, float b, float f) {
  precise float value = a + (b - a) * f;
  return value;
}

// Returns the component u (`which` is 0) or v (`which` is 1) at a point of the rectangle, in cells/s.
FUNCTION float windPart(int which, float px, float py) {
  precise float nodeX = which == 0 ? px : px - 0.5f;
  precise float nodeY = which == 0 ? py - 0.5f : py;
  int x = min(int(floor(nodeX)), windGrid.size.x - 1);
  int y = min(int(floor(nodeY)), windGrid.size.y - 1);
  precise float fx = nodeX - float(x);
  precise float fy = nodeY - float(y);
  vec4 a = loadWindCell(x, y);
  vec4 b = loadWindCell(x + 1, y);
  vec4 c = loadWindCell(x, y + 1);
  vec4 d = loadWindCell(x + 1, y + 1);
  float above = which == 0 ? windBetween(a.x, b.x, fx) : windBetween(a.y, b.y, fx);
  float below = which == 0 ? windBetween(c.x, d.x, fx) : windBetween(c.y, d.y, fx);
  return windBetween(above, below, fy);
}

// Returns the wind in m/s at a world position in metres.
FUNCTION vec3 windAt(vec3 here) {
  precise float x = (windGrid.across.x * here.x + windGrid.across.y * here.y) + (windGrid.across.z * here.z + windGrid.across.w);
  precise float y = (windGrid.down.x * here.x + windGrid.down.y * here.y) + (windGrid.down.z * here.z + windGrid.down.w);
  float width = float(windGrid.size.x);
  float height = float(windGrid.size.y);
  bool inside = x >= 0.0f && x <= width && y >= 0.0f && y <= height;
  float px = inside ? x : 0.0f;
  float py = inside ? y : 0.0f;
  float u = windPart(0, px, py);
  float v = windPart(1, px, py);
  precise vec3 wind = windGrid.alongX * u + windGrid.alongY * v;
  return inside ? wind : vec3(0.0f);
}
