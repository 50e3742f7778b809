// A skin as its scene describes it (src/draw/surface/skin_textures.cpp).
uniform float skinThreshold;  // as a fraction of the field's range
uniform vec3 skinLow;
uniform vec3 skinHigh;
uniform float skinRoughness;
uniform float skinDepth;  // height of the whole range in cells; negative: what is high lies low
