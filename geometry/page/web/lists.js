// Lists in the panel: what can be shown and hidden, by rule, face and group; and the legend of the colours.

const mostRows = 300;

function node(tag, attributes = {}, ...children) {
  const result = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) result.addEventListener(name.slice(2), value);
    else if (value === true || value === false) result[name] = value;
    else if (value !== undefined) result.setAttribute(name, value);
  }
  result.append(...children.filter((child) => child !== null && child !== undefined));
  return result;
}

function swatch(color) {
  return node("span", { class: "swatch", style: `background: ${css(color)}` });
}

/** A row with a box to show or hide something, and a button to show it alone. */
function checkRow({ name, count, color, isShown, isMixed, set, only }) {
  const box = node("input", { type: "checkbox", checked: isShown, onchange: (event) => set(event.target.checked) });
  box.indeterminate = isMixed ?? false;
  return node("li", {},
    node("label", {}, box, color ? swatch(color) : null, node("span", { class: "name", title: name }, name)),
    node("span", { class: "count" }, count.toLocaleString("en")),
    node("button", { type: "button", onclick: only, "aria-label": `Show only ${name}` }, "only"));
}

/** Rows that are there already keep their focus and the place to which the list is scrolled. */
function fillChecks(list, rows) {
  const shown = rows.slice(0, mostRows), more = rows.length - shown.length;
  const names = shown.map((row) => row.name).join("\n");
  if (list.names === names) return updateChecks(list, shown);
  list.names = names;
  list.replaceChildren(...shown.map(checkRow),
    ...(more > 0 ? [node("li", { class: "muted" }, `and ${counted(more, "more", "more")}: search for them`)] : []));
}

function updateChecks(list, rows) {
  list.querySelectorAll("input").forEach((box, i) => {
    box.checked = rows[i].isShown;
    box.indeterminate = rows[i].isMixed ?? false;
  });
}

/** The list of a quantity in `place`, made if it is not there. */
function listIn(place, quantity) {
  const id = `list-${place.id}-${quantity.key}`;
  return document.getElementById(id) ?? node("ul", { id, class: "checks", "aria-label": quantity.label });
}

/** The faces and rules that are hidden. */
class Hidden {
  constructor(mesh, changed) {
    this.mesh = mesh;
    this.faces = new Uint8Array(mesh.faces.length);
    this.rules = new Set();
    this.changed = changed;
  }

  setFaces(faces, isHidden) {
    for (const face of faces) this.faces[face] = isHidden ? 1 : 0;
    this.changed();
  }

  onlyFaces(faces) {
    this.faces.fill(1);
    this.setFaces(faces, false);
  }

  setRule(rule, isHidden) {
    if (isHidden) this.rules.add(rule);
    else this.rules.delete(rule);
    this.changed();
  }

  onlyRule(rule, all) {
    this.rules = new Set(all.filter((other) => other !== rule));
    this.changed();
  }

  rowOfFaces(category, color) {
    const hidden = category.faces.filter((face) => this.faces[face]).length;
    return {
      name: category.name, count: category.count, color,
      isShown: hidden < category.faces.length, isMixed: hidden > 0 && hidden < category.faces.length,
      set: (isShown) => this.setFaces(category.faces, !isShown), only: () => this.onlyFaces(category.faces),
    };
  }

  rowOfRule(category, all) {
    return {
      name: category.name, count: category.count, color: category.color, isShown: !this.rules.has(category.id),
      set: (isShown) => this.setRule(category.id, !isShown), only: () => this.onlyRule(category.id, all),
    };
  }
}

function showScale(quantity, place) {
  const stops = Array.from({ length: 9 }, (_, i) => css(scaleColor(i / 8)));
  place.replaceChildren(
    node("div", { class: "scale", style: `background: linear-gradient(90deg, ${stops.join(", ")})` }),
    node("div", { class: "scale-ends" },
      node("span", {}, `${digits(quantity.ends[0])} (poor)`), node("span", {}, `${digits(quantity.ends[1])} (good)`)),
    node("p", { class: "muted" }, swatch(colorOfNone), " none"));
}

/** The meaning of the colours: a scale, or a list of the categories. */
function showLegend(quantity, hidden) {
  const place = document.getElementById("legend");
  if (quantity.isNumeric) return showScale(quantity, place);
  const all = quantity.categories.map((category) => category.id);
  const rows = quantity.categories.map((category) =>
    (category.faces ? hidden.rowOfFaces(category, category.color) : hidden.rowOfRule(category, all)));
  const list = listIn(place, quantity);
  fillChecks(list, rows);
  if (!list.parentNode) place.replaceChildren(list);
}

function showFaces(faces, hidden, search) {
  const words = search.toLowerCase();
  const rows = faces.categories.filter((category) => {
    const face = hidden.mesh.faces[category.faces[0]];
    return `${category.name} ${face.surface} ${face.status}`.toLowerCase().includes(words);
  });
  fillChecks(document.getElementById("faces"), rows.map((category) => hidden.rowOfFaces(category)));
}

function showGroups(groups, hidden) {
  const place = document.getElementById("groups");
  for (const quantity of groups) {
    const list = listIn(place, quantity);
    fillChecks(list, quantity.categories.map((category) =>
      hidden.rowOfFaces(category, quantity.key === "color" ? category.color : undefined)));
    if (!list.parentNode) place.append(node("p", { class: "kind" }, quantity.label), list);
  }
}
