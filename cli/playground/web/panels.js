// What the page shows of the answers: problems, mesh, tests and rules. Texts of the rule file never become HTML.
"use strict";

const byId = (id) => document.getElementById(id);

/** An element with attributes, and texts or elements in it. */
function node(tag, attributes, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else made.setAttribute(name, value);
  }
  made.append(...children);
  return made;
}

function showText(id, text) {
  byId(id).textContent = text;
  byId(id).hidden = text === "";
}

function plural(count, one, many = one + "s") {
  return `${count.toLocaleString("en")} ${count === 1 ? one : many}`;
}

/** Shows SVG as an image, in which no script can run and no name clashes with one of the page. */
function showPicture(image, svg) {
  const old = image.src;
  image.src = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  image.hidden = false;
  if (old.startsWith("blob:")) URL.revokeObjectURL(old);
}

/** A title that leads to its line, unless the line is in another file. */
function titleAt(title, line, goTo) {
  if (!line || !goTo) return node("span", {}, title);
  return node("button", { type: "button", class: "link", title: `Line ${line}`, onclick: () => goTo(line) }, title);
}

const severityNames = { 1: "error", 2: "warning", 3: "note", 4: "note" };

/** `remark` says what is missing in the list. */
function showProblems(diagnostics, remark, goTo) {
  const errors = diagnostics.filter((d) => d.severity === 1).length;
  const others = diagnostics.length - errors;
  const counts = [errors && plural(errors, "error"), others && plural(others, "warning")].filter(Boolean);
  byId("problem-count").textContent = (counts.join(", ") || (remark.startsWith(":") ? "" : "none")) + remark;
  byId("problem-list").replaceChildren(...diagnostics.map((d) => {
    const line = d.range.start.line + 1, [first, ...rest] = d.message.split("\n");
    const item = node("li", { class: severityNames[d.severity] ?? "note" },
      titleAt(`Line ${line}: ${first}`, line, goTo), " ", node("span", { class: "code" }, d.code ?? ""));
    if (rest.length > 0) item.append(node("pre", {}, rest.join("\n")));
    return item;
  }));
}

function makerRow(maker, total, goTo) {
  const isRule = !maker.title.startsWith("without a rule");
  return node("tr", {},
    node("td", {}, swatch(maker.color)),
    node("td", isRule ? {} : { class: "bad" }, titleAt(maker.title, maker.line, goTo)),
    node("td", { title: `${(100 * maker.count / total).toFixed(1)} %` }, maker.count.toLocaleString("en")));
}

function swatch(color) {
  const square = node("span", { class: "swatch" });
  square.style.background = color;
  return square;
}

/** A mesh that cannot be made leaves the one before, which is faded. */
function showMesh(answer, goTo) {
  showText("mesh-fault", answer.fault);
  byId("mesh-result").classList.toggle("stale", answer.fault !== "");
  byId("mesh-notes").replaceChildren(...(answer.notes ?? []).map((note) => node("li", {}, note)));
  if (answer.fault !== "") {
    byId("mesh-summary").textContent = byId("mesh-picture").hidden ? "" : "of an earlier text";
    return;
  }
  showPicture(byId("mesh-picture"), answer.svg);
  const kinds = [answer.triangles && plural(answer.triangles, "triangle"), answer.quads && plural(answer.quads, "quad")];
  const { min, mean, minAngle, maxAngle } = answer.quality;
  byId("mesh-summary").textContent = [...kinds.filter(Boolean),
    answer.withoutRule ? `${answer.withoutRule.toLocaleString("en")} without a rule` : "all made by rules",
    `quality ${min.toFixed(2)} to 1, mean ${mean.toFixed(2)}`,
    `angles ${minAngle.toFixed(0)}° to ${maxAngle.toFixed(0)}°`].join(" · ");
  byId("quality-legend").hidden = byId("color").value !== "quality";
  byId("makers").tBodies[0].replaceChildren(...answer.makers.map((maker) => makerRow(maker, answer.elements, goTo)));
}

function withoutIndent(text) {
  const lines = text.split("\n"), indents = lines.filter((line) => line.trim()).map((line) => line.search(/\S/));
  return lines.map((line) => line.slice(Math.min(...indents))).join("\n");
}

function failedTest(test, goTo) {
  const article = node("article", {},
    node("strong", {}, titleAt(test.title, test.line, goTo)),
    ...test.failures.map((failure) => node("div", {},
      titleAt(`Line ${failure.line}`, failure.line, goTo), `: expected ${failure.expected}, got ${failure.got}`)));
  if (test.explanation) article.append(node("pre", { tabindex: "0" }, withoutIndent(test.explanation.trimEnd())));
  return article;
}

function showTests(answer, goTo) {
  showText("test-fault", answer.fault);
  const failed = answer.tests.filter((test) => !test.passed), passed = answer.tests.filter((test) => test.passed);
  byId("test-summary").textContent = answer.tests.length === 0 ? (answer.fault ? "" : "The file has no tests.")
    : `${passed.length} passed, ${failed.length} failed`;
  byId("test-summary").className = failed.length > 0 ? "bad" : answer.tests.length > 0 ? "good" : "muted";
  byId("failed-tests").replaceChildren(...failed.map((test) => failedTest(test, goTo)));
  byId("passed-tests").hidden = passed.length === 0;
  byId("passed-tests").querySelector("summary").textContent = plural(passed.length, "test") + " passed";
  byId("passed-tests").querySelector("ul").replaceChildren(...passed.map((test) =>
    node("li", {}, titleAt(test.title, test.line, goTo),
      node("span", { class: "muted" }, test.rule ? `  rule “${test.rule}”` : ""))));
}

function showRules(answer, goTo) {
  showText("rule-fault", answer.fault);
  byId("rule-list").classList.toggle("stale", answer.fault !== "");
  if (answer.fault !== "") return;
  const more = answer.more > 0 ? `, of which the first ${answer.rules.length} are shown` : "";
  byId("rule-summary").textContent = plural(answer.rules.length + answer.more, "rule") + more;
  for (const image of byId("rule-list").querySelectorAll("img")) URL.revokeObjectURL(image.src);
  byId("rule-list").replaceChildren(...answer.rules.map((rule) => {
    const image = node("img", { alt: `Picture of the rule ${rule.title}`, hidden: "" });
    showPicture(image, rule.svg);
    const facts = [rule.elements, rule.levels, rule.isMirror && "mirror image"].filter(Boolean).join(", ");
    return node("figure", {}, image,
      node("figcaption", {}, titleAt(rule.title, rule.line, goTo), node("span", { class: "muted" }, facts)));
  }));
}
