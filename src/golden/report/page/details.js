// Cards with texts and numbers about a scene.

function card(title, name, ...content) {
  return element("section", {class: "card " + name}, element("h3", {}, title), ...content);
}

/// Returns a table card. Each row is {class, cells}; a cell is a text or an element.
function table(title, name, heads, rows) {
  const head = element("tr", {}, ...heads.map((text) => element("th", {scope: "col"}, text)));
  const line = ({cells: [first, ...others], class: kind}) =>
      element("tr", {class: kind}, element("th", {scope: "row"}, first),
              ...others.map((cell) => element("td", {}, cell)));
  const made = element("table", {}, element("thead", {}, head), element("tbody", {}, ...rows.map(line)));
  return card(title, name, element("div", {class: "wide"}, made));
}

/// Returns a card of names and values. Leaves out empty values.
function facts(title, name, pairs) {
  const lines = pairs.filter(([, value]) => value !== "" && value !== null && value !== undefined)
                    .flatMap(([key, value]) => [element("dt", {}, key), element("dd", {}, value)]);
  return lines.length > 0 ? card(title, name, element("dl", {}, ...lines)) : null;
}

function lines(title, name, texts) {
  if (texts.length === 0) return null;
  return card(title, name, element("ul", {}, ...texts.map((text) => element("li", {}, text))));
}

/// Returns a path with optional line breaks after its slashes.
function breakable(path) {
  const made = element("span", {});
  path.split("/").forEach((part, i) => made.append(...i > 0 ? ["/", element("wbr"), part] : [part]));
  return made;
}

// ---- cards below the pictures ----

function checkBounds(check) {
  const {least, most} = check;
  if (least !== null && most !== null) return format(least, 6) + " to " + format(most, 6);
  if (least !== null) return "≥ " + format(least, 6);
  return most !== null ? "≤ " + format(most, 6) : "–";
}

/// Returns the table of checks, failures first. The frame number is a button that selects the frame, if the frame is
/// part of the report.
function checksTable(scene) {
  if (scene.checks.length === 0) return null;
  const checks = [...scene.checks].sort((a, b) => a.passed - b.passed);
  return table("Checks", "checks", ["check", "frame", "value", "bounds", ""], checks.map((check) => {
    const index = scene.frames.findIndex((frame) => frame.frame === check.frame);
    const number = String(check.frame);
    const place = index < 0 ? number : element("button", {class: "link", onclick: () => go({frame: index})}, number);
    const result = check.passed ? "✓ holds" : "✕ " + (check.message || "fails");
    return {
      class: check.passed ? "holds" : "fails",
      cells: [check.what, place, format(check.value, 6), checkBounds(check), result],
    };
  }));
}

/// Measurement that each tolerance bound limits.
const measuredFor = {
  maxChannelDiff: (m) => m.worst,
  maxDiffPixels: (m) => m.pixelsBeyond,
  maxDiffRatio: (m) => m.ratioBeyond,
  maxWindowRatio: (m) => m.windowRatio,
  maxFlipMean: (m) => m.flipMean,
  hardFail: (m) => m.worst,
};

function toleranceTable(scene) {
  const fields = Object.entries(scene.tolerance);
  if (fields.length === 0) return null;
  const measured = scene.frames.some((frame) => frame.metrics);
  const unused = {exact: " (not used: exact pictures have to be equal)",
                  equal: " (not used: on the machine that drew the baseline pixels have to be equal)",
                  near: " (besides what is asked of another machine with the same numerics)"};
  const title = "Tolerance" + (unused[scene.asked] || "");
  return table(title, "tolerance", ["bound", "value", "largest measured", "set by"], fields.map(([field, bound]) => {
    const value = measured && measuredFor[field] ? largest(scene, measuredFor[field]) : null;
    // maxChannelDiff defines which pixels count as beyond; it is not a limit itself.
    const limit = !noneMayDiffer(scene.asked) && field !== "maxChannelDiff";
    return {
      class: limit && value !== null && value > bound.value ? "fails" : "",
      cells: [field, format(bound.value), format(value), breakable(bound.origin)],
    };
  }));
}

