// Everything about a scene that is words and numbers.

/// A table with a heading; rows are lists of cells, each text or an element.
function table(title, heads, rows, name) {
  const cells = (row) => row.cells.map((cell, i) => element(i === 0 ? "th" : "td", i === 0 ? {scope: "row"} : {}, cell));
  return element("section", {class: "card " + (name || "")}, element("h3", {}, title),
                 element("div", {class: "wide"},
                         element("table", {},
                                 element("thead", {}, element("tr", {}, ...heads.map((head) => element("th", {scope: "col"}, head)))),
                                 element("tbody", {}, ...rows.map((row) => element("tr", {class: row.class}, ...cells(row)))))));
}

/// A path that may be broken after its slashes.
function breakable(path) {
  const parts = path.split("/");
  return element("span", {}, ...parts.flatMap((part, i) => i < parts.length - 1 ? [part + "/", element("wbr")] : [part]));
}

/// Names and values; empty values are left out.
function facts(title, pairs, name) {
  const known = pairs.filter(([, value]) => value !== "" && value !== null && value !== undefined);
  if (known.length === 0) return null;
  return element("section", {class: "card " + (name || "")}, element("h3", {}, title),
                 element("dl", {}, ...known.flatMap(([key, value]) => [element("dt", {}, key), element("dd", {}, value)])));
}

function lines(title, texts, name) {
  if (texts.length === 0) return null;
  return element("section", {class: "card " + name}, element("h3", {}, title),
                 element("ul", {}, ...texts.map((text) => element("li", {}, text))));
}

function checksTable(scene) {
  if (scene.checks.length === 0) return null;
  const limits = (check) => {
    if (check.least !== null && check.most !== null) return format(check.least, 6) + " to " + format(check.most, 6);
    if (check.least !== null) return "≥ " + format(check.least, 6);
    return check.most !== null ? "≤ " + format(check.most, 6) : "–";
  };
  // Failures first; each line leads to its frame where that frame is shown.
  const checks = [...scene.checks].sort((a, b) => a.passed - b.passed);
  return table("Checks", ["check", "frame", "value", "bounds", ""], checks.map((check) => {
    const index = scene.frames.findIndex((frame) => frame.frame === check.frame);
    const place = index < 0 ? String(check.frame) :
        element("button", {class: "link", onclick: () => go({frame: index})}, String(check.frame));
    const result = check.passed ? "✓ holds" : "✕ " + (check.message || "fails");
    return {class: check.passed ? "holds" : "fails", cells: [check.what, place, format(check.value, 6), limits(check), result]};
  }), "checks");
}

/// The largest measured value that each bound limits, over the scene's frames.
const measuredFor = {
  max_channel_diff: (m) => m.worst, max_diff_pixels: (m) => m.pixelsBeyond, max_diff_ratio: (m) => m.ratioBeyond,
  max_window_ratio: (m) => m.windowRatio, max_flip_mean: (m) => m.flipMean, hard_fail: (m) => m.worst,
};

function toleranceTable(scene) {
  const fields = Object.keys(scene.tolerance);
  if (fields.length === 0) return null;
  const measured = scene.frames.some((frame) => frame.metrics);
  return table(scene.sameNumerics ? "Tolerance (not used: equal numerics ask for equal pixels)" : "Tolerance",
               ["bound", "value", "largest measured", "set by"], fields.map((field) => {
                 const value = measured && measuredFor[field] ? largest(scene, measuredFor[field]) : null;
                 const bound = scene.tolerance[field];
                 // max_channel_diff decides which pixels count; it is no limit itself.
                 const over = !scene.sameNumerics && value !== null && field !== "max_channel_diff" && value > bound.value;
                 return {class: over ? "fails" : "",
                         cells: [field, format(bound.value), value === null ? "–" : format(value), breakable(bound.origin)]};
               }), "tolerance");
}

function baselineFacts(scene) {
  const used = !scene.profile ? "none" :
      scene.profile + (scene.profile === suite.environment.profile ? "" : " (this run is " + suite.environment.profile + ")");
  return facts("Baseline", [
    ["profile", used],
    ["compared", !scene.profile ? "" : scene.sameNumerics ? "pixel by pixel, exactly: same numerics" : "within the tolerance: other numerics"],
    ["made by", [scene.baselineDriver, scene.baselineVersion && "simreel " + scene.baselineVersion].filter(Boolean).join(", ")],
    ["reason", scene.baselineReason], ["folder", scene.baselines],
  ], "baseline");
}

function divergenceCard(scene) {
  if (!scene.divergence) return null;
  const text = divergenceText(scene.divergence);
  const message = scene.messages.includes(scene.divergence.message) ? "" : scene.divergence.message;
  return element("section", {class: "card divergence"}, element("h3", {}, "Divergence"),
                 element("p", {}, "The state " + text + "."), message ? element("p", {class: "dim"}, message) : null);
}

function runCard() {
  const card = facts("This run", [
    ["driver", suite.environment.driver], ["profile", suite.environment.profile],
    ["numerics", suite.environment.fingerprint], ["memory path", suite.environment.memoryPath],
    ["simreel", suite.simreel], ["took", seconds(suite.seconds)],
    ["command", suite.command ? element("span", {class: "command"}, ...commandLine(suite.command, "the command of this run")) : ""],
    ["accept all", suite.acceptCommand ?
       element("span", {class: "command"}, ...commandLine(suite.acceptCommand, "the command that accepts every scene")) : ""],
  ], "environment");
  return card;
}

