// Draws the rectangle of the picture that a field covers, as a triangle strip.
uniform vec4 part;      // bounds of the field in whole pixels from the picture's top left: left, top, right, bottom
uniform vec2 picture;   // picture size in pixels
uniform bool topFirst;  // true if row 0 of the target is the picture's top row

void main() {
  vec2 corner = vec2((gl_VertexID & 1) == 0 ? part.x : part.z, (gl_VertexID & 2) == 0 ? part.y : part.w);
  vec2 at = corner / picture * 2.0 - 1.0;
  gl_Position = vec4(at.x, topFirst ? at.y : -at.y, 0.0, 1.0);
}
