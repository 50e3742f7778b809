// Special values of the index of a hit. Other values are indices in the hierarchy's triangle order.
const int ballBit = 0x40000000;      // flag of a ball; the other bits are the index in the hierarchy's ball order
const int groundHit = 0x7ffffffe;
const float farAway = 1e9f;          // length of an unlimited ray in metres
