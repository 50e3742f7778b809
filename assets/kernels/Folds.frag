// Draws fine glowing curves by repeated folding and inversion of the plane: gold where the last fold is, blue before it.
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    vec2 p = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    p = 0.53 * p;
    // A lamp in the middle, and its blue halo.
    float r = length(p);
    vec3 color = vec3(1.0, 0.5, 0.12) * (1.5 * exp(-22.0 * r) + 0.3 * exp(-7.0 * r)) + vec3(0.012, 0.03, 0.1) / (0.35 + dot(p, p));
    for (int i = 0; i < 5; i++)
    {
        p = abs(p) / dot(p, p) - vec2(0.72 + 0.12 * sin(0.3 * iTime), 0.58);
        float d = abs(length(p) - 0.6);
        vec3 ink = mix(vec3(0.03, 0.16, 0.6), vec3(1.0, 0.55, 0.14), smoothstep(1.0, 3.5, float(i) + 0.7 * sin(0.5 * iTime + float(i))));
        color += ink * (1.3 * exp(-34.0 * d) + 0.2 * exp(-6.0 * d));
    }
    fragColor = vec4(1.0 - exp(-color), 1.0);
}
