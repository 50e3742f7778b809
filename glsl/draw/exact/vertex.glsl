// What stands in a vertex's last word where one of its numbers is none: no normal's and no nearness' bits.
const uint lostVertex = 0xffffffffu;
