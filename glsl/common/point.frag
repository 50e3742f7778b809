// Writes no colour, because only the fact that the point is rasterized matters (src/gl/condition.cpp).
void main() {}
