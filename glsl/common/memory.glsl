// Macros that give one kernel source two memory paths. On a GPU, all arrays are storage blocks. On a software driver
// (TEXEL_PATH), loads use texel views of the same buffers, because there a texel fetch costs a tenth of a storage block
// load, and stores use storage blocks. src/gl/element_array.hpp binds the arrays accordingly. Inputs and states use the
// binding numbers of the storage path, so each array of a kernel needs a different number. A compiler may move a texel
// fetch to after a store to the same element. Therefore, LOAD_ONCE (a texel fetch) is allowed only if the kernel uses
// the loaded value for the last time before or in that store. LOAD_STATE is for all other loads: it is an image load,
// which the compiler does not move but which costs three times as much. An OUTPUT_ARRAY is never loaded; its binding
// number may exceed 7, the last image unit of some drivers.
#ifdef TEXEL_PATH
#define INPUT_ARRAY(unit, block, name) layout(binding = unit) uniform samplerBuffer name;
#define LOAD_INPUT(name, i) texelFetch(name, i)
#define STATE_ARRAY(unit, block, name)                                       \
  layout(rgba32f, binding = unit) uniform readonly imageBuffer name##Image; \
  layout(binding = unit) uniform samplerBuffer name##Texels;                \
  layout(std430, binding = unit) writeonly buffer block { vec4 name[]; };
#define LOAD_STATE(name, i) imageLoad(name##Image, i)
#define LOAD_ONCE(name, i) texelFetch(name##Texels, i)
#define STORE_STATE(name, i, value) name[i] = (value)
#else
#define INPUT_ARRAY(unit, block, name) \
  layout(std430, binding = unit) readonly restrict buffer block { vec4 name[]; };
#define LOAD_INPUT(name, i) name[i]
#define STATE_ARRAY(unit, block, name) layout(std430, binding = unit) restrict buffer block { vec4 name[]; };
#define LOAD_STATE(name, i) name[i]
#define LOAD_ONCE(name, i) name[i]
#define STORE_STATE(name, i, value) name[i] = (value)
#endif
#define OUTPUT_ARRAY(unit, block, name) \
  layout(std430, binding = unit) writeonly restrict buffer block { vec4 name[]; };
