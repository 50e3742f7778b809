// Draws the panel of a chart as a triangle strip. Row 0 of the target is the picture's top row.
uniform vec4 panel;    // bounds of the chart's panel in whole pixels: left, top, right, bottom
uniform vec2 picture;  // picture size in pixels

void main() {
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? panel.x : panel.z, (gl_VertexID & 2) == 0 ? panel.y : panel.w);
  gl_Position = vec4(corner / picture * 2.0 - 1.0, 0.0, 1.0);
}
