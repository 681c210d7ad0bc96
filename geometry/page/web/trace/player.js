// The surface at one time: which elements exist, where vertices are, and where the front runs.

class Surface {
  constructor(run, view) {
    this.run = run;
    this.view = view;
    this.alive = new Uint8Array(run.mesh.elementCount);
    this.at = 0; // events that have happened
    this.sides = new Map(); // by front
    this.copies = new Map(); // by vertex: its other places among the vertices of the picture
    view.copies.forEach((v, i) => this.copies.set(v, [...(this.copies.get(v) ?? []), run.mesh.vertexCount + i]));
    this.front = markerLines(2.5);
    for (const lines of [this.front, ...this.front.children]) lines.renderOrder = 1; // below the base edge
    this.before = markerLines(3);
    this.after = markerLines(4);
    for (const lines of [this.front, this.before, this.after]) view.scene.add(lines);
    view.outlines.visible = false;
    view.edges.visible = true;
    view.setColors({ isNumeric: false, categories: this.categories(), of: (e) => this.categoryOf(e) });
  }

  categories() {
    return [...this.run.rules.map((_, i) => ({ color: categoryColor(i) })), { color: colorOfNone }];
  }

  /** The rule that made an element; the last category for changes and triangles without a rule. */
  categoryOf(element) {
    const rule = this.run.rule[this.run.birth[element]];
    return rule < 0 ? this.run.rules.length : rule;
  }

  useScheme() {
    const style = getComputedStyle(document.documentElement), color = (name) => style.getPropertyValue(name).trim();
    setMarkerColor(this.front, color("--accent"));
    setMarkerColor(this.before, color("--bad"));
    setMarkerColor(this.after, color("--made-edge"));
  }

  /** Shows the time after an event. */
  show(event) {
    while (this.at <= event) this.step(this.at++, 1);
    while (this.at > event + 1) this.step(--this.at, 0);
    this.view.faces.geometry.attributes.position.needsUpdate = true;
    this.view.setVisible(this.alive);
    this.showFront(event);
    this.showEvent(event);
  }

  /** Lets an event happen, or takes it back. */
  step(event, isForward) {
    const { run } = this;
    for (const e of bornAt(run, event)) this.alive[e] = isForward;
    for (const e of diedAt(run, event)) this.alive[e] = 1 - isForward;
    if (run.move[event] >= 0) this.swapPlaces(run.from[event], run.move[event]);
  }

  /** The places before and after a move change roles, so that it can be taken back. */
  swapPlaces(vertex, move) {
    const { mesh, moves } = this.run, shown = this.view.faces.geometry.attributes.position.array;
    for (let axis = 0; axis < 3; ++axis) {
      const to = moves[3 * move + axis];
      moves[3 * move + axis] = mesh.positions[3 * vertex + axis];
      for (const v of [vertex, ...(this.copies.get(vertex) ?? [])]) shown[3 * v + axis] = to;
      mesh.positions[3 * vertex + axis] = to;
    }
  }

  /** The sides between the elements that the steps of a front made. */
  sidesOfFront(front) {
    const { run } = this;
    if (this.sides.has(front)) return this.sides.get(front);
    const elements = [];
    for (let e = 0; e < run.birth.length; ++e)
      if (run.front[run.birth[e]] === front && isStep(run, run.birth[e])) elements.push(e);
    const corners = new Uint32Array(elements.flatMap((e) => Array.from(run.mesh.corners.subarray(4 * e, 4 * e + 4))));
    const sides = sidesOf({ ...run.mesh, corners, elementCount: elements.length });
    const result = { sides, elements };
    this.sides.set(front, result);
    return result;
  }

  /** Sides with an element on one side only, and the boundary where there is none yet. */
  showFront(event) {
    const { run } = this, number = run.front[event], front = run.fronts[number];
    if (!isStep(run, event)) return setMarkerLines(this.front, []);
    const { sides, elements } = this.sidesOfFront(number), ends = [];
    const isGiven = (v) => v - front.firstVertex < front.given;
    for (let s = 0; s < sides.count; ++s) {
      const first = this.alive[elements[sides.first[s]]] === 1;
      const isRim = sides.second[s] < 0 && isGiven(sides.from[s]) && isGiven(sides.to[s]);
      const second = sides.second[s] >= 0 && this.alive[elements[sides.second[s]]] === 1;
      if (isRim ? first : first === second) continue;
      ends.push(...this.placeOf(sides.from[s]), ...this.placeOf(sides.to[s]));
    }
    setMarkerLines(this.front, ends);
  }

  placeOf(v) {
    return Array.from(this.run.mesh.positions.subarray(3 * v, 3 * v + 3));
  }

  /** The elements around a vertex that exist now. */
  star(vertex) {
    const found = [], { mesh } = this.run;
    for (let e = 0; e < mesh.elementCount; ++e)
      if (this.alive[e] && cornersOf(mesh, e).includes(vertex)) found.push(e);
    return found;
  }

  outlines(elements) {
    return elements.flatMap((e) => outlineOf(this.run.mesh, e));
  }

  /** The base edge and new elements of a step, or the elements before and after a change. */
  showEvent(event) {
    const { run, view } = this;
    const isMove = run.move[event] >= 0;
    const changed = isMove ? this.star(run.from[event]) : bornAt(run, event);
    let before = isStep(run, event) ? [] : this.outlines(diedAt(run, event));
    if (isMove) {
      this.swapPlaces(run.from[event], run.move[event]);
      before = this.outlines(changed);
      this.swapPlaces(run.from[event], run.move[event]);
    }
    setMarkerLines(this.before, before);
    setMarkerLines(this.after, this.outlines(changed));
    setMarkerLines(view.stuck, isStep(run, event) ? [...this.placeOf(run.from[event]), ...this.placeOf(run.to[event])] : []);
    this.ends = isStep(run, event) ? [...this.placeOf(run.from[event]), ...this.placeOf(run.to[event])] : [...before, ...this.outlines(changed)];
    view.draw();
  }

  zoom() {
    if (this.ends.length > 0) zoomToLines(this.view, this.ends, 6);
  }

  /** As `zoom`, without turning. */
  follow() {
    if (this.ends.length === 0) return;
    const lines = middlesOf(this.ends), { middle, length } = lines[0];
    this.view.zoomTo(new THREE.Vector3(...middle), Math.max(6 * length, 1e-9));
  }
}
