// The card of one element.

function entry(name, ...values) {
  return [node("dt", {}, name), node("dd", {}, ...values)];
}

function cornersTable(mesh, element) {
  return node("table", {}, ...Array.from(cornersOf(mesh, element), (vertex) =>
    node("tr", {}, node("td", {}, `${vertex}:`), ...vertexAt(mesh, vertex).map((x) => node("td", {}, digits(x))))));
}

function faceEntries(mesh, element) {
  const face = mesh.faces[mesh.faceIndex.get(mesh.face[element])];
  if (!face) return entry("Face", String(mesh.face[element]));
  return [
    ...entry("Face", faceTitle(face).slice(5)),
    ...entry("Surface", face.surface || "unknown"),
    ...entry("Chart", face.chart || "none"),
  ];
}

function groupEntries(mesh, element) {
  const face = mesh.face[element];
  const groups = mesh.groups.filter((group) => group.faces.includes(face));
  return groups.length === 0 ? [] : entry("Groups", groups.map((group) => `${group.kind} ${group.name}`).join(", "));
}

/** Where the rule is written, and its text; nothing for what has none. */
function ruleSource(mesh, rule) {
  const source = rule >= 0 ? mesh.rules[rule] : {};
  if (!source.text) return [];
  return [node("p", { class: "muted", id: "rule-place" }, `${source.file}:${source.line}`),
    node("pre", { id: "rule-text", tabindex: "0", "aria-label": "Text of the rule" }, source.text)];
}

function elementNumbers(mesh, element) {
  const [least, most] = anglesOf(mesh, element);
  return node("dl", {},
    ...entry("Element", String(element)),
    ...entry("Corners", cornersTable(mesh, element)),
    ...faceEntries(mesh, element),
    ...groupEntries(mesh, element),
    ...entry("Rule", ruleTitle(mesh, mesh.rule[element])),
    ...entry("Level", digits(mesh.level[element] || NaN)),
    ...entry("Score", mesh.score ? digits(mesh.score[element]) : "none"),
    ...entry("Quality", digits(mesh.quality[element])),
    ...entry("Angles", `${least.toFixed(1)}° to ${most.toFixed(1)}°`));
}

/** The sides of an element as lines. */
function outlineOf(mesh, element) {
  const corners = cornersOf(mesh, element), at = (v) => Array.from(mesh.positions.subarray(3 * v, 3 * v + 3));
  return Array.from(corners).flatMap((corner, i) => {
    const next = corners[(i + 1) % corners.length];
    if (!mesh.middles) return [...at(corner), ...at(next)];
    const middle = mesh.middles[element * mesh.cornersPerElement + i];
    return [...at(corner), ...at(middle), ...at(middle), ...at(next)];
  });
}

/** Zooms to lines with something around them, and turns if they are hidden. */
function zoomToLines(view, ends, margin) {
  const low = [0, 1, 2].map((axis) => Math.min(...ends.filter((_, i) => i % 3 === axis)));
  const high = [0, 1, 2].map((axis) => Math.max(...ends.filter((_, i) => i % 3 === axis)));
  const middle = new THREE.Vector3(...low.map((value, axis) => (value + high[axis]) / 2));
  const size = Math.hypot(...low.map((value, axis) => high[axis] - value));
  const longest = Math.max(...middlesOf(ends).map(({ length }) => length));
  const points = middlesOf(ends).slice(0, 4).map(({ middle: point }) => point);
  const direction = view.isLarge ? undefined : clearestDirection(view, points); // rays take long in large meshes
  view.zoomTo(middle, Math.max(0.65 * size, margin * longest), direction);
}

/** The middles and lengths of lines. */
function middlesOf(ends) {
  return Array.from({ length: ends.length / 6 }, (_, i) => {
    const from = ends.slice(6 * i, 6 * i + 3), to = ends.slice(6 * i + 3, 6 * i + 6);
    return { middle: from.map((x, axis) => (x + to[axis]) / 2), length: Math.hypot(...from.map((x, axis) => to[axis] - x)) };
  });
}

/** Shows an element in the panel and in the picture; -1: none. */
function showElement(mesh, view, element) {
  const card = document.getElementById("element-card"), isNone = element < 0;
  document.getElementById("element-clear").hidden = isNone;
  document.getElementById("element-number").value = isNone ? "" : element;
  const ends = isNone ? [] : outlineOf(mesh, element);
  for (const lines of [view.halo, view.selection]) setMarkerLines(lines, ends); // seen on any colour
  view.draw();
  if (isNone) return card.replaceChildren();
  const zoom = node("button", { type: "button", onclick: () => zoomToLines(view, ends, 4) }, "Zoom to it");
  card.replaceChildren(elementNumbers(mesh, element), zoom, ...ruleSource(mesh, mesh.rule[element]));
}

function connectElementForm(mesh, show) {
  const number = document.getElementById("element-number");
  number.max = mesh.elementCount - 1;
  document.getElementById("element-form").addEventListener("submit", (event) => {
    event.preventDefault();
    if (number.value !== "" && number.validity.valid) show(Number(number.value));
  });
  document.getElementById("element-clear").addEventListener("click", () => show(-1));
}
