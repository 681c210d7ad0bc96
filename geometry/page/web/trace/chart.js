// The chart of a step as SVG: the front around the base edge, in the frame of the base edge.

const svgSpace = "http://www.w3.org/2000/svg";

function svgNode(tag, attributes, text) {
  const result = document.createElementNS(svgSpace, tag);
  for (const [name, value] of Object.entries(attributes)) result.setAttribute(name, value);
  if (text !== undefined) result.textContent = text;
  return result;
}

/** Pairs of the numbers of an outline. */
function pointsOf(outline) {
  return Array.from({ length: outline.length / 2 }, (_, i) => [outline[2 * i], outline[2 * i + 1]]);
}

/** Maps the frame of the base edge to pixels: what is near the base edge and what the rule uses is visible. */
function frameOf(svg, chart, candidate) {
  const near = 2.5;
  const points = [[-0.6, -0.5], [1.6, 1.2], ...chart.v.map(([, x, y]) => [x, y])
    .filter(([x, y]) => Math.hypot(x - 0.5, y) < near)];
  if (candidate) {
    points.push(...candidate.matched.map((v) => chart.v[v].slice(1)), ...candidate.hit.map((v) => chart.v[v].slice(1)));
    points.push(...candidate.zones.flatMap(pointsOf));
  }
  const xs = points.map(([x]) => x), ys = points.map(([, y]) => y);
  const low = [Math.min(...xs), Math.min(...ys)], high = [Math.max(...xs), Math.max(...ys)];
  const width = svg.clientWidth || 500, height = svg.clientHeight || 300, margin = 42;
  const scale = Math.min((width - 2 * margin) / (high[0] - low[0]), (height - 2 * margin) / (high[1] - low[1]));
  svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
  return ([x, y]) => [width / 2 + scale * (x - (low[0] + high[0]) / 2), height / 2 - scale * (y - (low[1] + high[1]) / 2)];
}


class Chart {
  constructor(svg, run) {
    this.svg = svg;
    this.run = run;
    new ResizeObserver(() => this.chart && this.show(this.chart, this.candidates, this.selected)).observe(svg);
  }

  clear() {
    this.chart = null;
    this.svg.replaceChildren();
    document.getElementById("chart-key").replaceChildren();
  }

  /** candidates: of the chart; selected: one of them, or undefined */
  show(chart, candidates, selected) {
    Object.assign(this, { chart, candidates, selected, names: vertexNames(chart) });
    this.at = frameOf(this.svg, chart, selected);
    this.svg.replaceChildren();
    for (const other of candidates) if (other !== selected) this.drawZones(other, "other-zone");
    if (selected) this.drawZones(selected, "zone");
    if (selected) this.drawMade(selected);
    this.drawFront(selected);
    this.drawVertices(selected);
    this.drawKey(selected);
  }

  add(tag, attributes, text) {
    this.svg.append(svgNode(tag, attributes, text));
  }

  place(v) {
    return this.at(this.chart.v[v].slice(1));
  }

  drawZones(candidate, kind) {
    for (const zone of candidate.zones)
      this.add("polygon", { class: kind, points: pointsOf(zone).map((p) => this.at(p).join(",")).join(" ") });
  }

  /** The elements that the rule makes or would make; none if a new vertex has no place. */
  drawMade(candidate) {
    const rule = this.run.rules[candidate.rule], matched = rule.vertices.length;
    if (candidate.matched.length < matched || candidate.made.length < rule.new.length) return;
    if (candidate.made.includes(null)) return;
    const at = (v) => (v < matched ? this.place(candidate.matched[v]) : this.at(candidate.made[v - matched]));
    for (const element of rule.elements)
      this.add("polygon", { class: "made", points: element.map((v) => at(v).join(",")).join(" ") });
    candidate.made.forEach((point, i) => {
      const [x, y] = this.at(point);
      this.add("circle", { class: "new", cx: x, cy: y, r: 4.5, "stroke-width": 2 });
      this.add("text", { x, y: y - 13 }, rule.new[i]);
    });
  }

  kindOf(from, to, candidate) {
    const { chart } = this;
    if (candidate?.hit.length === 2 && candidate.hit[0] === from && candidate.hit[1] === to) return "hit";
    if (chart.b[0] === from && chart.b[1] === to) return "base";
    const edges = candidate ? this.run.rules[candidate.rule].edges : [];
    const isPattern = edges.some(([f, t]) => candidate.matched[f] === from && candidate.matched[t] === to);
    return isPattern ? "pattern" : "front";
  }

