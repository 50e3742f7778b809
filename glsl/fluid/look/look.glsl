// Quantities and colours of a fluid for display. Compiles as GLSL and as C++, after transport.glsl.
const int dyeShown = 0;
const int speedShown = 1;
const int vorticityShown = 2;
const int heatShown = 3;
const int pressureShown = 4;

FUNCTION float shownValue(int what, int x, int y) {
  vec4 here = flowAt(x, y);
  if (what == heatShown) return here.z;
  if (what == pressureShown) return here.w;
  if (what == vorticityShown) {
    precise float curl = 0.25f * ((curlAt(x, y) + curlAt(x + 1, y)) + (curlAt(x, y + 1) + curlAt(x + 1, y + 1)));
    return curl;
  }
  if (what == speedShown) {
    vec2 velocity = ownVelocity(2, x, y);
    precise float square = velocity.x * velocity.x + velocity.y * velocity.y;
    return exactSqrt(square);
  }
  precise float mean = 0.333333333f * densityOf(dyeAt(x, y));
  return mean;
}

FUNCTION float fraction(float absorbed) {
  precise float negative = -absorbed;
  return exactExp(negative);
}

const int lightLook = 0;
const int inkLook = 1;
const int fireLook = 2;

// Returns the colour of the glow at a temperature: red, then yellow, then white.
FUNCTION vec4 glowOf(float heat) {
  float held = clamp(heat, 0.0f, 3.0f);
  precise float square = held * held;
  precise vec4 glow = vec4(1.9f * square, 0.6f * square * held, 0.13f * square * square, 0.0f);
  return glow;
}

// Returns a linear RGB colour. The looks "light" and "fire" blend light from the dye over dark paper with the
// transmittance e^(-brightness dye); "fire" adds a glow that depends on the temperature. The look "ink" attenuates the
// paper by e^(-brightness a) (Beer-Lambert law), where the absorption a of each channel is the part of that channel
// missing in the ink's colour, plus a small part of all channels.
FUNCTION vec4 shownColor(int look, float brightness, vec4 dye, float heat, vec3 paper) {
  precise vec4 light = brightness * dye;
  if (look == inkLook) {
    float maximum = max(max(light.x, light.y), light.z);
    precise vec4 lacking = vec4(1.15f * maximum) - light;
    precise vec4 left = vec4(paper, 0.0f) * vec4(fraction(lacking.x), fraction(lacking.y), fraction(lacking.z), 0.0f);
    return left;
  }
  vec4 glow = look == fireLook ? glowOf(heat) : vec4(0.0f);
  light = light + glow;
  precise vec4 dark = vec4(1.0f) - vec4(paper, 0.0f);
  precise vec4 shining = vec4(1.0f) - dark * vec4(fraction(light.x), fraction(light.y), fraction(light.z), 1.0f);
  return shining;
}
