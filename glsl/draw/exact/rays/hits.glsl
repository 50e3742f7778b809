// What a ray has met, beside places in the order of triangles.
const int ballBit = 0x40000000;      // of a ball's place in the order of balls
const int groundHit = 0x7ffffffe;
const float farAway = 1e9f;          // m: how far rays go that meet nothing
