// Joins the parts of the page that plays a run.

/** In words: the event that is shown. */
function captionOf(run, event) {
  const front = run.fronts[run.front[event]], face = run.faces[run.faceOf[event]];
  const fronts = run.fronts.filter((f) => f.face === face.id).length;
  const kept = front.kept === undefined ? "" : front.kept ? "" : ", not kept";
  const where = `Face ${face.id}` + (fronts > 1 ? `, front ${front.number} of ${fronts}${kept}` : "");
  if (run.kind[event] === eventKinds.closed) return `${where}: the rest of the front was closed without rules`;
  if (run.kind[event] === eventKinds.turned) return `${where}: inverted elements were turned round`;
  if (run.kind[event] === eventKinds.row)
    return `${where}: a row is complete; ${counted(run.moveCount[event], "vertex", "vertices")} moved`;
  if (!isStep(run, event)) {
    const change = run.acts[run.kind[event] - eventKinds.firstAct];
    return `${where}, after the front: ${change}; worst element ${digits(run.before[event])} → ${digits(run.after[event])}`;
  }
  const what = run.kind[event] === eventKinds.applied
    ? `rule “${run.rules[run.rule[event]].name}” (score ${digits(run.before[event])})` : "no rule";
  return `${where}, step ${run.step[event]}: level ${run.level[event]}, ${what}; ${counted(run.after[event], "edge")} left`;
}

class Page {
  constructor(run, view) {
    Object.assign(this, { run, view });
    this.surface = new Surface(run, view);
    this.chart = new Chart(document.getElementById("chart"), run);
    this.timeline = new Timeline(document.getElementById("timeline"), run, (event) => this.seek(event));
    this.fillLists();
    this.connect();
    this.seek(run.firstEvent);
  }

  fillLists() {
    const { run } = this, used = new Set(run.rule);
    const uses = document.getElementById("rule-choice");
    run.rules.forEach((rule, i) => used.has(i) && uses.append(node("option", { value: String(i) }, rule.name)));
    const faces = document.getElementById("face-choice");
    faces.hidden = run.faces.length < 2;
    run.faces.forEach((face, i) => faces.append(node("option", { value: String(i) }, `Face ${face.id}`)));
    document.title = `${run.title} – AF2`;
    document.getElementById("title").textContent = run.title;
    let steps = 0, rows = 0;
    for (let event = 0; event < run.eventCount; ++event) {
      if (isStep(run, event)) ++steps;
      else if (isOfFront(run, event)) ++rows;
    }
    document.getElementById("summary").textContent =
      `${counted(steps, "step")}${rows > 0 ? `, ${counted(rows, "row")} smoothed` : ""}, ${counted(run.eventCount - steps - rows, "change")} after the fronts, ${counted(run.faces.length, "face")}`;
    document.getElementById("notes-list").replaceChildren(...run.notes.map((note) => node("li", {}, note)));
  }

  connect() {
    const { run } = this, on = (id, use) => document.getElementById(id).addEventListener("click", use);
    on("first", () => this.seek(run.firstEvent));
    on("back", () => this.seek(this.event - 1));
    on("forward", () => this.seek(this.event + 1));
    on("last", () => this.seek(run.lastEvent));
    on("play", () => this.play(!this.isPlaying));
    on("next-refusal", () => this.find((e) => run.kind[e] === eventKinds.refused));
    on("next-loop", () => this.find((e) => this.closesLoop(e)));
    on("next-change", () => this.find((e) => !isOfFront(run, e)));
    on("next-use", () => this.findUse(Number(document.getElementById("rule-choice").value), 1));
    on("rule-next", () => this.findUse(this.selected.rule, 1));
    on("rule-previous", () => this.findUse(this.selected.rule, -1));
    on("zoom", () => this.surface.zoom());
    const faces = document.getElementById("face-choice");
    faces.addEventListener("change", () => this.seek(run.faces[faces.value].firstEvent));
    document.getElementById("step-form").addEventListener("submit", (event) => {
      event.preventDefault();
      this.seekStep(Number(document.getElementById("step-number").value));
    });
    onElementClick(this.view, (element) => element >= 0 && this.seek(run.birth[element]));
    document.addEventListener("keydown", (event) => this.pressed(event));
  }

