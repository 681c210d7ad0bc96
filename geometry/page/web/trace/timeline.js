// The time line: one mark for each event, at the height of its level.

const widthOfChange = 0.2; // relative to that of a step: there are many small moves
const bandOfChanges = 14; // pixels at the bottom, for changes after the front

class Timeline {
  constructor(canvas, run, seek) {
    this.canvas = canvas;
    this.run = run;
    this.picture = document.createElement("canvas");
    this.cursor = run.firstEvent;
    this.widths = Timeline.widthsBefore(run);
    new ResizeObserver(() => this.draw()).observe(canvas);
    const follow = (event) => seek(this.eventAt(event.clientX - canvas.getBoundingClientRect().left));
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      follow(event);
    });
    canvas.addEventListener("pointermove", (event) => event.buttons === 1 && follow(event));
  }

  /** By event, from the first one: the width of all events before it. */
  static widthsBefore(run) {
    const widths = new Float64Array(run.lastEvent - run.firstEvent + 2);
    for (let i = 0; i + 1 < widths.length; ++i)
      widths[i + 1] = widths[i] + (isStep(run, run.firstEvent + i) ? 1 : widthOfChange);
    return widths;
  }

  eventAt(x) {
    const { widths, run } = this, wanted = x / this.canvas.clientWidth * widths[widths.length - 1];
    const event = run.firstEvent + lowerBound(widths, wanted, (width) => width) - 1;
    return Math.min(Math.max(event, run.firstEvent), run.lastEvent);
  }

  xOf(event) {
    return this.widths[event - this.run.firstEvent] / this.widths[this.widths.length - 1] * this.canvas.clientWidth;
  }

  color(name) {
    return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  }

  /** All events, once for each size and scheme. */
  draw() {
    const { run } = this, width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    if (!width || !height) return;
    const ratio = Math.min(devicePixelRatio, 2);
    for (const canvas of [this.canvas, this.picture]) Object.assign(canvas, { width: width * ratio, height: height * ratio });
    const pen = this.picture.getContext("2d");
    pen.scale(ratio, ratio);
    const markWidth = Math.max(width / this.widths[this.widths.length - 1], 1), high = height - bandOfChanges - 4;
    const bad = this.color("--bad"), changed = this.color("--accent"), colors = run.rules.map((_, i) => css(categoryColor(i)));
    let most = 1;
    for (let e = run.firstEvent; e <= run.lastEvent; ++e) most = Math.max(most, run.level[e]);
    for (let event = run.firstEvent; event <= run.lastEvent; ++event) {
      const x = this.xOf(event);
      if (run.kind[event] === eventKinds.row) {
        pen.fillStyle = this.color("--muted");
        pen.globalAlpha = 0.4;
        pen.fillRect(x, 0, 1, high);
        pen.globalAlpha = 1;
        continue;
      }
      if (!isStep(run, event)) {
        pen.fillStyle = changed;
        pen.globalAlpha = 0.6;
        pen.fillRect(x, height - bandOfChanges + 2, markWidth, bandOfChanges - 4);
        pen.globalAlpha = 1;
        continue;
      }
      const isApplied = run.kind[event] === eventKinds.applied;
      const tall = Math.max(3, high / most), y = high - run.level[event] / most * high + 2;
      pen.fillStyle = isApplied ? colors[run.rule[event]] : bad;
      pen.fillRect(x, y, markWidth, isApplied ? tall : Math.min(tall, 3));
    }
    pen.fillStyle = this.color("--muted");
    for (const front of run.fronts) if (front.firstEvent > run.firstEvent) pen.fillRect(this.xOf(front.firstEvent), 0, 1, height);
    pen.font = "11px system-ui, sans-serif";
    pen.fillText(`level ${most}`, 4, 12);
    pen.fillText("level 1", 4, high - 2);
    this.moveTo(this.cursor);
  }

  moveTo(event) {
    this.cursor = event;
    const pen = this.canvas.getContext("2d"), ratio = Math.min(devicePixelRatio, 2);
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.clearRect(0, 0, this.canvas.width, this.canvas.height);
    pen.drawImage(this.picture, 0, 0);
    pen.fillStyle = this.color("--select");
    pen.fillRect(Math.round(this.xOf(event) * ratio) - ratio, 0, 2 * ratio, this.canvas.height);
    Object.assign(this.canvas, { ariaValueMin: this.run.firstEvent, ariaValueMax: this.run.lastEvent, ariaValueNow: event });
  }
}