function showDetails(scene) {
  const attempts = scene.attempts.map((attempt, i) =>
      "attempt " + (i + 1) + ": " + statusWords[attempt.status] + (attempt.messages.length ? ": " : "") + attempt.messages.join("; "));
  if (attempts.length > 0) attempts.push("attempt " + (attempts.length + 1) + ": " + (scene.status === "flaky" ? "passed" : statusWords[scene.status]));
  const cards = [
    divergenceCard(scene), lines("Attempts", attempts, "attempts"), checksTable(scene), toleranceTable(scene),
    baselineFacts(scene), lines("Notes", scene.notes, "notes"), runCard(),
    facts("Scene", [["file", scene.file], ["took", seconds(scene.seconds) + ", " + seconds(scene.simulateSeconds) + " of it simulating"],
                    ["runs", scene.repeats > 1 ? String(scene.repeats) : ""]], "sceneFacts"),
  ];
  const whole = cards.filter((card) => card && (card.matches(".divergence, .checks")));
  const others = cards.filter((card) => card && !whole.includes(card));
  byId("details").replaceChildren(...whole, element("div", {class: "columns"}, ...others));
}

// ---- above the pictures ----

/// The first few, and a button for the others.
function showMessages(messages) {
  const most = 4;
  const box = byId("messages");
  const more = messages.length > most ? messages.length - most + 1 : 0;
  box.replaceChildren(...messages.slice(0, messages.length - more));
  if (more === 0) return;
  const button = element("button", {class: "link"}, more + " more");
  button.addEventListener("click", () => box.replaceChildren(...messages));
  box.append(element("li", {class: "more"}, button));
}

function showHead(scene) {
  byId("name").textContent = scene.name;
  byId("badge").replaceChildren(badge(scene.status));
  byId("file").textContent = scene.file;
  // Those that each frame repeats come last.
  const ofFrames = new Set(scene.frames.map((frame) => "frame " + frame.frame + ": " + frame.message));
  const texts = [...scene.messages].sort((a, b) => ofFrames.has(a) - ofFrames.has(b));
  const messages = texts.map((text) => element("li", {}, text));
  if (scene.xfail) {
    const reason = (scene.status === "xpass" ? "it was expected to fail: " : "expected to fail: ") + scene.xfail;
    messages.unshift(element("li", {class: "xfail"}, reason));
  }
  showMessages(messages);
  const command = acceptCommand(scene);
  byId("accept").hidden = command === "" && !isFailure(scene.status);
  byId("accept").replaceChildren(...command ? [element("span", {class: "dim"}, "accept"), ...commandLine(command, "the command that accepts this scene")] :
                                              [element("span", {class: "dim"}, "Nothing was kept to accept.")]);
}

/// One measurement; `over` where it breaks its bound.
function metric(label, value, over, note) {
  return element("div", {class: over ? "over" : ""}, element("dt", {}, label), element("dd", {}, value, note ? element("small", {}, " " + note) : null));
}

function showMetrics(scene, frame) {
  const box = byId("metrics");
  const stateWord = frame && frame.state && frame.state !== "equal" ? [metric("state", frame.state, frame.state === "different")] :
                                                                     frame && frame.state ? [metric("state", "equal")] : [];
  if (!frame || !frame.metrics) {
    const pixels = frame && equalPixels(frame) ? [metric("pixels", "equal")] : [];
    return box.replaceChildren(...pixels, ...stateWord);
  }
  const m = frame.metrics;
  // With equal numerics any difference is one too many, and the bounds are not in force.
  const over = (field, value) => scene.sameNumerics ? value > 0 : scene.tolerance[field] !== undefined && value > scene.tolerance[field].value;
  const bound = (field, text) => !scene.sameNumerics && scene.tolerance[field] !== undefined ? "≤ " + text(scene.tolerance[field].value) : "";
  const beyond = scene.tolerance.max_channel_diff ? scene.tolerance.max_channel_diff.value : 0;
  box.replaceChildren(
      metric("worst", m.worst + " at " + m.worstX + ", " + m.worstY, over("hard_fail", m.worst), bound("hard_fail", format)),
      metric("differ", plural(m.differentPixels, "pixel"), scene.sameNumerics && m.differentPixels > 0),
      metric("beyond " + format(beyond), m.pixelsBeyond + " = " + percent(m.ratioBeyond),
             over("max_diff_ratio", m.ratioBeyond) || over("max_diff_pixels", m.pixelsBeyond),
             bound("max_diff_ratio", percent) || bound("max_diff_pixels", format)),
      metric("densest " + windowSize() + "×" + windowSize(), percent(m.windowRatio) + " at " + m.windowX + ", " + m.windowY,
             over("max_window_ratio", m.windowRatio), bound("max_window_ratio", percent)),
      metric("PSNR", m.psnr === null ? "∞" : m.psnr.toFixed(1) + " dB"), metric("SSIM", format(m.ssim, 5)),
      metric("FLIP", format(m.flipMean, 3), over("max_flip_mean", m.flipMean), bound("max_flip_mean", format)),
      ...stateWord);
}
