// The table of a step: what came of each rule and why, in the words of `af2 explain`.

function shortDigits(value) {
  return value === null ? "infinite" : String(Number(value.toPrecision(4)));
}

/** How far a point lies from an outline of pairs. */
function depthIn(zones, [x, y]) {
  let depth = Infinity;
  for (const zone of zones.map(pointsOf))
    zone.forEach(([x1, y1], i) => {
      const [x2, y2] = zone[(i + 1) % zone.length], dx = x2 - x1, dy = y2 - y1;
      const t = Math.min(1, Math.max(0, ((x - x1) * dx + (y - y1) * dy) / (dx * dx + dy * dy || 1)));
      depth = Math.min(depth, Math.hypot(x - x1 - t * dx, y - y1 - t * dy));
    });
  return depth;
}

function vertexText(chart, names, v) {
  const [, x, y] = chart.v[v];
  return `${names[v]} at (${Number(x.toPrecision(3))}, ${Number(y.toPrecision(3))})`;
}

function hitText(chart, names, candidate) {
  const { hit, zones } = candidate;
  if (hit.length === 2) return `edge ${names[hit[0]]} -> ${vertexText(chart, names, hit[1])} crosses the zone`;
  if (hit.length === 0) return "what hit the zone is beyond the chart";
  const depth = depthIn(zones, chart.v[hit[0]].slice(1));
  return `vertex ${vertexText(chart, names, hit[0])} lies in the zone` +
    (Number.isFinite(depth) ? `, ${Number(depth.toPrecision(3))} from its outline` : "");
}

function patternText(rule, candidate) {
  if (!candidate.cause) return candidate.matched.length ? "" : "the front has fewer vertices here than the pattern";
  const [index, isEdge, value, limit] = candidate.cause;
  const part = isEdge ? `the slope of ${rule.edges[index].map((v) => rule.vertices[v]).join(" -> ")}` : `vertex ${rule.vertices[index]}`;
  return `${part} deviates by ${shortDigits(value)} from its reference; at most ${shortDigits(limit)} is allowed`;
}

function whyText(run, chart, names, candidate, level) {
  const rule = run.rules[candidate.rule], number = candidate.cause ? candidate.cause[0] + 1 : 0;
  const score = candidate.score === null ? "" : `score ${shortDigits(candidate.score)}`;
  switch (run.reasons[candidate.reason]) {
    case "pattern": return patternText(rule, candidate);
    case "require": return number ? `condition ${number} does not hold` : "";
    case "no value": return number ? `condition ${number} has no value` : "";
    case "zone hit by vertex":
    case "zone hit by edge": return hitText(chart, names, candidate);
    case "inverted": return number ? `element ${number} does not turn left at each corner` : "";
    case "score": return `the rule set does not accept a ${score || "score"} at level ${level}`;
    default: return score;
  }
}

/** Calls `choose` with a candidate when its row is clicked. */
function showReasons(run, event, chart, candidates, selected, choose) {
  const box = document.getElementById("reasons");
  if (!chart) return box.replaceChildren(node("p", { class: "muted" }, missingText(run, event)));
  const names = vertexNames(chart);
  const rows = candidates.map((candidate) => {
    const name = node("button", { type: "button", onclick: () => choose(candidate) }, run.rules[candidate.rule].name);
    const swatch = node("span", { class: "swatch", style: `background: ${css(categoryColor(candidate.rule))}` });
    return node("tr", {
      class: candidate.reason === 0 ? "applied" : "", "aria-selected": String(candidate === selected),
      "data-rule": String(candidate.rule),
    }, node("td", {}, swatch, " ", name), node("td", {}, String(candidate.matches)),
    node("td", {}, candidate.reason === 0 ? "applied" : run.reasons[candidate.reason]),
    node("td", {}, whyText(run, chart, names, candidate, run.level[event])));
  });
  const head = node("tr", {}, ...["rule", "matches", "result", "why"].map((text) => node("th", { scope: "col" }, text)));
  const later = run.rules.length - candidates.length;
  const note = later > 0 ? node("p", { class: "muted" }, `${later} of ${run.rules.length} rules are not tried at level ${run.level[event]}.`) : null;
  box.replaceChildren(node("table", {}, node("thead", {}, head), node("tbody", {}, ...rows)), ...[note].filter(Boolean));
}

function missingText(run, event) {
  if (run.kind[event] === eventKinds.closed)
    return "The rest of the stuck front was closed with triangles, without rules.";
  if (run.kind[event] === eventKinds.turned)
    return "Elements with a reflex corner, which the last level of the rule set accepts, were turned round: red lines show the elements before it, green lines those after it.";
  if (run.kind[event] === eventKinds.row)
    return "A row is complete: the front and the elements behind it are smoothed. Red lines show them before, green lines after it.";
  if (!isStep(run, event))
    return "A change after the front: red lines show the elements before it, green lines those after it.";
  return "The page has no chart of this step. Write the page again with --face, --from and --to around it.";
}

/** The rule that came farthest; of several, the first. */
function farthest(candidates) {
  return candidates.reduce((best, c) => (best === undefined || c.reason > best.reason ? c : best), undefined);
}
