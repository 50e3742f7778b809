// Number of links per segment of a line (line_model.glsl). Compiles as GLSL and as C++.
#ifndef CLOTH_SEGMENT_LINKS
#define CLOTH_SEGMENT_LINKS
const int segmentLinks = 16;
#endif