function baselineCard(scene) {
  if (ofPictures)
    return facts("Baseline", "baseline", [["file", breakable(scene.baselines)], ["renamed from", scene.renamedFrom]]);
  const own = suite.environment.profile;
  const how = {
    exact: "pixel by pixel, exactly: drawn in exact arithmetic",
    equal: "pixel by pixel, exactly: this machine drew it",
    near: "within 2 of 255 on 2 % of the pixels and a FLIP mean of 0.002: another machine with the same numerics drew it",
    tolerance: "within the tolerance: other numerics drew it",
  };
  const version = scene.baselineVersion ? "simreel " + scene.baselineVersion : "";
  return facts("Baseline", "baseline", [
    ["profile", !scene.profile ? "none" : scene.profile + (scene.profile === own ? "" : ` (this run is ${own})`)],
    ["compared", how[scene.asked]],
    ["made by", [scene.baselineDriver, version].filter(Boolean).join(", ")],
    ["on", scene.baselineProcessor],
    ["reason", scene.baselineReason],
    ["folder", breakable(scene.baselines)],
  ]);
}

function divergenceCard(scene) {
  if (!scene.divergence) return null;
  // The scene's messages are already shown above.
  const message = scene.messages.includes(scene.divergence.message) ? "" : scene.divergence.message;
  return card("Divergence", "divergence", element("p", {}, "The state " + divergenceText(scene.divergence) + "."),
              message ? element("p", {class: "dim"}, message) : null);
}

/// Returns a card with one line per failed attempt, then one for the last attempt.
function attemptsCard(scene) {
  if (scene.attempts.length === 0) return null;
  const tries = scene.attempts.map(({status, messages}) =>
      statusWords[status] + (messages.length > 0 ? ": " : "") + messages.join("; "));
  tries.push(scene.status === "flaky" ? "passed" : statusWords[scene.status]);
  return lines("Attempts", "attempts", tries.map((text, i) => "attempt " + (i + 1) + ": " + text));
}

/// Returns a card with the pictures of other attempts and of differing runs, each with its number.
function othersCard(scene) {
  const figures = scene.frames.flatMap((frame) => frame.others.map((other) =>
      element("figure", {class: "other"},
              element("a", {href: link(other.image)},
                      element("img", {src: link(other.image), alt: other.label, loading: "lazy"})),
              element("figcaption", {}, (ofPictures ? "" : "frame " + frame.frame + ": ") + other.label))));
  return figures.length > 0 ? card("Attempts and runs", "others", element("div", {class: "others"}, ...figures)) : null;
}

function staleCard() {
  const texts = suite.stale.map((one) => (one.removed ? "removed " : "") + one.path + ": " + one.message);
  return lines("Stale baselines", "stale", texts);
}

function runCard() {
  const environment = suite.environment;
  const command = (text, label) => text ? element("span", {class: "command"}, ...commandLine(text, label)) : "";
  return facts("This run", "environment", [
    ["driver", environment.driver],
    ["processor", environment.processor],
    ["profile", environment.profile],
    ["numerics", environment.fingerprint],
    ["drawing", environment.drawing],
    ["memory path", environment.memoryPath],
    ["simreel", suite.simreel],
    ["took", seconds(suite.seconds)],
    ["command", command(suite.command, "the command of this run")],
    ["accept all", command(suite.acceptCommand, "the command that accepts every scene")],
  ]);
}

function sceneCard(scene) {
  const simulated = ofPictures ? "" : ", " + seconds(scene.simulateSeconds) + " of it simulating";
  return facts(ofPictures ? "Picture" : "Scene", "sceneFacts", [
    ["file", breakable(scene.file)],
    ["took", seconds(scene.seconds) + simulated],
    ["runs", scene.repeats > 1 ? String(scene.repeats) : ""],
  ]);
}

function showDetails(scene) {
  const whole = [divergenceCard(scene), othersCard(scene), checksTable(scene)];
  const others = [attemptsCard(scene), toleranceTable(scene), baselineCard(scene),
                  lines("Notes", "notes", scene.notes), staleCard(),
                  lines("Notes of the run", "runNotes", suite.notes), runCard(), sceneCard(scene)];
  const columns = element("div", {class: "columns"}, ...others.filter(Boolean));
  byId("details").replaceChildren(...whole.filter(Boolean), columns);
}

// ---- above the pictures ----