  drawFront(candidate) {
    for (const chain of this.chart.c)
      for (let i = 0; i + 1 < chain.length; ++i)
        this.drawEdge(chain[i], chain[i + 1], this.kindOf(chain[i], chain[i + 1], candidate));
  }

  /** With an arrow in the middle: the region still to be meshed lies to the left. */
  drawEdge(from, to, kind) {
    const [x1, y1] = this.place(from), [x2, y2] = this.place(to);
    const width = { base: 3.4, pattern: 2.4, hit: 3.4, front: 1.8 }[kind];
    this.add("line", { class: kind, x1, y1, x2, y2, "stroke-width": width });
    const length = Math.hypot(x2 - x1, y2 - y1) || 1, ux = (x2 - x1) / length, uy = (y2 - y1) / length;
    const mx = (x1 + x2) / 2, my = (y1 + y2) / 2, s = Math.min(6, length / 4);
    const corners = [[mx + s * ux, my + s * uy], [mx - s * ux - s * uy, my - s * uy + s * ux], [mx - s * ux + s * uy, my - s * uy - s * ux]];
    this.add("polygon", { class: `arrow ${kind}`, points: corners.map((p) => p.join(",")).join(" ") });
  }

  drawVertices(candidate) {
    const rule = candidate && this.run.rules[candidate.rule];
    const hitVertex = candidate?.hit.length === 1 ? candidate.hit[0] : -1;
    const used = new Set([...this.chart.c.flat(), ...this.chart.i]);
    for (const v of used) {
      const [x, y] = this.place(v), index = candidate ? candidate.matched.indexOf(v) : -1;
      if (v === hitVertex) this.add("circle", { class: "hit-vertex", cx: x, cy: y, r: 10, "stroke-width": 2 });
      const dot = svgNode("circle", { class: "vertex", cx: x, cy: y, r: index >= 0 ? 4.5 : 3 });
      dot.append(svgNode("title", {}, `vertex ${this.chart.v[v][0]}`));
      this.svg.append(dot);
      const [dx, dy] = this.outward(v), name = this.names[v];
      const label = index >= 0 && rule.vertices[index] !== name ? `${name} = ${rule.vertices[index]}` : name;
      const apart = 13 + Math.abs(dx) * Math.max(0, 3.4 * label.length - 6);
      this.add("text", { x: x + apart * dx, y: y + apart * dy }, label);
    }
  }

  /** In pixels, towards the elements that are there. */
  outward(v) {
    let x = 0, y = 0;
    for (const chain of this.chart.c)
      for (let i = 0; i + 1 < chain.length; ++i) {
        if (chain[i] !== v && chain[i + 1] !== v) continue;
        const [x1, y1] = this.place(chain[i]), [x2, y2] = this.place(chain[i + 1]);
        const length = Math.hypot(x2 - x1, y2 - y1) || 1;
        x -= (y2 - y1) / length;
        y += (x2 - x1) / length;
      }
    const length = Math.hypot(x, y);
    return length < 0.05 ? [0.6, -0.8] : [x / length, y / length];
  }

  drawKey(candidate) {
    const entries = [["base", "base edge"]];
    if (candidate && this.run.rules[candidate.rule].edges.length > 1) entries.push(["pattern", "pattern"]);
    entries.push(["front", "other front"]);
    if (candidate?.zones.length) entries.push(["zone", "free zone"]);
    if (this.svg.querySelector(".made")) entries.push(["made", candidate.reason === 0 ? "new elements" : "elements it would make"]);
    if (candidate?.hit.length) entries.push(["hit", "hits the zone"]);
    if (this.svg.querySelector(".other-zone")) entries.push(["other-zone", "zones of other rules"]);
    const colors = { base: "--ink", pattern: "--ink", front: "--kept", zone: "--zone", made: "--made-edge", hit: "--bad", "other-zone": "--zone" };
    document.getElementById("chart-key").replaceChildren(...entries.map(([kind, text]) => {
      const line = svgNode("svg", { viewBox: "0 0 22 10", "aria-hidden": "true" });
      line.append(svgNode("line", {
        x1: 0, y1: 5, x2: 22, y2: 5, style: `stroke: var(${colors[kind]})`,
        "stroke-width": { base: 3.4, front: 1.8, zone: 8, made: 8 }[kind] ?? 2.4, "stroke-opacity": kind === "zone" || kind === "made" ? 0.4 : 1,
        "stroke-dasharray": kind === "other-zone" ? "4 3" : "none",
      }));
      return node("li", {}, line, text);
    }));
  }
}
