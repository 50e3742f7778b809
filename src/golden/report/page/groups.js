// Failures that look alike, for the overview: what one change of a program broke is looked at and accepted at once.

/// Classes of a difference: the largest of a channel, and the share of pixels that differ at all. The last has no end.
const worstClasses = [[1, "by 1 of 255"], [4, "by 2 to 4 of 255"], [16, "by up to 16 of 255"], [64, "by up to 64 of 255"],
                      [Infinity, "by more than 64 of 255"]];
const areaClasses = [[0.001, "under 0.1 % of the pixels"], [0.01, "under 1 %"], [0.1, "under 10 %"],
                     [0.5, "under half of the pixels"], [Infinity, "most of the picture"]];
const classOf = (classes, value) => classes.find(([most]) => value <= most)[1];

/// The frame that tells most about a scene: where it first fails.
const tellingFrame = (scene) => scene.frames[firstFrame(scene)] || null;

/// Share of pixels with any difference, as far as the measurements say it.
function differingShare(metrics) {
  if (metrics.pixelsBeyond > 0 && metrics.ratioBeyond > 0)
    return metrics.differentPixels * metrics.ratioBeyond / metrics.pixelsBeyond;
  return metrics.differentPixels > 0 ? 0.0005 : 0;
}

/// What a message says without what is this scene's alone: numbers, and words in quotes.
function plainMessage(scene) {
  const frame = tellingFrame(scene);
  const text = scene.messages[0] || (frame && ownMessage(frame)) || statusWords[scene.status];
  return text.replaceAll(scene.file, "the file").replaceAll(scene.name, "it").replace(/"[^"]*"|'[^']*'/g, "…")
      .replace(/[0-9]+(\.[0-9]+)?/g, "#");
}

/// What failures of one group share, as a few words; the first says how it came out. Of pictures that differ: the pass
/// that first does, the class of the worst pixel and that of the area. Of state: the array. Of others: the message.
function signature(scene) {
  const frame = tellingFrame(scene), metrics = frame && frame.metrics;
  if (scene.divergence && scene.divergence.buffer)
    return ["state differs", [scene.divergence.object, scene.divergence.buffer].filter(Boolean).join(".")];
  if (scene.status === "fail" && frame && frame.status === "fail" && /sizes? |[0-9]+x[0-9]+, its baseline/.test(frame.message))
    return ["sizes differ"];
  if (metrics && metrics.worst > 0 && isFailure(frame.status))
    return [frame.status === "nondeterministic" ? "two runs differ" : "pictures differ",
            frame.pass && frame.pass.pass ? "first in pass " + frame.pass.pass : "",
            classOf(worstClasses, Math.ceil(metrics.worst)), classOf(areaClasses, differingShare(metrics))].filter(Boolean);
  const check = scene.checks.find((one) => !one.passed);
  if (check) return ["a check fails", check.what.replace(/[0-9.]+/g, "#")];
  return [statusWords[scene.status], plainMessage(scene)].filter((text, i, all) => all.indexOf(text) === i);
}

/// [{status, words, scenes}]: the worst status first, then the largest.
function groupsOf(scenes) {
  const groups = new Map();
  for (const scene of scenes) {
    const words = signature(scene), key = JSON.stringify([scene.status, words]);
    if (!groups.has(key)) groups.set(key, {status: scene.status, words, scenes: []});
    groups.get(key).scenes.push(scene);
  }
  const rank = (group) => statusOrder.indexOf(group.status);
  for (const group of groups.values()) group.scenes.sort((a, b) => natural(a.name, b.name));
  return [...groups.values()].sort((a, b) => rank(a) - rank(b) || b.scenes.length - a.scenes.length);
}

/// The command that accepts all of these, "" where none can be; without names where it is all that can be accepted.
function acceptAll(scenes) {
  const kept = scenes.filter(acceptCommand);
  if (kept.length === 0) return "";
  if (kept.length === suite.scenes.filter(acceptCommand).length) return suite.acceptCommand;
  return suite.acceptCommand + kept.map((scene) => " --only " + shellWord(scene.name)).join("");
}
