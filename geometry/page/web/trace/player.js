// The surface at one time: which elements exist, where vertices are, and where the front runs.

class Surface {
  constructor(run, view) {
    this.run = run;
    this.view = view;
    this.alive = new Uint8Array(run.mesh.elementCount);
    this.at = 0; // events that have happened
    this.parts = new Map(); // by front
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
    this.swapAll(event);
  }

  /** All moves of an event, forward or back. */
  swapAll(event) {
    const { run } = this;
    for (let i = 0; i < run.moveCount[event]; ++i) this.swapPlaces(run.firstMove[event] + i);
  }

  /** The places before and after a move change roles, so that it can be taken back. */
  swapPlaces(move) {
    const { mesh, moves, moved } = this.run, shown = this.view.faces.geometry.attributes.position.array;
    const vertex = moved[move];
    for (let axis = 0; axis < 3; ++axis) {
      const to = moves[3 * move + axis];
      moves[3 * move + axis] = mesh.positions[3 * vertex + axis];
      for (const v of [vertex, ...(this.copies.get(vertex) ?? [])]) shown[3 * v + axis] = to;
      mesh.positions[3 * vertex + axis] = to;
    }
  }

  /**
   * The elements that the steps of a front made, and its rim: the sides between given vertices that have elements on
   * one side only, at any time.
   */
  partsOfFront(front) {
    const { run } = this;
    if (this.parts.has(front)) return this.parts.get(front);
    const elements = [], sides = new Map(), { given, firstVertex } = run.fronts[front];
    const isGiven = (v) => v - firstVertex < given;
    for (let e = 0; e < run.birth.length; ++e) {
      if (run.front[run.birth[e]] !== front || !isStep(run, run.birth[e])) continue;
      elements.push(e);
      for (const [from, to] of this.sidesOfElement(e))
        if (isGiven(from) && isGiven(to)) sides.set(this.sideKey(from, to), [from, to]);
    }
    const rim = [...sides.values()].filter(([from, to]) => !sides.has(this.sideKey(to, from)));
    const result = { elements, rim };
    this.parts.set(front, result);
    return result;
  }

  sidesOfElement(element) {
    const corners = Array.from(cornersOf(this.run.mesh, element));
    return corners.map((v, i) => [v, corners[(i + 1) % corners.length]]);
  }

  sideKey(from, to) {
    return from * this.run.mesh.vertexCount + to;
  }

  /** Sides with an element on one side only, and the rim where there is none yet. */
  showFront(event) {
    const { run } = this;
    if (!isOfFront(run, event)) return setMarkerLines(this.front, []);
    const { elements, rim } = this.partsOfFront(run.front[event]), open = new Map();
    for (const e of elements) {
      if (!this.alive[e]) continue;
      for (const [from, to] of this.sidesOfElement(e))
        if (!open.delete(this.sideKey(to, from))) open.set(this.sideKey(from, to), [from, to]);
    }
    for (const side of rim)
      if (!open.delete(this.sideKey(...side))) open.set(this.sideKey(...side), side);
    setMarkerLines(this.front, [...open.values()].flatMap(([from, to]) => [...this.placeOf(from), ...this.placeOf(to)]));
    return undefined;
  }

  placeOf(v) {
    return Array.from(this.run.mesh.positions.subarray(3 * v, 3 * v + 3));
  }

  /** The elements that exist now around the vertices that an event moves. */
  aroundMoved(event) {
    const found = [], { mesh, moved, firstMove, moveCount } = this.run;
    const vertices = new Set(moved.subarray(firstMove[event], firstMove[event] + moveCount[event]));
    for (let e = 0; e < mesh.elementCount; ++e)
      if (this.alive[e] && cornersOf(mesh, e).some((v) => vertices.has(v))) found.push(e);
    return found;
  }

  outlines(elements) {
    return elements.flatMap((e) => outlineOf(this.run.mesh, e));
  }

  /** The base edge and new elements of a step, or the elements before and after a change. */
  showEvent(event) {
    const { run, view } = this;
    const isMove = !isStep(run, event) && run.moveCount[event] > 0;
    const changed = isMove ? this.aroundMoved(event) : bornAt(run, event);
    let before = isStep(run, event) ? [] : this.outlines(diedAt(run, event));
    if (isMove) {
      this.swapAll(event);
      before = this.outlines(changed);
      this.swapAll(event);
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
