// Reads texels of light in RGBA32F. LIGHT_IMAGES: reads them as images, which takes half the time on software drivers;
// otherwise as textures.
#include "draw/bindings.glsl"
#include "draw/exact/bindings.glsl"
#ifdef LIGHT_IMAGES
#define LIGHT_PICTURE(unit, image, name) layout(rgba32f, binding = image) readonly restrict uniform image2D name
#define LIGHT_AT(name, at) imageLoad(name, at)
#define pictureSize(name) imageSize(name)
#else
#define LIGHT_PICTURE(unit, image, name) layout(binding = unit) uniform sampler2D name
#define LIGHT_AT(name, at) texelFetch(name, at, 0)
#define pictureSize(name) textureSize(name, 0)
#endif
