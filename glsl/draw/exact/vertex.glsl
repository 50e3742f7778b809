// Value of a vertex's last word if a coordinate of the vertex is not finite. Packed normals and nearness never have
// these bits.
const uint lostVertex = 0xffffffffu;
