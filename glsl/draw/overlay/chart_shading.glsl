// Draws a translucent panel with rounded corners, axes, and curves as lines of even thickness over a faint fill. All
// colours are sRGB-encoded; alpha is premultiplied. Uses the uniforms of chart_inputs.glsl. Compiles as GLSL and as
// C++, after chart_columns.glsl.

struct ChartLook {
  vec4 nearest;  // distance (pixels) of the point from each curve
  vec4 below;    // vertical distance (pixels) by which the point is below each curve
};

FUNCTION vec4 covered(vec4 below, vec3 color, float alpha) {
  ROUNDED vec4 sum = vec4(color * alpha, alpha) + below * (1.0f - alpha);
  return sum;
}

FUNCTION float lengthOf(vec2 v) {
  ROUNDED float square = v.x * v.x + v.y * v.y;
  return root(square);
}

// Returns the squared distance from p to the segment a-b. The caller compares squares and takes one square root at the
// end.
FUNCTION float squareTo(vec2 p, vec2 a, vec2 b) {
  ROUNDED vec2 along = b - a;
  ROUNDED vec2 aside = p - a;
  ROUNDED float square = along.x * along.x + along.y * along.y;
  ROUNDED float share = (aside.x * along.x + aside.y * along.y) * inverse(max(square, 1e-12f));
  ROUNDED vec2 rest = aside - along * clamp(share, 0.0f, 1.0f);
  ROUNDED float squaredDistance = rest.x * rest.x + rest.y * rest.y;
  return squaredDistance;
}

// Returns one row of a column's data as depths (pixels) below the plot's top edge. `high` is the plot's height
// (pixels).
FUNCTION vec4 depthsAt(int column, int row, float high) {
  ROUNDED vec4 depths = (1.0f - columnAt(column, row)) * high;
  return depths;
}

// Returns the distances of the curves from the point p of the plot (pixels from its top left corner).
FUNCTION ChartLook looked(vec2 p, vec2 size, int reach) {
  vec4 square = vec4(1e12f), below = vec4(-1e6f);
  int middle = int(floor(p.x));
  for (int c = max(middle - reach, 0); c <= min(middle + reach, int(size.x) - 1); ++c) {
    if (columnAt(c, 0).x < 0.0f) break;
    vec4 a = depthsAt(c, 0, size.y), b = depthsAt(c, 1, size.y);
    vec4 low = depthsAt(c, 2, size.y), high = depthsAt(c, 3, size.y);
    ROUNDED float x0 = float(c);
    ROUNDED float half_ = x0 + 0.5f;
    ROUNDED float minimum = x0 + 1e-3f;
    ROUNDED float along = p.x - x0;
    ROUNDED vec4 deep = p.y - (a + (b - a) * along);
    ROUNDED vec4 above = min(a, b) - 0.01f;
    ROUNDED vec4 under = max(a, b) + 0.01f;
    float x1 = min(float(c + 1), max(end, minimum));
    for (int k = 0; k < curves; ++k) {
      square[k] = min(square[k], squareTo(p, vec2(x0, a[k]), vec2(x1, b[k])));
      // Adds a vertical line if the curve is more than a straight segment within the column.
      if (high[k] < above[k] || low[k] > under[k])
        square[k] = min(square[k], squareTo(p, vec2(half_, high[k]), vec2(half_, low[k])));
      if (c == middle && p.x <= end) below[k] = deep[k];
    }
  }
  ChartLook look;
  look.nearest = vec4(root(square.x), root(square.y), root(square.z), root(square.w));
  look.below = below;
  return look;
}

