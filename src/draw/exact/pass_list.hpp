#pragma once
#include "draw/exact/pass_entry.hpp"

#include <string>
#include <vector>

namespace simreel::draw {

// Factories of the passes, defined in draw/exact/passes.
PassMaker makeSkins, makeThings, makeRayScene, makeJoinedSurfaces, makeLampMaps, makeSunMap, makeMirrors,
    makeView, makeVisibility, makeLensNearness, makeNearness, makeOpenness, makeTiles, makeKeptVisibility,
    makeBlended, makeSurfaces, makeRayLight, makeEdges, makeLayers, makeMirrored, makeReflected, makeUneven,
    makeRefined, makeSpread, makeBehindGlass, makeFarGlass, makeNearGlass, makeKeptLight, makeLensShift,
    makeGlows, makeMean, makeKeptGlow, makeFieldsBehind, makeScatter, makeFilm;

/// Resources that hold only the current band of a picture. A pass with Each::view ends the loop over the
/// bands. If later passes read one of these resources, the passes that wrote it run again, band by band.
inline constexpr Names ofBands = {"visibility", "tiles", "through"};

/// Passes of an exact picture in the order in which they run. Columns: name, frequency, stage of `simreel
/// bench`, resources read, resources written, names that `simreel bisect --passes` compares, factory.
// clang-format off
inline constexpr PassEntry exactPasses[] = {
    {"skins", Each::picture, nullptr, {"fields"}, {"skins"}, {}, makeSkins},

    {"things", Each::moment, nullptr, {"drawables"}, {"things", "lights", "view"}, {}, makeThings},
    {"mirrors", Each::moment, nullptr, {"things", "skins"}, {"mirrors"}, {}, makeMirrors},
    {"ray scene", Each::moment, "rays", {"things", "lights", "skins"}, {"ray scene"}, {}, makeRayScene},
    {"joined", Each::moment, nullptr, {"things"}, {"joined"}, {}, makeJoinedSurfaces},
    {"lamp maps", Each::moment, "shadow", {"things", "joined", "lights"}, {"lamp maps"}, {}, makeLampMaps},
    {"sun map", Each::moment, "shadow", {"things", "joined"}, {"sun map"}, {}, makeSunMap},

    {"view", Each::view, nullptr, {"view"}, {"view", "light"}, {}, makeView},
    {"visibility", Each::band, "visibility", {"things", "joined", "view", "skins"}, {"visibility"}, {},
     makeVisibility},
    {"lens nearness", Each::band, "lens", {"visibility", "view"}, {"lens nearness"}, {}, makeLensNearness},
    {"nearness", Each::band, "occlusion", {"visibility", "view", "mirrors"}, {"nearness"}, {}, makeNearness},
    {"openness", Each::view, "occlusion", {"nearness", "view"}, {"openness"}, {}, makeOpenness},
    {"tiles", Each::band, "surfaces", {"visibility", "view"}, {"tiles", "visibility", "light"}, {}, makeTiles},
    {"kept visibility", Each::band, nullptr, {"visibility", "sun map", "lamp maps", "openness"}, {},
     {"visibility", "shadow"}, makeKeptVisibility},
    {"blended", Each::band, "surfaces",
     {"visibility", "skins", "lights", "sun map", "lamp maps", "openness", "ray scene", "light"},
     {"through", "light"}, {}, makeBlended},
    {"surfaces", Each::band, "surfaces",
     {"visibility", "tiles", "through", "skins", "lights", "sun map", "lamp maps", "openness"},
     {"light", "ray spots"}, {}, makeSurfaces},
    {"ray light", Each::band, "surfaces", {"visibility", "ray scene", "ray spots", "lights"}, {"light"}, {},
     makeRayLight},
    {"edges", Each::band, "surfaces", {"light"}, {"light"}, {}, makeEdges},
    {"layers", Each::band, "surfaces",
     {"visibility", "tiles", "through", "view", "skins", "lens nearness"}, {"layers"}, {}, makeLayers},
    {"mirrored", Each::view, "reflections", {"mirrors", "light", "nearness"}, {"mirrored", "changes"}, {},
     makeMirrored},
    {"reflected", Each::band, "reflections",
     {"mirrors", "mirrored", "changes", "visibility", "tiles", "through", "openness", "skins"}, {"changes"}, {},
     makeReflected},
    {"uneven", Each::view, "reflections", {"mirrors", "changes", "light"}, {"uneven", "changes"}, {}, makeUneven},
    {"refined", Each::band, "reflections",
     {"mirrors", "mirrored", "changes", "uneven", "light", "visibility", "tiles", "through", "openness", "skins"},
     {"changes"}, {}, makeRefined},
    {"spread", Each::view, "reflections", {"mirrors", "changes", "light"}, {"light"}, {}, makeSpread},
    {"behind far glass", Each::view, "reflections", {"things", "light", "nearness"}, {"behind glass"}, {},
     makeBehindGlass},
    {"far glass", Each::band, "surfaces",
     {"visibility", "view", "skins", "lights", "sun map", "lamp maps", "behind glass", "light"}, {"light"}, {},
     makeFarGlass},
    {"behind near glass", Each::view, "reflections", {"things", "light", "nearness"}, {"behind glass"}, {},
     makeBehindGlass},
    {"near glass", Each::band, "surfaces",
     {"visibility", "view", "skins", "lights", "sun map", "lamp maps", "behind glass", "light"}, {"light"}, {},
     makeNearGlass},
    {"kept light", Each::band, nullptr, {"light"}, {}, {"light"}, makeKeptLight},
    {"lens shift", Each::view, "lens", {"light", "lens nearness", "view"}, {"light"}, {}, makeLensShift},
    {"glows", Each::band, "instances", {"things", "visibility", "light"}, {"light"}, {}, makeGlows},
    {"mean", Each::view, "lens", {"light", "view"}, {"light", "view"}, {"light"}, makeMean},

    {"kept glow", Each::picture, nullptr, {"light"}, {}, {"glow"}, makeKeptGlow},
    {"fields behind", Each::picture, "fields", {"fields", "light"}, {"light"}, {"glow"}, makeFieldsBehind},
    {"scatter", Each::picture, "bloom", {"light"}, {"scattered"}, {"bloom"}, makeScatter},
    {"film", Each::picture, "tone map", {"light", "scattered", "view"}, {"picture", "layers"}, {"picture"},
     makeFilm},
};
// clang-format on

inline constexpr PassList exactPassList{
    exactPasses, {"drawables", "fields"}, {"picture", "layers"}, ofBands};
static_assert(faultOf(exactPassList).what.empty(), "see faultOf() for what is wrong with the list");

/// Returns the names in PassEntry::kept, in the order in which `simreel bisect --passes` compares them.
/// Files, messages and documentation use the same names. A picture has only the passes that it needs:
///
/// - visibility: depth key and primitive id of each sample, including the ground
/// - shadow: shadow maps of the sun and the lamps; with quality "standard" also ambient occlusion and
///   nearness at half resolution
/// - light: light of opaque surfaces per pixel; with quality "standard" including reflections
/// - glow: light after adding glows, then after adding fields behind the scene
/// - bloom: light scattered around bright areas
/// - picture: bytes after lens and film, then with fields, axes and charts on top
[[nodiscard]] const std::vector<std::string>& passNames();

}  // namespace simreel::draw