/// Shows the first few messages and a button for the rest.
function showMessages(messages) {
  const most = 3;
  const box = byId("messages");
  box.replaceChildren(...messages.slice(0, most));
  if (messages.length <= most) return;
  const button = element("button", {class: "link more"}, messages.length - most + " more");
  button.addEventListener("click", () => {
    button.remove();
    box.replaceChildren(...messages);
  });
  box.lastChild.append(button);
}

function showAccept(scene) {
  const command = acceptCommand(scene);
  const box = byId("accept");
  box.hidden = command === "" && !isFailure(scene.status);
  const word = element("span", {class: "dim"}, command ? "accept" : "Nothing was kept to accept.");
  box.replaceChildren(word, ...command ? commandLine(command, "the command that accepts this scene") : []);
}

function showHead(scene) {
  byId("name").textContent = scene.name;
  byId("badge").replaceChildren(badge(scene.status));
  byId("file").textContent = scene.file;
  // Messages that repeat a frame's message come last.
  const ofFrames = new Set(scene.frames.map((frame) => frame.message));
  const texts = [...scene.messages].sort((a, b) => ofFrames.has(a) - ofFrames.has(b));
  const messages = texts.map((text) => element("li", {}, text));
  if (scene.xfail) {
    const word = scene.status === "xpass" ? "it was expected to fail: " : "expected to fail: ";
    messages.unshift(element("li", {class: "xfail"}, word + scene.xfail));
  }
  showMessages(messages);
  showAccept(scene);
}

// ---- measurements below the pictures ----

/// Returns one measurement; `over` is true if it exceeds its bound.
function metric(label, value, over, bound) {
  return element("div", {class: over ? "over" : ""}, element("dt", {}, label),
                 element("dd", {}, value, bound ? element("small", {}, " " + bound) : null));
}

function metricsOf(scene, frame) {
  const m = frame.metrics;
  const beyond = scene.tolerance.maxChannelDiff ? scene.tolerance.maxChannelDiff.value : 0;
  const side = windowSize();
  const exact = noneMayDiffer(frame.asked);
  const near = frame.asked === "near";  // limits as in brokenNearness() in compare.cpp
  const limit = (field) => exact || !scene.tolerance[field] ? null : scene.tolerance[field].value;
  const over = (field, value) => limit(field) !== null && value > limit(field);
  const bound = (field, text) => limit(field) === null ? "" : "≤ " + text(limit(field));
  return [
    metric("worst", `${format(m.worst)} at ${m.worstX}, ${m.worstY}`, over("hardFail", m.worst) || (near && m.worst > 2),
           near ? "≤ 2" : bound("hardFail", format)),
    // For exact pictures and on the machine that drew the baseline, no pixel may differ, so the bounds do not apply.
    metric("differ", plural(m.differentPixels, "pixel"), exact && m.differentPixels > 0,
           exact ? "none may" : near ? "≤ 2 % of them" : ""),
    metric("beyond " + format(beyond), m.pixelsBeyond + " = " + percent(m.ratioBeyond),
           over("maxDiffRatio", m.ratioBeyond) || over("maxDiffPixels", m.pixelsBeyond),
           bound("maxDiffRatio", percent) || bound("maxDiffPixels", format)),
    metric(`densest ${side}×${side}`, percent(m.windowRatio) + ` at ${m.windowX}, ${m.windowY}`,
           over("maxWindowRatio", m.windowRatio), bound("maxWindowRatio", percent)),
    ...[["masked", m.maskedPixels], ["of smoothed edges", m.antialiasedPixels], ["found nearby", m.movedPixels]]
        .filter(([, count]) => count > 0).map(([what, count]) => metric(what, plural(count, "pixel") + " left out")),
    metric("PSNR", m.psnr === null ? "∞" : m.psnr.toFixed(1) + " dB"),
    metric("SSIM", format(m.ssim, 5)),
    metric("FLIP", format(m.flipMean, 3), over("maxFlipMean", m.flipMean) || (near && m.flipMean > 0.002),
           near ? "≤ 0.002" : bound("maxFlipMean", format)),
  ];
}

function showMetrics(scene, frame) {
  const shown = [];
  if (frame && frame.metrics) shown.push(...metricsOf(scene, frame));
  else if (frame && equalPixels(frame)) shown.push(metric("pixels", "equal"));
  if (frame && frame.state) shown.push(metric("state", frame.state, frame.state === "different"));
  byId("metrics").replaceChildren(...shown);
}