FUNCTION vec4 withCurves(vec4 panelLight, vec2 p, vec2 size) {
  vec4 sum = panelLight;
  ROUNDED float radius = 0.8f * unit;
  ROUNDED float glow = 4.5f * unit + 0.5f;
  ROUNDED float dotRadius = 2.0f * unit;
  ChartLook look = looked(p, size, int(ceil(radius)) + 1);
  vec4 last = heightsOf(texelFetch(counts, steps - 1));
  bool within = p.x >= 0.0f && p.y >= 0.0f && p.x <= size.x && p.y <= size.y;
  ROUNDED float foot = (1.0f - zero) * size.y;
  for (int k = 0; k < curves; ++k) {
    ROUNDED float under = look.below[k] + 0.5f;
    ROUNDED float over = 0.5f - look.below[k];
    float into = p.y <= foot || look.below[k] < -1e5f ? under : over;
    ROUNDED float alpha = 0.1f * clamp(into, 0.0f, 1.0f);
    if (within) sum = covered(sum, colors[k], alpha);
  }
  for (int k = curves - 1; k >= 0; --k) {
    ROUNDED vec2 toHead = p - vec2(end, (1.0f - last[k]) * size.y);
    float head = lengthOf(toHead);
    ROUNDED float toGlow = glow - head;
    ROUNDED float alpha = 0.25f * clamp(toGlow, 0.0f, 1.0f);
    sum = covered(sum, colors[k], alpha);
    ROUNDED float fromLine = look.nearest[k] - radius;
    ROUNDED float fromHead = head - dotRadius;
    ROUNDED float inLine = 0.5f - min(fromLine, fromHead);
    sum = covered(sum, colors[k], clamp(inLine, 0.0f, 1.0f));
  }
  return sum;
}

// Returns the colour, premultiplied by alpha, of the pixel with the centre `at`.
FUNCTION vec4 chartPixel(vec2 at) {
  ROUNDED float corner = 5.0f * unit;
  ROUNDED vec2 size = vec2(panel.z, panel.w) - vec2(panel.x, panel.y);
  ROUNDED vec2 fromMiddle = at - 0.5f * (vec2(panel.x, panel.y) + vec2(panel.z, panel.w));
  ROUNDED vec2 outside = abs(fromMiddle) - 0.5f * size + corner;
  ROUNDED float edge = lengthOf(max(outside, 0.0f)) + min(max(outside.x, outside.y), 0.0f) - corner;
  ROUNDED float inner = 0.5f - edge;
  ROUNDED float rim = 0.5f + edge + unit;
  ROUNDED float rimAlpha = 0.1f * clamp(rim, 0.0f, 1.0f);
  vec4 sum = covered(vec4(0.039f, 0.0468f, 0.0624f, 0.78f), vec3(1.0f), rimAlpha);
  ROUNDED vec2 p = at - vec2(plot.x, plot.y);
  ROUNDED vec2 plotSize = vec2(plot.z, plot.w) - vec2(plot.x, plot.y);
  ROUNDED float thin = 0.5f * unit;
  if (p.x >= 0.0f && p.x <= plotSize.x && p.y >= -thin && p.y <= plotSize.y) {
    ROUNDED float quarter = p.y * inverse(plotSize.y) * 4.0f;
    ROUNDED float nearest = quarter + 0.5f;
    ROUNDED float off = quarter - floor(nearest);
    ROUNDED float toLine = thin + 0.5f - abs(off) * plotSize.y * 0.25f;
    ROUNDED float alpha = 0.09f * clamp(toLine, 0.0f, 1.0f);
    sum = covered(sum, vec3(1.0f), alpha);
  }
  ROUNDED float foot = plotSize.y + unit;
  bool axes = (p.x >= -unit && p.x < 0.0f && p.y >= 0.0f && p.y < foot) ||
              (p.y >= plotSize.y && p.y < foot && p.x >= -unit && p.x < plotSize.x);
  ROUNDED float fromZero = p.y - (1.0f - zero) * plotSize.y;
  ROUNDED float zeroLine = thin + 0.5f - abs(fromZero);
  ROUNDED float zeroAlpha = 0.3f * clamp(zeroLine, 0.0f, 1.0f);
  if (zero > 0.0f && p.x >= 0.0f && p.x <= plotSize.x) sum = covered(sum, vec3(1.0f), zeroAlpha);
  if (axes) sum = covered(sum, vec3(1.0f), 0.45f);
  if (steps > 0) sum = withCurves(sum, p, plotSize);
  ROUNDED vec4 shaped = sum * clamp(inner, 0.0f, 1.0f);
  return shaped;
}
