// Groups similar failures for the overview, so that everything broken by one change can be reviewed and accepted at
// once.

/// Classes of differences by the largest channel difference and by the fraction of differing pixels. The last class has
/// no upper limit.
const worstClasses = [[1, "by 1 of 255"], [4, "by 2 to 4 of 255"], [16, "by up to 16 of 255"], [64, "by up to 64 of 255"],
                      [Infinity, "by more than 64 of 255"]];
const areaClasses = [[0.001, "under 0.1 % of the pixels"], [0.01, "under 1 %"], [0.1, "under 10 %"],
                     [0.5, "under half of the pixels"], [Infinity, "most of the picture"]];
const classOf = (classes, value) => classes.find(([most]) => value <= most)[1];

/// Returns the frame that represents a scene: the first failing one.
const tellingFrame = (scene) => scene.frames[firstFrame(scene)] || null;

/// Returns the fraction of pixels with any difference, estimated from the metrics.
function differingShare(metrics) {
  if (metrics.pixelsBeyond > 0 && metrics.ratioBeyond > 0)
    return metrics.differentPixels * metrics.ratioBeyond / metrics.pixelsBeyond;
  return metrics.differentPixels > 0 ? 0.0005 : 0;
}

/// Returns the scene's message without parts that are specific to the scene: numbers and quoted words.
function plainMessage(scene) {
  const frame = tellingFrame(scene);
  const text = scene.messages[0] || (frame && ownMessage(frame)) || statusWords[scene.status];
  return text.replaceAll(scene.file, "the file").replaceAll(scene.name, "it").replace(/"[^"]*"|'[^']*'/g, "…")
      .replace(/[0-9]+(\.[0-9]+)?/g, "#");
}

/// Returns the words that all failures of a group have in common. The first word is the kind of failure. For differing
/// pictures, the next words are the first differing pass, the class of the worst pixel and the class of the differing
/// area. For differing states, the next word is the array. For other failures, it is the message.
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

/// Returns a list of {status, words, scenes}, sorted by severity of the status, then by number of scenes.
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

/// Returns the command that accepts all these scenes, or "" if no results were stored. Omits the names if there are no
/// other scenes to accept.
function acceptAll(scenes) {
  const kept = scenes.filter(acceptCommand);
  if (kept.length === 0) return "";
  if (kept.length === suite.scenes.filter(acceptCommand).length) return suite.acceptCommand;
  return suite.acceptCommand + kept.map((scene) => " --only " + shellWord(scene.name)).join("");
}
