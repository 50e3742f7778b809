// Writes no colour: only the fact that the point is rasterized matters (src/gl/condition.cpp).
void main() {}