  pressed(event) {
    const isTaken = event.target.closest("input, select, button, #canvas, pre, #reasons") !== null;
    if (isTaken || event.ctrlKey || event.metaKey || event.altKey) return;
    const keys = {
      ArrowLeft: () => this.seek(this.event - 1), ArrowRight: () => this.seek(this.event + 1),
      Home: () => this.seek(this.run.firstEvent), End: () => this.seek(this.run.lastEvent),
      " ": () => this.play(!this.isPlaying),
    };
    if (!keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  }

  /** A rule without new edges closes a loop, unless it splits one; the last step of a front ends it. */
  closesLoop(event) {
    const { run } = this;
    if (!isStep(run, event)) return false;
    let next = event + 1;
    while (next < run.eventCount && run.kind[next] === eventKinds.row) ++next;
    const isLast = next === run.eventCount || !isStep(run, next) || run.front[next] !== run.front[event];
    return isLast || (run.kind[event] === eventKinds.applied && run.rules[run.rule[event]].closes);
  }

  /** Goes to the next event of a kind, or says that there is none. */
  find(accepts, direction = 1) {
    for (let e = this.event + direction; e >= this.run.firstEvent && e <= this.run.lastEvent; e += direction)
      if (accepts(e)) return this.seek(e);
    document.getElementById("shown").textContent = "there is no further one";
    return undefined;
  }

  findUse(rule, direction) {
    this.find((e) => this.run.kind[e] === eventKinds.applied && this.run.rule[e] === rule, direction);
  }

  seekStep(step) {
    const event = eventOfStep(this.run, this.run.faceOf[this.event], step);
    if (event >= 0) this.seek(event);
  }

  play(isOn) {
    this.isPlaying = isOn;
    document.getElementById("play").textContent = isOn ? "⏸ Pause" : "▶ Play";
    if (!isOn) return;
    let last = performance.now(), due = 0;
    const tick = (now) => {
      if (!this.isPlaying) return;
      due += (now - last) / 1000 * Number(document.getElementById("speed").value);
      last = now;
      if (due >= 1) this.seek(this.event + Math.floor(due));
      due %= 1;
      if (this.event >= this.run.lastEvent) this.play(false);
      else requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  }

  seek(wanted) {
    const { run } = this;
    if (run.eventCount === 0) return;
    const event = Math.min(Math.max(wanted, run.firstEvent), run.lastEvent);
    this.event = event;
    this.surface.show(event);
    if (document.getElementById("follow").checked) this.surface.follow();
    this.timeline.moveTo(event);
    this.step = isStep(run, event) ? chartOf(run, event) : null;
    this.candidates = this.step ? candidatesOf(this.step) : [];
    const applied = this.candidates.find((c) => c.reason === 0);
    this.choose(applied ?? farthest(this.candidates));
    document.getElementById("caption").textContent = captionOf(run, event);
    document.getElementById("face-choice").value = String(run.faceOf[event]);
    document.getElementById("step-number").value = String(run.step[event]);
    const alive = this.surface.alive.reduce((sum, e) => sum + e, 0);
    document.getElementById("shown").textContent = counted(alive, "element");
  }

  /** Shows one of the candidates of the step: its zone, its elements and its text. */
  choose(candidate) {
    this.selected = candidate;
    if (this.step) this.chart.show(this.step, this.candidates, candidate);
    else this.chart.clear();
    showReasons(this.run, this.event, this.step, this.candidates, candidate, (other) => this.choose(other));
    const rule = candidate && this.run.rules[candidate.rule];
    document.getElementById("rule").hidden = !rule;
    if (!rule) return;
    document.getElementById("rule-title").textContent = `Rule “${rule.name}”`;
    document.getElementById("rule-place").textContent = rule.file ? `${rule.file}:${rule.line}` : "";
    document.getElementById("rule-text").textContent = rule.text;
  }
}

function start() {
  const run = readRun();
  const view = new View(run.mesh, document.getElementById("canvas"));
  if (view.isPlanar) view.look(new THREE.Vector3(0, 0, 1));
  connectViews(view);
  const page = new Page(run, view);
  connectScheme({
    useScheme() {
      view.useScheme();
      page.surface.useScheme();
      page.timeline.draw();
    },
  });
  return { run, view, page };
}

/** The parts of the running page, for tests and for the console of the browser. */
const af2 = start();
