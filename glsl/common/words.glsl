// The macros of common/memory.glsl for elements of four unsigned words. src/gl/sort/radix_sort.hpp binds the arrays
// accordingly.
#ifdef TEXEL_PATH
#define INPUT_WORDS(unit, block, name) layout(binding = unit) uniform usamplerBuffer name;
#define LOAD_INPUT_WORDS(name, i) texelFetch(name, i)
#define STATE_WORDS(unit, block, name)                                     \
  layout(rgba32ui, binding = unit) uniform readonly uimageBuffer name##Image; \
  layout(std430, binding = unit) writeonly buffer block { uvec4 name[]; };
#define LOAD_WORDS(name, i) imageLoad(name##Image, i)
#define STORE_WORDS(name, i, value) name[i] = (value)
#else
#define INPUT_WORDS(unit, block, name) \
  layout(std430, binding = unit) readonly restrict buffer block { uvec4 name[]; };
#define LOAD_INPUT_WORDS(name, i) name[i]
#define STATE_WORDS(unit, block, name) layout(std430, binding = unit) restrict buffer block { uvec4 name[]; };
#define LOAD_WORDS(name, i) name[i]
#define STORE_WORDS(name, i, value) name[i] = (value)
#endif

// Returns component c of a vector, and the vector with another component c. An index that is not constant would make
// some compilers keep the vector in memory.
uint wordAt(uvec4 words, int c) {
  return c < 2 ? (c == 0 ? words.x : words.y) : (c == 2 ? words.z : words.w);
}
uvec4 withWord(uvec4 words, int c, uint word) {
  return uvec4(c == 0 ? word : words.x, c == 1 ? word : words.y, c == 2 ? word : words.z, c == 3 ? word : words.w);
}
