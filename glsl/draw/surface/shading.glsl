// Metal/rough reflection. Light is irradiance / pi, so a white matt surface facing it has its radiance.

// pi times the GGX lobe D V with V F of Karis' fit for mobile GPUs (course notes, SIGGRAPH 2015,
// "Optimizing PBR for mobile"), without the colour F0.
float lobe(vec3 normal, vec3 view, vec3 light, float alpha) {
  vec3 halfway = normalize(view + light);
  float nh = max(dot(normal, halfway), 0.0);
  float lh = dot(light, halfway);
  float d = nh * nh * (alpha * alpha - 1.0) + 1.00001;
  return min(alpha * alpha / (d * d * max(lh * lh, 0.1) * (alpha * 4.0 + 2.0)), 60.0);
}

float roughAlpha(float roughness) {
  return max(roughness * roughness, 0.002);
}

float sunLobe(vec3 normal, vec3 view, vec3 sun, float roughness) {
  return lobe(normal, view, sun, roughAlpha(roughness));
}

// Fraction of ambient light mirrored: F0 * x + y (Lazarov's fit in Karis' form, same notes).
vec2 ambientLobe(float roughness, float nv) {
  vec4 r = roughness * vec4(-1, -0.0275, -0.572, 0.022) + vec4(1, 0.0425, 1.04, -0.04);
  float a = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
  return vec2(-1.04, 1.04) * a + r.zw;
}
