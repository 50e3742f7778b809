// Value of a vertex's last word if one of its coordinates is not finite. No packed normal and no nearness has these
// bits.
const uint lostVertex = 0xffffffffu;
