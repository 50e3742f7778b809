// Writes no colour. Only whether the point is rasterized matters (src/gl/condition.cpp).
void main() {}
