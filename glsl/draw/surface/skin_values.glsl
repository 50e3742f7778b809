// Parameters of a skin from the scene (src/draw/surface/skin_textures.cpp).
uniform float skinThreshold;  // threshold as a fraction of the field's range
uniform vec3 skinLow;
uniform vec3 skinHigh;
uniform float skinRoughness;
uniform float skinDepth;  // relief height of the whole value range in cells; if negative, high values are low
