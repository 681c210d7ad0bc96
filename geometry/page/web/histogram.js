// The histogram of a quantity, with two handles: elements with values outside of them are hidden.

const barCount = 44;
const handleSteps = 400;

class Histogram {
  constructor(quantities, changed) {
    this.quantities = quantities;
    this.changed = changed;
    this.select = document.getElementById("histogram-of");
    this.lowest = document.getElementById("lowest");
    this.highest = document.getElementById("highest");
    for (const quantity of quantities.values())
      if (quantity.isNumeric) this.select.append(node("option", { value: quantity.key }, quantity.label));
    this.select.addEventListener("change", () => this.show(this.select.value));
    this.lowest.addEventListener("input", () => this.moved(this.lowest));
    this.highest.addEventListener("input", () => this.moved(this.highest));
    document.getElementById("filter-reset").addEventListener("click", () => this.show(this.quantity.key));
  }

  /** Shows another quantity, with the handles at the ends. */
  show(key) {
    this.quantity = this.quantities.get(key);
    this.select.value = key;
    [this.low, this.high] = this.domain();
    this.steps = this.quantity.isInteger ? Math.max(this.high - this.low, 1) : handleSteps;
    for (const handle of [this.lowest, this.highest]) Object.assign(handle, { min: 0, max: this.steps, step: 1 });
    this.lowest.value = 0;
    this.highest.value = this.steps;
    this.lowest.setAttribute("aria-label", `Lowest ${this.quantity.label} shown`);
    this.highest.setAttribute("aria-label", `Highest ${this.quantity.label} shown`);
    this.bars = this.countBars();
    this.draw();
    this.changed();
  }

  /** The ends of the histogram: whole numbers have a bar each, a single value some room. */
  domain() {
    const { low, high, isInteger } = this.quantity;
    if (isInteger) return [low, high];
    return high > low ? [low, high] : [low - 0.5, high + 0.5];
  }

  countBars() {
    const { values, isInteger } = this.quantity;
    const count = isInteger ? Math.min(this.high - this.low + 1, barCount) : barCount;
    const bars = new Array(count).fill(0), span = this.high - this.low + (isInteger ? 1 : 0);
    this.none = 0;
    for (const value of values) {
      if (Number.isNaN(value)) ++this.none;
      else ++bars[Math.min(Math.floor((value - this.low) / span * count), count - 1)];
    }
    return bars;
  }

  /** The value at a handle. */
  at(handle) {
    return this.low + (this.high - this.low) * handle.value / this.steps;
  }

  isNarrowed() {
    return Number(this.lowest.value) > 0 || Number(this.highest.value) < this.steps;
  }

  /** A handle at an end of the scale lets everything there through, however the value was rounded. */
  limits() {
    return [Number(this.lowest.value) > 0 ? this.at(this.lowest) : -Infinity,
      Number(this.highest.value) < this.steps ? this.at(this.highest) : Infinity];
  }

  moved(handle) {
    const low = Number(this.lowest.value), high = Number(this.highest.value);
    if (low > high) handle.value = handle === this.lowest ? high : low;
    // When both handles are at the same end, the one that can still move lies on top.
    this.lowest.style.zIndex = low > this.steps / 2 ? 1 : 0;
    this.draw();
    this.changed();
  }

  draw() {
    const most = Math.max(...this.bars), width = 100 / this.bars.length;
    const [low, high] = this.limits(), span = this.high - this.low + (this.quantity.isInteger ? 1 : 0);
    const shapes = this.bars.map((count, i) => {
      if (count === 0) return "";
      const height = Math.max(66 * count / most, 2); // a few poor elements must be seen beside many good ones
      const from = this.low + span * i / this.bars.length, to = from + span / this.bars.length;
      const isOn = this.quantity.isInteger ? from >= low && from <= high : to >= low && from <= high;
      const color = css(colorOfValue(this.quantity, this.quantity.isInteger ? from : (from + to) / 2));
      const paint = isOn ? `fill="${color}"` : 'class="bar-off"';
      return `<rect x="${i * width + 0.1 * width}" y="${72 - height}" width="${0.8 * width}" height="${height}" ${paint}>` +
        `<title>${digits(from)}${this.quantity.isInteger ? "" : " to " + digits(to)}: ${count}</title></rect>`;
    });
    document.getElementById("histogram").innerHTML =
      `<svg viewBox="0 0 100 74" preserveAspectRatio="none" role="img" aria-label="Histogram of ${this.quantity.label}">` +
      `${shapes.join("")}<line class="base" x2="100" y1="72.5" y2="72.5" vector-effect="non-scaling-stroke"/></svg>`;
    this.drawRange();
  }

  drawRange() {
    for (const handle of [this.lowest, this.highest])
      handle.setAttribute("aria-valuetext", digits(this.at(handle)));
    const none = this.none === 0 ? ""
      : `; ${counted(this.none, "element has", "elements have")} none` + (this.isNarrowed() ? " and are hidden" : "");
    document.getElementById("range").textContent = 
      `${digits(this.at(this.lowest))} to ${digits(this.at(this.highest))}${none}`;
  }

  /** Clears the marks of elements outside the handles; those without a value are shown only if all are. */
  hideOutside(isVisible) {
    if (!this.isNarrowed()) return;
    const { values } = this.quantity, [low, high] = this.limits();
    for (let e = 0; e < isVisible.length; ++e)
      if (!(values[e] >= low && values[e] <= high)) isVisible[e] = 0;
  }
}
