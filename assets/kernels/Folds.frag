// Draws glowing curves by repeated folding and inversion of the plane.
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    vec2 p = (2.0 * fragCoord - iResolution.xy) / iResolution.y;
    vec3 color = vec3(0.0);
    for (int i = 0; i < 4; i++)
    {
        p = abs(p) / dot(p, p) - vec2(0.72 + 0.12 * sin(0.3 * iTime), 0.58);
        color += exp(-6.0 * abs(length(p) - 0.6)) * (0.5 + 0.5 * cos(vec3(0.0, 1.4, 2.6) + float(i) + 0.5 * iTime));
    }
    fragColor = vec4(1.0 - exp(-color), 1.0);
}
