"""Mutants that are known to be equivalent."""

# Keys are (file, line after the change). Values are the reason why the change has no effect.
EQUIVALENT = {
    ("draw/half.glsl",
     "return vec2(abs(held.x) < 6.2e-5 ? 0.0 : held.x, abs(held.y) <= 6.2e-5 ? 0.0 : held.y);"):
        "no half float is 6.2e-5",
    ("collide/distance/model.glsl", "float left = boxSquared(p, loadBox(2 * child), loadBox(1 * child + 1));"):
        "where the search begins: all that is nearer is found all the same",
    ("collide/distance/model.glsl", "int box = 0;"): "where the search begins: all that is nearer is found all the same",
    ("collide/distance/model.glsl", "s.squared = 1.01e+30f;"): "no face is farther than 1e15 m",
    ("draw/overlay/chart_shading.glsl", "(p.y >= plotSize.y && p.y < foot && p.x >= -unit && p.x <= plotSize.x);"):
        "the plot's sides are whole, middles of pixels are not",
    ("draw/overlay/chart_shading.glsl", "bool within = p.x >= 0.0f && p.y >= 0.0f && p.x <= size.x && p.y < size.y;"):
        "the plot's sides are whole, middles of pixels are not",
    ("draw/overlay/chart_shading.glsl", "if (columnAt(c, 1).x < 0.0f) break;"):
        "of a column all rows are negative, or none is",
    ("draw/overlay/chart_shading.glsl", "vec4 square = vec4(1.01e+12f), below = vec4(-1e6f);"):
        "further than anything on a picture is",
    ("draw/exact/instances/ball.glsl", "precise float beyond = exactDot(aside, aside) + rr * (aa - af * af);"):
        "a wider box, of which every sample is looked at by ray",
    ("draw/exact/instances/ball.glsl",
     "precise float half_ = ball.radius * exactSqrt(max(beyond, 1.0f)) * perSquare;"):
        "a wider box, of which every sample is looked at by ray",
    ("draw/exact/instances/ball.glsl",
     "precise float more = half_ + 0.01f + 1.00001f * (abs(middle) + half_);  // margin for rounding errors"):
        "a wider box, of which every sample is looked at by ray",
    ("draw/sky.glsl", "ROUNDED float up = 1.0f - clamp(y, 0.0f, 1.01f);"):
        "of unit vectors no part is above 1 but by rounding, which a byte does not show",
    ("draw/exact/triangles/clip.glsl", "max(x.x, max(x.y, x.z)) < 0.0f && max(y.x, max(y.y, y.z)) < 0.0f;"):
        "beside() spares work: what it lets pass covers no sample",
    ("draw/exact/triangles/clip.glsl",
     "return max(a.z, max(b.z, c.z)) < nearest && max(a.x, max(b.x, c.x)) < 0.0f || max(a.y, max(b.y, c.y)) < 0.0f ||"):
        "beside() spares work: what it lets pass is clipped away",
    ("draw/exact/triangles/triangle.glsl",
     "edge.bias = edge.step_.y > 0 || (edge.step_.y == 0 && edge.step_.x < 1) ? 0 : -1;"):
        "only of an edge without length, whose triangle is empty",
    ("draw/exact/triangles/clip.glsl", "precise vec3 y = size.y * vec3(a.z, b.z, c.z) + vec3(a.y, b.y, c.y);"):
        "beside() spares work: it still rejects none but what lies above the picture",
    ("draw/exact/visible_sample.glsl", "if (key <= before) atomicMin(nearKeys[at], key);"):
        "the least of two equal keys is either",
    ("draw/exact/vertex.glsl", "const uint lostVertex = 0xfffffffdu;"):
        "no packed normal has 0xffff above, no nearness is a NaN",
    ("draw/exact/tiles/shade_ground.comp", "vec3 ray = rayThrough(shadingPlace(pixel, -2));"):
        "any negative sample is the pixel's middle",
    ("draw/exact/instances/ball_shadows.comp", "int across = (box.z + box.x) / tileSide + 1;"):
        "more tiles, whose texels beyond the box are left out",
    ("draw/exact/copies/cull_copies.comp",
     "return max(low.x, low.y) >= 0.0f && max(high.x, high.y) <= float(mapTexels);"):
        "more copies are listed, whose triangles cover nothing of the map",
    ("draw/exact/instances/ball.glsl", "if (low < 0.0f || high > 1.0f) return vec2(1.0f, -1.0f);"):
        "fewer are left out early, of which no sample is covered",
    ("draw/exact/unit_vector.glsl", "precise float y = clamp(v, -1.0f, 1.01f) * 32767.0f + 32767.5f;"):
        "no part of a vector is above the sum of all but by rounding, which floor() drops",
    ("draw/exact/unit_vector.glsl", "precise float x = clamp(u, -1.0f, 2.0f) * 32767.0f + 32767.5f;"):
        "no part of a vector is above the sum of all but by rounding, which floor() drops",
    ("draw/exact/instances/balls.comp", "if (box.z < box.x && box.w < box.y) return;"):
        "an empty box has no pixel either way, also as a large one's",
    ("draw/exact/instances/ball_shadows.comp", "int tiles = across * ((box.w + box.y) / tileSide + 1);"):
        "more tiles, whose texels beyond the box are left out",
    ("draw/sky.glsl", "ROUNDED float glow = max(dotted(direction, vec3(frame.sunDirection)), 0.01f);"):
        "to the power of 16, 1e-32 at most",
    ("draw/exact/triangles/clip.glsl",
     "for (int k = 0; k < 5; ++k) all_ = all_ && insideOf(k, v, size, nearest) > 0.0f;"):
        "clipping leaves the corners of what has none beyond",
    ("draw/exact/triangles/crossing.glsl",
     "int first = (int(floor(low)) + edge.from.x - 2) >> 8, last = (int(floor(high)) + edge.from.x + 2) << 8;"):
        "a wider span, of which every sample is tested",
    ("draw/exact/triangles/triangle.glsl", "return uint(low1) > uint(low2) ? 1 : low1 == low2 ? 1 : -1;"):
        "a triangle of no area covers no sample: of its edges at least one is neither a left nor a top one",
    ("draw/surface/footprint.glsl", "print.part = beyond ? 1.0f : part;"):
        "beyond the last level the next one is the last, too",
    ("draw/exact/copies/cull_copies.comp", "precise float reach = radius * exactReciprocal(lightTexel()) + 0.0f;"):
        "what covers a texel's middle reaches half a texel into the map, more than is lost by rounding",
    ("draw/overlay/field_view.glsl", "return vec4(1.0);"):
        "nobody calls it: `reduces` is false there",
    ("draw/overlay/field_shading.glsl", "ROUNDED float beyond = 1.0f - max(facing, 0.0f);"):
        "what follows from it is taken where `facing` is above 1",
    ("draw/exact/instances/disc.glsl",
     "return ivec4(int(floor(from.x)), int(floor(from.y)), int(ceil(to.x)), int(floor(to.y)));"):
        "a wider box, no larger than the picture, of which every pixel is tested",
    ("draw/exact/triangles/fill_tiles.glsl", "span = tilesBetween(span, t.edges[2], b, y);"):
        "only where the edge begins is taken of it: the other end of the one whose slope `b` is",
    ("draw/exact/screen/bloom_down.comp", "if (2 * at.x > size.x || 2 * at.y >= size.y) return;"):
        "what is stored beyond an image is dropped",
    ("draw/exact/triangles/crossing.glsl",
     "int first = (int(ceil(low)) + edge.from.x - 2) >> 8, last = (int(floor(high)) + edge.from.x + 2) >> 8;"):
        "samples lie 16/256 from a pixel's right side, so a span may begin as much too far right",
    ("draw/exact/triangles/crossing.glsl",
     "int first = (int(floor(low)) + edge.from.x + 2) >> 8, last = (int(floor(high)) + edge.from.x + 2) >> 8;"):
        "samples lie 16/256 from a pixel's right side, so a span may begin as much too far right",
    ("draw/exact/triangles/crossing.glsl",
     "int first = (int(floor(low)) + edge.from.x - 1) >> 8, last = (int(floor(high)) + edge.from.x + 2) >> 8;"):
        "samples lie 16/256 from a pixel's right side, so a span may begin as much too far right",
    ("draw/exact/triangles/crossing.glsl",
     "int first = (int(floor(low)) + edge.from.x - 0) >> 8, last = (int(floor(high)) + edge.from.x + 2) >> 8;"):
        "samples lie 16/256 from a pixel's right side, so a span may begin as much too far right",
    ("draw/exact/triangles/crossing.glsl",
     "int first = (int(floor(low)) + edge.from.x - 3) >> 8, last = (int(floor(high)) + edge.from.x + 2) >> 8;"):
        "a wider span, of which every sample is tested",
    ("draw/exact/triangles/crossing.glsl",
     "int first = (int(floor(low)) + edge.from.x - 2) >> 9, last = (int(floor(high)) + edge.from.x + 2) >> 8;"):
        "a wider span, of which every sample is tested: the box bounds it",
    ("draw/exact/triangles/crossing.glsl",
     "int first = (int(floor(low)) + edge.from.x - 2) >> 8, last = (int(ceil(high)) + edge.from.x + 2) >> 8;"):
        "a wider span, of which every sample is tested",
    ("draw/exact/triangles/crossing.glsl",
     "int first = (int(floor(low)) + edge.from.x - 2) >> 8, last = (int(floor(high)) + edge.from.x + 3) >> 8;"):
        "a wider span, of which every sample is tested",
    ("draw/exact/triangles/crossing.glsl",
     "int first = (int(floor(low)) + edge.from.x - 2) >> 8, last = (int(floor(high)) + edge.from.x + 1) >> 8;"):
        "an upright edge's crossing is exact, and that of others errs by far less than the row's last 16/256 add",
    ("draw/exact/triangles/crossing.glsl",
     "int first = (int(floor(low)) + edge.from.x - 2) >> 8, last = (int(floor(high)) + edge.from.x + 0) >> 8;"):
        "an upright edge's crossing is exact, and that of others errs by far less than the row's last 16/256 add",
    ("draw/exact/triangles/crossing.glsl",
     "int first = (int(floor(low)) + edge.from.x - 2) >> 8, last = (int(floor(high)) + edge.from.x + 2) >> 7;"):
        "a wider span, of which every sample is tested: the box bounds it",
    ("draw/exact/triangles/crossing.glsl",
     "int first = (int(floor(low)) + edge.from.x - 2) >> 8, last = (int(floor(high)) + edge.from.x + 2) >> 0;"):
        "a wider span, of which every sample is tested: the box bounds it",
    ("draw/exact/triangles/crossing.glsl",
     "return ivec2(crossing.side >= 0 ? max(span.x, first) : span.x, crossing.side < 0 ? min(span.y, last) : span.y);"):
        "of a level edge the place found lies left of it",
    ("draw/exact/triangles/crossing.glsl",
     "return ivec2(crossing.side > 1 ? max(span.x, first) : span.x, crossing.side < 0 ? min(span.y, last) : span.y);"):
        "a wider span, of which every sample is tested",
    ("draw/exact/triangles/crossing.glsl",
     "int first = (int(ceil(low)) + edge.from.x - subpixels) >> 11, last = (int(floor(high)) + edge.from.x + subpixels) >> 11;"):
        "a 256th of the slack, which is a pixel",
    ("draw/exact/triangles/crossing.glsl",
     "int first = (int(floor(low)) + edge.from.x - subpixels) >> 11, last = (int(ceil(high)) + edge.from.x + subpixels) >> 11;"):
        "a 256th of the slack, which is a pixel",
    ("draw/exact/triangles/crossing.glsl",
     "int first = (int(floor(low)) + edge.from.x - subpixels) >> 11, last = (int(floor(high)) + edge.from.x + subpixels) << 11;"):
        "a wider span, of which every sample is tested",
    ("draw/exact/copies/copies.comp", "if (whole && extent < smallPixels * subpixels)"):
        "either way of drawing gives the same, as a test says",
    ("draw/exact/copies/copies.comp", "if (whole && extent <= smallPixels + subpixels)"):
        "either way of drawing gives the same, as a test says, and this asks for fewer small ones",
    ("draw/exact/copies/copies.comp", "else if (whole && extent < mediumPixels * subpixels)"):
        "either way of drawing gives the same, as a test says",
    ("draw/exact/copies/copies.comp", "else if (whole && extent <= mediumPixels + subpixels)"):
        "either way of drawing gives the same, as a test says, and this asks for fewer of medium size",
    ("draw/exact/instances/balls.comp", "if (max(box.z + box.x, box.w - box.y) >= smallPixels) {"):
        "either way of drawing gives the same, as a test says, and this asks for fewer small ones",
    ("draw/exact/instances/balls.comp", "if (max(box.z - box.x, box.w + box.y) >= smallPixels) {"):
        "either way of drawing gives the same, as a test says, and this asks for fewer small ones",
    ("draw/exact/instances/balls.comp", "if (max(box.z - box.x, box.w - box.y) > smallPixels) {"):
        "either way of drawing gives the same, as a test says",
    ("draw/exact/instances/ball_shadows.comp", "if (max(box.z + box.x, box.w - box.y) >= smallPixels) {"):
        "either way of drawing gives the same, as a test says, and this asks for fewer small ones",
    ("draw/exact/instances/ball_shadows.comp", "if (max(box.z - box.x, box.w + box.y) >= smallPixels) {"):
        "either way of drawing gives the same, as a test says, and this asks for fewer small ones",
    ("draw/exact/instances/ball_shadows.comp", "if (max(box.z - box.x, box.w - box.y) > smallPixels) {"):
        "either way of drawing gives the same, as a test says",
    ("draw/exact/instances/glow_disc.glsl",
     "precise float depth = exactDot(middle, middle) * exactReciprocal(max(towards, 1.01e-12f));"):
        "as far beyond the farthest plane",
    ("draw/exact/instances/glow_disc.glsl",
     "precise float depth = exactDot(middle, middle) * exactReciprocal(max(towards, 0.0f));"):
        "where `towards` is not above 0 nothing is drawn, and below 1e-12 it is beyond the farthest plane",
    ("draw/exact/instances/glow_disc.glsl",
     "if (square > 1.0f || (!glow.round_ && (towards <= 0.0f || !farEnough(depth, near)))) return;"):
        "on the rim there is no light",
    ("draw/exact/instances/glow_disc.glsl",
     "if (square >= 1.0f || (!glow.round_ && (towards < 0.0f || !farEnough(depth, near)))) return;"):
        "at 0 the disc is beyond the farthest plane",
    ("draw/exact/copies/cull_copies.comp", "return farthest > view.near && x.x <= x.y && y.x <= y.y;"):
        "the radius is a thousandth more than a mesh reaches, and spans are 0.02 pixels wider than that",
    ("draw/exact/copies/cull_copies.comp", "return farthest >= view.near && x.x < x.y && y.x <= y.y;"):
        "the radius is a thousandth more than a mesh reaches, and spans are 0.02 pixels wider than that",
    ("draw/exact/copies/cull_copies.comp", "return farthest >= view.near && x.x <= x.y && y.x < y.y;"):
        "the radius is a thousandth more than a mesh reaches, and spans are 0.02 pixels wider than that",
    ("draw/exact/triangles/fans.glsl", "if (p.count == 0) fans[(firstFan + entry) * fanTexels] = uvec4(1u);"):
        "a fan of one corner has no triangle",
    ("draw/overlay/field_means.glsl", "bits = (bits + 0xfff + ((bits >> 13) & 1)) & ~0x1ff7;"):
        "a thousandth of a half float's step, which storing one drops",
    ("draw/overlay/chart_shading.glsl", "bool within = p.x > 0.0f && p.y >= 0.0f && p.x <= size.x && p.y <= size.y;"):
        "the plot's sides are whole, middles of pixels are not",
    ("draw/overlay/chart_shading.glsl", "bool within = p.x >= 0.0f && p.y > 0.0f && p.x <= size.x && p.y <= size.y;"):
        "the plot's sides are whole, middles of pixels are not",
    ("draw/overlay/chart_shading.glsl", "bool within = p.x >= 0.0f && p.y >= 0.0f && p.x < size.x && p.y <= size.y;"):
        "the plot's sides are whole, middles of pixels are not",
    ("draw/overlay/chart_shading.glsl", "vec4 square = vec4(1e12f), below = vec4(-1000001.0f);"):
        "further than anything on a picture is",
    ("draw/overlay/chart_shading.glsl", "vec4 square = vec4(1e12f), below = vec4(-1010000.0f);"):
        "further than anything on a picture is",
    ("draw/exact/instances/raster_ball.glsl", "if (!(ball.radius > 0.0f) || farthest < view.near) return ivec4(1, 0, -1, -1);"):
        "a box that ends before it begins in one direction is empty",
    ("draw/exact/instances/raster_ball.glsl", "if (!(ball.radius > 0.0f) || farthest < view.near) return ivec4(0, 1, -1, -1);"):
        "a box that ends before it begins in one direction is empty",
    ("draw/exact/instances/raster_ball.glsl", "if (!(ball.radius > 0.0f) || farthest < view.near) return ivec4(0, 0, 1, -1);"):
        "a box that ends before it begins in one direction is empty",
    ("draw/exact/instances/raster_ball.glsl", "if (!(ball.radius > 0.0f) || farthest < view.near) return ivec4(0, 0, -1, 1);"):
        "a box that ends before it begins in one direction is empty",
    ("draw/exact/instances/raster_ball.glsl", "if (x.x > x.y || y.x > y.y) return ivec4(1, 0, -1, -1);"):
        "a box that ends before it begins in one direction is empty",
    ("draw/exact/instances/raster_ball.glsl", "if (x.x > x.y || y.x > y.y) return ivec4(0, 1, -1, -1);"):
        "a box that ends before it begins in one direction is empty",
    ("draw/exact/instances/raster_ball.glsl", "if (x.x > x.y || y.x > y.y) return ivec4(0, 0, 1, -1);"):
        "a box that ends before it begins in one direction is empty",
    ("draw/exact/instances/raster_ball.glsl", "if (x.x > x.y || y.x > y.y) return ivec4(0, 0, -1, 1);"):
        "a box that ends before it begins in one direction is empty",
    ("draw/exact/instances/glows.comp", "if (max(box.z + box.x, box.w - box.y) >= smallPixels) {"):
        "either way of drawing gives the same, as a test says, and this asks for fewer small ones",
    ("draw/exact/instances/glows.comp", "if (max(box.z - box.x, box.w + box.y) >= smallPixels) {"):
        "either way of drawing gives the same, as a test says, and this asks for fewer small ones",
    ("draw/exact/instances/glows.comp", "if (max(box.z - box.x, box.w - box.y) > smallPixels) {"):
        "either way of drawing gives the same, as a test says",
    ("draw/exact/triangles/medium.comp",
     "for (uint entry = gl_WorkGroupID.x * teams + me / teamSize; entry < count; entry += gl_NumWorkGroups.x + teams) {"):
        "some are drawn twice, which shows nothing; a group alone has no more than it begins with",
    ("draw/exact/surface/surface_seen.glsl",
     "return (weight.x >= 0.0f ? 1 : 0) | (weight.y > 0.0f ? 2 : 0) | (weight.z > 0.0f ? 4 : 0);"):
        "a side of no weight is read and counts nothing",
    ("draw/exact/surface/skin_read.glsl", "area.color = vec3(1);"):
        "only of looks that read no colour of an area",
    ("draw/exact/instances/glow_disc.glsl", "ivec2 last = min(ivec2(int(floor(x.y)), int(ceil(y.y))), view.size - 1);"):
        "a wider box, of which every sample is looked at by ray",
    ("draw/exact/instances/glow_disc.glsl", "if (x.x > x.y && y.x > y.y) return glow;"):
        "a box that ends before it begins in one direction is empty",
    ("draw/exact/instances/add_glows.comp", "precise float sum = light[i] + (float(min(upper, 0xfffffbu)) * glowUpper + fine);"):
        "either light is white",
    ("draw/exact/instances/ball.glsl",
     "precise float more = half_ + 0.01f + 1e-5f + (abs(middle) + half_);  // margin for rounding errors"):
        "a wider box, of which every sample is looked at by ray",
    ("draw/exact/triangles/triangle.glsl",
     "edge.bias = edge.step_.y > 0 || (edge.step_.y == 0 && edge.step_.x <= 0) ? 0 : -1;"):
        "only of an edge without length, whose triangle is empty",
    ("draw/exact/triangles/bins.glsl", "int end = t.high.x < 0 && t.high.y < 0 ? -1 : last.y;"):
        "a tile at the picture's side has it listed, of which it covers no sample",
    ("draw/exact/triangles/crossing.glsl",
     "int first = (int(floor(low)) + edge.from.x - subpixels) >> 12, last = (int(floor(high)) + edge.from.x + subpixels) >> 11;"):
        "a wider span, of which every tile is tested: the box bounds it",
    ("draw/exact/triangles/fill_box.glsl",
     "const float maxAround = 24821.76f;"):
        "either way of drawing gives the same, as a test says: E is below 2^31 up to 32768",
    ("draw/exact/tiles/tiles.comp",
     "bool within = above.x > offAbove.x || above.y > offAbove.y && below.x > offBelow.x && below.y > offBelow.y;"):
        "more tiles look for a shadow of the sun, of which there is none where its map does not reach",
    ("draw/exact/screen/bloom_up.comp", "if (at.x >= size.x || at.y > size.y) return;"):
        "what is stored beyond an image is dropped",
    ("draw/overlay/chart_shading.glsl",
     "if (zero > 0.0f && p.x > 0.0f && p.x <= plotSize.x) sum = covered(sum, vec3(1.0f), zeroAlpha);"):
        "the plot's sides are whole, middles of pixels are not",
    # The following mutants are in simulations.
    ("fluid/solver/decide.comp", "float each = exactReciprocal(max(speed, 0.0));"):
        "of a speed of 1e-20 and less the share is 0, whatever this is",
    ("water/float_motion.glsl", "int y = int(floor(clamp(row, -30000.0f, 60600.0f))) - reach;"):
        "water has 16,384 rows at most: either is beyond them",
    ("cloth/motion.glsl", "return max(distance, speed) >= 0x501502f9;"):
        "one number of all, 1e10 to the last bit, and what moves does not stay there",
    ("cloth/motion.glsl", "int distance = floatBitsToInt(exactDot(m.position, m.position)) & 0x7ffffffd;"):
        "the second last bit of a square, which is compared with 1e10",
    ("contact/start.comp", "keepPoint(startSection, v, vec4(carriedTo(pointAt(nowSection, v), up, down), 1.0f));"):
        "only xyz of that section are read",
    ("grid/tally_join.comp", "vec4 maximum = vec4(-0.0f);"):
        "what is kept the most of is never negative: speeds, depths, shares and counts",
    ("common/once.glsl", "return max(x, ivec4(-0x7fffffdf));"):
        "no uniform is that far below 0",
    ("cave/nearest.comp", "if (gl_GlobalInvocationID.x >= 33u * uint(rowWords)) return;"):
        "beyond the end of a row is the next row's cell, of which the same is found",
    ("particles/drift.comp", "if (i > stepData.count) return;"):
        "what is stored behind the last particle is dropped, or lies where nothing reads",
}
