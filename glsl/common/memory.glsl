// One kernel source, two memory paths: texel views of the buffers where the driver is software, storage
// blocks on a GPU (defines TEXEL_PATH; src/gl/element_array.hpp binds accordingly). Inputs and states share the
// binding numbers of the storage path, so a kernel gives each array its own.
#ifdef TEXEL_PATH
#define INPUT_ARRAY(unit, block, name) layout(binding = unit) uniform samplerBuffer name;
#define LOAD_INPUT(name, i) texelFetch(name, i)
#define STATE_ARRAY(unit, block, name) layout(rgba32f, binding = unit) uniform restrict imageBuffer name;
#define LOAD_STATE(name, i) imageLoad(name, i)
#define STORE_STATE(name, i, value) imageStore(name, i, value)
#else
#define INPUT_ARRAY(unit, block, name) \
  layout(std430, binding = unit) readonly restrict buffer block { vec4 name[]; };
#define LOAD_INPUT(name, i) name[i]
#define STATE_ARRAY(unit, block, name) layout(std430, binding = unit) restrict buffer block { vec4 name[]; };
#define LOAD_STATE(name, i) name[i]
#define STORE_STATE(name, i, value) name[i] = (value)
#endif
