// Joins the parts of the page.

const mostElementsWithEdges = 300000; // more of them would be black, and slow without a graphics card

function showTitle(mesh) {
  const quads = mesh.cornersPerElement === 4
    ? Array.from({ length: mesh.elementCount }, (_, e) => cornerCount(mesh, e)).filter((n) => n === 4).length : 0;
  const kinds = [
    mesh.elementCount > quads || quads === 0 ? counted(mesh.elementCount - quads, "triangle") : "",
    quads > 0 ? counted(quads, "quadrilateral") : "",
  ].filter(Boolean).join(", ");
  document.title = `${mesh.title} – AF2`;
  document.getElementById("title").textContent = mesh.title;
  document.getElementById("summary").textContent =
    `${kinds}, ${counted(mesh.vertexCount, "vertex", "vertices")}, ${counted(mesh.faces.length, "face")}` +
    (mesh.middles ? ", second order" : "") + (mesh.unit ? `; lengths in ${mesh.unit}` : "");
}

function showNotes(mesh) {
  const notes = [...mesh.findings, ...mesh.notes];
  document.getElementById("notes").hidden = notes.length === 0;
  document.getElementById("notes-list").replaceChildren(...notes.map((note) => node("li", {}, note)));
}

function connectSection(mesh, view) {
  const slider = document.getElementById("cut"), flip = document.getElementById("flip");
  const update = () => {
    const axis = ["x", "y", "z"].indexOf(document.querySelector("input[name=axis]:checked").value);
    slider.disabled = flip.disabled = axis < 0;
    const at = axis < 0 ? 0 : view.low[axis] + slider.value / slider.max * (view.high[axis] - view.low[axis]);
    document.getElementById("cut-at").textContent = axis < 0 ? "–" : digits(mesh.centre[axis] + at);
    view.setCut(axis, at, flip.checked);
  };
  for (const input of [slider, flip, ...document.querySelectorAll("input[name=axis]")])
    input.addEventListener("input", update);
}

function connectEdges(mesh, view) {
  const edges = document.getElementById("edges"), outlines = document.getElementById("model-edges");
  edges.checked = view.edges.visible = mesh.elementCount <= mostElementsWithEdges;
  edges.addEventListener("change", () => view.showEdges(edges.checked));
  outlines.addEventListener("change", () => {
    view.outlines.visible = outlines.checked;
    view.draw();
  });
}

/** Marks by element whether it is shown. */
function visibleElements(mesh, hidden, histogram) {
  const isVisible = new Uint8Array(mesh.elementCount).fill(1);
  const hiddenFaces = new Set(mesh.faces.filter((_, i) => hidden.faces[i]).map((face) => face.id));
  for (let e = 0; e < mesh.elementCount; ++e)
    if (hiddenFaces.has(mesh.face[e]) || hidden.rules.has(mesh.rule[e])) isVisible[e] = 0;
  histogram.hideOutside(isVisible);
  return isVisible;
}

class Page {
  constructor(mesh, view) {
    this.mesh = mesh;
    this.view = view;
    this.quantities = quantitiesOf(mesh);
    this.hidden = new Hidden(mesh, () => this.showVisible());
    this.histogram = new Histogram(this.quantities, () => this.showVisible());
    this.connectColors();
    this.connectFaces();
    onElementClick(view, (element) => showElement(mesh, view, element));
    connectElementForm(mesh, (element) => showElement(mesh, view, element));
    this.colorBy("quality");
  }

  connectColors() {
    const select = document.getElementById("color-by");
    for (const quantity of this.quantities.values())
      select.append(node("option", { value: quantity.key }, quantity.label));
    select.addEventListener("change", () => this.colorBy(select.value));
    document.getElementById("stretch").addEventListener("change", () => this.stretchColors());
  }

  connectFaces() {
    const all = this.mesh.faces.map((_, index) => index);
    document.getElementById("faces-all").addEventListener("click", () => this.hidden.setFaces(all, false));
    document.getElementById("faces-none").addEventListener("click", () => this.hidden.setFaces(all, true));
    document.getElementById("face-search").addEventListener("input", () => this.showLists());
  }

  /** Lets the colours of all quantities end at the values that the mesh has, or at their usual ends. */
  stretchColors() {
    const isOn = document.getElementById("stretch").checked;
    for (const quantity of this.quantities.values()) quantity.ends = isOn ? quantity.range : quantity.usualEnds;
    this.histogram.draw();
    this.colorBy(this.color.key);
  }

  /** Numbers also go into the histogram. */
  colorBy(key) {
    this.color = this.quantities.get(key);
    this.view.setColors(this.color);
    if (this.color.isNumeric && this.histogram.quantity !== this.color) this.histogram.show(key);
    else this.showLists();
  }

  showLists() {
    showLegend(this.color, this.hidden);
    showGroups([...this.quantities.values()].filter((q) => q.categories?.[0]?.faces && q.key !== "face"), this.hidden);
    showFaces(this.quantities.get("face"), this.hidden, document.getElementById("face-search").value);
  }

  showVisible() {
    const isVisible = visibleElements(this.mesh, this.hidden, this.histogram);
    this.view.setVisible(isVisible);
    const count = isVisible.reduce((sum, one) => sum + one, 0);
    document.getElementById("shown").textContent =
      `${count.toLocaleString("en")} of ${counted(this.mesh.elementCount, "element")} shown`;
    this.showLists();
  }
}

function start() {
  const began = performance.now();
  const mesh = readMesh();
  const view = new View(mesh, document.getElementById("canvas"));
  showTitle(mesh);
  showNotes(mesh);
  connectScheme(view);
  connectViews(view);
  connectSection(mesh, view);
  connectEdges(mesh, view);
  const page = new Page(mesh, view);
  showFailures(mesh, view);
  if (view.isPlanar) view.look(new THREE.Vector3(0, 0, 1));
  view.drawNow();
  document.getElementById("loading").hidden = true;
  return { mesh, view, page, startMilliseconds: performance.now() - began };
}

/** The parts of the running page, for tests and for the console of the browser. */
let af2 = null;

// A little later, so that the word "Loading" is seen meanwhile. A page that is printed or captured
// without a window has no frames to wait for.
const loadingMilliseconds = 30;
setTimeout(() => {
  try {
    af2 = start();
  } catch (error) {
    document.getElementById("loading").textContent = `The mesh cannot be shown: ${error.message}`;
    throw error;
  }
}, loadingMilliseconds);
