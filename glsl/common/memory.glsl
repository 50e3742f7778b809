// One kernel source, two memory paths: storage blocks on a GPU; where the driver is software (TEXEL_PATH) texel views of
// the same buffers for loads, which cost a tenth there, and storage blocks for stores, which cost a third.
// src/gl/element_array.hpp binds accordingly. Inputs and states share the binding numbers of the storage path, so a
// kernel gives each array its own. A compiler may move a texel fetch past a store to the same element: LOAD_ONCE is for
// values that are used for the last time before or in that store; LOAD_STATE for all others, an image load, which
// stays in its place and costs three times as much.
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
