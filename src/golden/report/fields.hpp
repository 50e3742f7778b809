#pragma once
#include "golden/result.hpp"

#include <concepts>
#include <type_traits>

namespace simreel::golden {

// Keys of report.json, defined once for writing and reading. A visitor is called with each key and member
// in the file's order. Some members have their own visitor function:
//  decibels  a number, or null for infinity
//  path      a path below the report's folder
//  format    the version number of the file format
//  group     an object whose keys belong to the same struct
//  counts    the number of scenes with each status

/// T is S or const S, because fields() serves both the Writer (const) and the Reader.
template <class S, class T>
concept Is = std::same_as<std::remove_const_t<S>, T>;

template <class Visit>
void fields(Visit& visit, Is<Metrics> auto& m) {
  visit("worst", m.worst);
  visit("worstX", m.worstX);
  visit("worstY", m.worstY);
  visit("differentPixels", m.differentPixels);
  visit("pixelsBeyond", m.pixelsBeyond);
  visit("ratioBeyond", m.ratioBeyond);
  visit("windowRatio", m.windowRatio);
  visit("windowX", m.windowX);
  visit("windowY", m.windowY);
  visit.decibels("psnr", m.psnr);
  visit("ssim", m.ssim);
  visit("flipMean", m.flipMean);
  visit("maskedPixels", m.maskedPixels);
  visit("antialiasedPixels", m.antialiasedPixels);
  visit("movedPixels", m.movedPixels);
}

template <class Visit>
void fields(Visit& visit, Is<PassPlace> auto& p) {
  visit("pass", p.pass);
  visit("x", p.x);
  visit("y", p.y);
  visit("shows", p.shows);
  visit("message", p.message);
}

template <class Visit>
void fields(Visit& visit, Is<OtherPicture> auto& o) {
  visit("label", o.label);
  visit.path("image", o.image);
}

template <class Visit>
void fields(Visit& visit, Is<FrameResult> auto& f) {
  visit("frame", f.frame);
  visit("time", f.time);
  visit("status", f.status);
  visit("message", f.message);
  visit("pixels", f.pixels);
  visit("expectedPixels", f.expectedPixels);
  visit("alternate", f.alternate);
  visit("state", f.state);
  visit("asked", f.asked);
  visit("metrics", f.metrics);
  visit("pass", f.pass);
  visit.path("expectedImage", f.expectedImage);
  visit.path("actualImage", f.actualImage);
  visit.path("differenceImage", f.differenceImage);
  visit.path("flipImage", f.flipImage);
  visit("others", f.others);
}

template <class Visit>
void fields(Visit& visit, Is<CheckResult> auto& c) {
  visit("what", c.what);
  visit("frame", c.frame);
  visit("value", c.value);
  visit("least", c.min);
  visit("most", c.max);
  visit("passed", c.passed);
  visit("message", c.message);
}

template <class Visit>
void fields(Visit& visit, Is<Divergence> auto& d) {
  visit("frame", d.frame);
  visit("step", d.step);
  visit("steps", d.steps);
  visit("object", d.object);
  visit("buffer", d.buffer);
  visit("firstElement", d.firstElement);
  visit("lastElement", d.lastElement);
  visit("message", d.message);
}

template <class Visit>
void fields(Visit& visit, Is<Bound> auto& b) {
  visit("value", b.value);
  visit("origin", b.origin);
}

template <class Visit>
void fields(Visit& visit, Is<Place> auto& p) {
  visit("file", p.file);
  visit("line", p.line);
}

template <class Visit>
void fields(Visit& visit, Is<Attempt> auto& a) {
  visit("status", a.status);
  visit("messages", a.messages);
}

template <class Visit>
void fields(Visit& visit, Is<SceneResult> auto& s) {
  visit("name", s.name);
  visit("file", s.file);
  visit("baselines", s.baselines);
  visit("status", s.status);
  visit("messages", s.messages);
  visit("notes", s.notes);
  visit("xfail", s.xfail);
  visit("profile", s.profile);
  visit("asked", s.asked);
  visit("baselineDriver", s.baselineDriver);
  visit("baselineProcessor", s.baselineProcessor);
  visit("baselineVersion", s.baselineVersion);
  visit("baselineReason", s.baselineReason);
  visit("tolerance", s.tolerance);
  visit("seconds", s.seconds);
  visit("simulateSeconds", s.simulateSeconds);
  visit("repeats", s.repeats);
  visit("attempts", s.attempts);
  visit("frames", s.frames);
  visit("checks", s.checks);
  visit("divergence", s.divergence);
  visit.path("candidate", s.candidate);
  visit("inputs", s.inputs);
  visit("blame", s.blame);
  visit("renamedFrom", s.renamedFrom);
}

template <class Visit>
void fields(Visit& visit, Is<Stale> auto& s) {
  visit("path", s.path);
  visit("message", s.message);
  visit("removed", s.removed);
}

template <class Visit>
void fields(Visit& visit, Is<SuiteResult> auto& s) {
  visit("simreel", s.version);
  visit.format("format");
  visit("unit", s.unit);
  visit("expected", s.expected);
  visit.group("environment", [&](auto& inside) {
    inside("driver", s.driver);
    inside("processor", s.processor);
    inside("profile", s.profile);
    inside("fingerprint", s.fingerprint);
    inside("drawing", s.drawing);
    inside("memoryPath", s.memoryPath);
  });
  visit("command", s.command);
  visit("shard", s.shard);
  visit("acceptCommand", s.acceptCommand);
  visit("allowFlaky", s.allowFlaky);
  visit("strict", s.strict);
  visit("seconds", s.seconds);
  visit("notes", s.notes);
  visit("stale", s.stale);
  visit.counts("counts", s);
  visit("scenes", s.scenes);
}

}  // namespace simreel::golden
