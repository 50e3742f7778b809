// Unrolls a loop: expands to REPEATED(0) ... REPEATED(TIMES - 1) for TIMES <= 32, so that the counter is a constant in
// each round. Software drivers read a uniform block lane by lane if the index is not constant, and they execute both
// sides of every branch.
#ifndef REPEAT_MACROS
#define REPEAT_MACROS
#define REPEAT_2(i) REPEATED(i) REPEATED((i) + 1)
#define REPEAT_4(i) REPEAT_2(i) REPEAT_2((i) + 2)
#define REPEAT_8(i) REPEAT_4(i) REPEAT_4((i) + 4)
#define REPEAT_16(i) REPEAT_8(i) REPEAT_8((i) + 8)
#endif
#if TIMES >= 32
REPEAT_16(0)
REPEAT_16(16)
#else
#if (TIMES & 16) != 0
REPEAT_16(0)
#endif
#if (TIMES & 8) != 0
REPEAT_8(TIMES & 16)
#endif
#if (TIMES & 4) != 0
REPEAT_4(TIMES & 24)
#endif
#if (TIMES & 2) != 0
REPEAT_2(TIMES & 28)
#endif
#if (TIMES & 1) != 0
REPEATED(TIMES & 30)
#endif
#endif
#undef TIMES
#undef REPEATED
