// What elements can be coloured and filtered by.

const scaleStops = [[165, 0, 38], [244, 109, 67], [254, 224, 144], [160, 205, 226], [78, 131, 189]];
const colorOfNone = [150, 158, 166];
const firstColors = [
  [78, 121, 167], [242, 142, 43], [89, 161, 79], [225, 87, 89], [118, 183, 178], [237, 201, 72],
  [176, 122, 161], [255, 157, 167], [156, 117, 95], [140, 209, 125], [160, 203, 232], [212, 166, 200],
];

/** From 0, bad, to 1, good. */
function scaleColor(t) {
  const at = Math.min(Math.max(t, 0), 1) * (scaleStops.length - 1);
  const low = Math.min(Math.floor(at), scaleStops.length - 2), part = at - low;
  return scaleStops[low].map((c, i) => c + part * (scaleStops[low + 1][i] - c));
}

/** Colours that differ for neighbouring numbers: a list, and then steps of the golden angle around the hues. */
function categoryColor(index) {
  if (index < firstColors.length) return firstColors[index];
  const hue = index * 137.508 % 360, light = 0.5 + 0.12 * (index % 3);
  const channel = (n) => {
    const k = (n + hue / 30) % 12;
    return 255 * (light - 0.45 * Math.min(light, 1 - light) * Math.max(-1, Math.min(k - 3, 9 - k, 1)));
  };
  return [channel(0), channel(8), channel(4)];
}

function css(color) {
  return `rgb(${color.map(Math.round).join(" ")})`;
}

/** The smallest and the largest finite number; [0, 1] if there is none. Inverted elements have an infinite score. */
function extent(values) {
  let low = Infinity, high = -Infinity;
  for (const value of values) {
    if (!Number.isFinite(value)) continue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return low <= high ? [low, high] : [0, 1];
}

/**
 * A number by element. `ends` are those of the colours: the bad one and the good one. Values beyond them have the
 * colours of the ends.
 */
function numericQuantity(key, label, values, ends, isInteger = false) {
  const [low, high] = extent(values);
  const range = ends[0] < ends[1] ? [low, high] : [high, low];
  return { key, label, isNumeric: true, isInteger, values, low, high, ends, range, usualEnds: ends };
}

function colorOfValue(quantity, value) {
  if (Number.isNaN(value)) return colorOfNone;
  const [bad, good] = quantity.ends;
  return scaleColor(good === bad ? 1 : (value - bad) / (good - bad));
}

/** One of the categories of a list by element; `of` gives its index there, or -1. */
function categoricalQuantity(key, label, categories, of) {
  return { key, label, isNumeric: false, categories, of };
}

/** Scores have no upper end: the colours end where only one element in a hundred is worse. */
function scoreEnd(scores) {
  const step = Math.max(1, Math.floor(scores.length / 20000)); // a sample is enough for colours
  const sample = scores.filter((s, i) => i % step === 0 && Number.isFinite(s)).sort();
  return sample.length ? Math.max(sample[Math.floor(0.99 * (sample.length - 1))], 1e-6) : 1;
}

function levels(mesh) {
  const values = new Float32Array(mesh.level.length);
  for (let e = 0; e < values.length; ++e) values[e] = mesh.level[e] === 0 ? NaN : mesh.level[e];
  const high = extent(values)[1];
  return numericQuantity("level", "Level of the rule", values, [Math.max(high, 2), 1], true);
}

function angleQuantities(mesh) {
  const least = new Float32Array(mesh.elementCount), most = new Float32Array(mesh.elementCount);
  for (let e = 0; e < mesh.elementCount; ++e) [least[e], most[e]] = anglesOf(mesh, e);
  const ideal = mesh.cornersPerElement === 4 ? 90 : 60;
  return {
    least: numericQuantity("least-angle", "Smallest angle (degrees)", least, [0, ideal]),
    most: numericQuantity("most-angle", "Largest angle (degrees)", most, [180, ideal]),
  };
}

const changedByOptimization = "changed by optimization";

function ruleTitle(mesh, rule) {
  return rule < 0 ? changedByOptimization : mesh.rules[rule].name;
}

/** The rules that made elements, the most frequent one first. */
function ruleQuantity(mesh) {
  const counts = new Map();
  for (const rule of mesh.rule) counts.set(rule, (counts.get(rule) ?? 0) + 1);
  const used = [...counts.keys()].filter((rule) => rule >= 0);
  used.sort((a, b) => counts.get(b) - counts.get(a) || a - b);
  const categories = used.map((rule, i) =>
    ({ id: rule, name: ruleTitle(mesh, rule), count: counts.get(rule), color: categoryColor(i) }));
  if (counts.has(-1))
    categories.push({ id: -1, name: changedByOptimization, count: counts.get(-1), color: colorOfNone });
  const place = new Map(categories.map((category, i) => [category.id, i]));
  return categoricalQuantity("rule", "Rule", categories, (e) => place.get(mesh.rule[e]));
}

function faceTitle(face) {
  return `Face ${face.id}` + (face.name ? ` “${face.name}”` : "");
}

function faceQuantity(mesh) {
  const categories = mesh.faces.map((face, i) =>
    ({ id: face.id, name: faceTitle(face), count: face.elements, color: categoryColor(i), faces: [i] }));
  return categoricalQuantity("face", "Face", categories, (e) => mesh.faceIndex.get(mesh.face[e]) ?? -1);
}

function groupColor(group, index) {
  const rgb = /^#([0-9a-f]{2})([0-9a-f]{2})([0-9a-f]{2})$/i.exec(group.name);
  return group.kind === "color" && rgb ? rgb.slice(1).map((hex) => parseInt(hex, 16)) : categoryColor(index);
}

/** The groups of a kind; a face in several of them has the colour of the first. */
function groupQuantity(mesh, kind) {
  const first = new Int32Array(mesh.faces.length).fill(-1);
  const groups = mesh.groups.filter((group) => group.kind === kind);
  const categories = groups.map((group, i) => {
    const faces = group.faces.map((id) => mesh.faceIndex.get(id)).filter((face) => face !== undefined);
    for (const face of faces) if (first[face] < 0) first[face] = i;
    const count = faces.reduce((sum, face) => sum + mesh.faces[face].elements, 0);
    return { id: i, name: group.name, count, color: groupColor(group, i), faces };
  });
  const label = { part: "Part", solid: "Solid", layer: "Layer", color: "Colour of the model" }[kind] ?? kind;
  return categoricalQuantity(kind, label, categories, (e) => first[mesh.faceIndex.get(mesh.face[e])] ?? -1);
}

/** All quantities that the mesh has, by key and in the order of the lists. */
function quantitiesOf(mesh) {
  const angles = angleQuantities(mesh);
  const all = [numericQuantity("quality", "Quality", mesh.quality, [0, 1])];
  if (mesh.score) all.push(numericQuantity("score", "Score by the rules", mesh.score, [scoreEnd(mesh.score), 0]));
  all.push(angles.least, angles.most, levels(mesh), ruleQuantity(mesh), faceQuantity(mesh));
  for (const kind of new Set(mesh.groups.map((group) => group.kind))) all.push(groupQuantity(mesh, kind));
  return new Map(all.map((quantity) => [quantity.key, quantity]));
}

/** The colour of an element. */
function elementColor(quantity, element) {
  if (quantity.isNumeric) return colorOfValue(quantity, quantity.values[element]);
  const category = quantity.of(element);
  return category < 0 ? colorOfNone : quantity.categories[category].color;
}
