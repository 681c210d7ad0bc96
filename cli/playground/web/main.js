// The playground: sends the text to the program after each pause in typing, and shows the answers.
"use strict";

const pauseInTyping = 250, pauseBetweenLooks = 700;  // milliseconds
const page = crypto.getRandomValues(new Uint32Array(2)).join("");
const playground = {
  file: null,  // what the program says about the file
  editor: null,  // stays null with --watch
  text: "", saved: "",  // the text now, and that of the file
  basis: "", seen: "",  // versions of the file: the one that was edited, and the last one on disk
  imports: null,  // changes with the imported files
  isIdle: false,  // all answers about the text are shown
};
const underWay = new Map();  // by kind of request: what aborts it
let run = 0, timer = 0;

const isDirty = () => playground.editor !== null && playground.text !== playground.saved;

/** The answer to a request about the text; nothing if a newer one has overtaken it. */
async function post(kind, parameters, text) {
  const query = new URLSearchParams({ page, run: ++run, ...parameters });
  underWay.get(kind)?.abort();
  const control = new AbortController();
  underWay.set(kind, control);
  try {
    const response = await fetch(`${kind}?${query}`,
      { method: "POST", headers: { "Content-Type": "text/plain" }, body: text, signal: control.signal });
    if (!response.ok) return { fault: (await response.text()).trim() };
    const answer = await response.json();
    return answer?.overtaken ? null : answer;
  } catch (error) {
    if (error.name === "AbortError") return null;
    showGone();
    return null;
  } finally {
    if (underWay.get(kind) === control) underWay.delete(kind);
  }
}

const goTo = (line) => playground.editor?.goTo(line);
const goToOrNot = () => (playground.editor ? goTo : null);

function showDiagnostics(diagnostics, remark) {
  showProblems(diagnostics, remark, goToOrNot());
  playground.editor?.mark(diagnostics);
}

/** The quick checks at once, then all of them. */
async function refreshProblems(text) {
  const quick = await post("diagnostics", {}, text);
  if (!quick || text !== playground.text) return;
  if (quick.fault) return showDiagnostics([], `: ${quick.fault}`);
  showDiagnostics(quick.diagnostics, " so far; checking …");
  const all = await post("checks", {}, text);
  if (!all || text !== playground.text) return;
  const remark = all.late ? "; the checks were stopped before their end" : all.fault ? `; ${all.fault}` : "";
  showDiagnostics(all.diagnostics ?? quick.diagnostics, remark);
}

async function refreshMesh(text) {
  const values = Object.fromEntries(["domain", "size", "color"].map((id) => [id, byId(id).value]));
  const answer = await post("mesh", { ...values, optimize: Number(byId("optimize").checked) }, text);
  if (answer) showMesh(answer, goToOrNot());
}

async function refreshTests(text) {
  const answer = await post("tests", {}, text);
  if (answer) showTests({ tests: [], ...answer }, goToOrNot());
}

async function refreshRules(text) {
  const answer = await post("rules", {}, text);
  if (answer) showRules(answer, goToOrNot());
}

async function refresh() {
  const { text } = playground;
  playground.isIdle = false;
  await Promise.all([refreshProblems, refreshMesh, refreshTests, refreshRules].map((part) => part(text)));
  if (text === playground.text) playground.isIdle = true;
}

function textChanged() {
  playground.text = playground.editor.text();
  playground.isIdle = false;
  showState();
  clearTimeout(timer);
  timer = setTimeout(refresh, pauseInTyping);
}

function showState() {
  byId("save").disabled = !isDirty();
  byId("state").textContent = playground.file.watches ? `follows ${playground.file.path}`
    : isDirty() ? "not saved" : "saved";
  document.title = `${isDirty() ? "• " : ""}${playground.file.name} - AF2`;
}

/** A line on top of the page, with buttons. */
function showNotice(text, ...buttons) {
  byId("notice").replaceChildren(node("span", {}, text), ...buttons.map(([label, action]) =>
    node("button", { type: "button", onclick: () => { hideNotice(); action(); } }, label)));
  byId("notice").hidden = false;
}

function hideNotice() {
  byId("notice").hidden = true;
}

function showGone() {
  showNotice("The program does not answer any more. Start it again: af2 playground " + (playground.file?.name ?? ""),
    ["Try again", () => refresh()]);
}

const choicesOnChange = () => [["Load the file on disk", loadFromDisk], ["Overwrite it", () => save(true)]];

async function save(overwrite = false) {
  if (!isDirty() && !overwrite) return;
  const { text } = playground;
  const answer = await post("save", { basis: playground.basis, overwrite: Number(overwrite) }, text);
  if (!answer) return;
  if (answer.fault) return showNotice("Not saved: " + answer.fault);
  if (answer.changed)
    return showNotice("Not saved: another program has changed the file meanwhile.", ...choicesOnChange());
  playground.basis = playground.seen = answer.version;
  playground.saved = text;
  hideNotice();
  showState();
}

async function loadFromDisk() {
  const file = await (await fetch("file")).json();
  if (file.fault) return showNotice(`The file cannot be read: ${file.fault}`);
  playground.basis = playground.seen = file.version;
  playground.saved = playground.text = file.text;
  if (playground.editor) playground.editor.replace(file.text);
  showState();
  refresh();
}

/** The file or one that it imports has changed on disk. */
async function look() {
  try {
    const state = await (await fetch("state")).json();
    if (state.version !== playground.seen) {
      playground.seen = state.version;
      if (!isDirty()) await loadFromDisk();
      else showNotice("Another program has changed the file.", ...choicesOnChange());
    } else if (playground.imports !== null && state.imports !== playground.imports && playground.isIdle) {
      refresh();
    }
    playground.imports = state.imports;
    if (byId("notice").textContent.startsWith("The program does not answer")) hideNotice();
  } catch {
    showGone();
  }
  setTimeout(look, pauseBetweenLooks);
}

function fill(select, choices, value) {
  select.replaceChildren(...choices.map(({ name, label }) => node("option", { value: name }, label)));
  select.value = value;
}

function useScheme() {
  const root = document.documentElement, button = byId("scheme");
  const use = (scheme) => {
    root.dataset.scheme = scheme;
    button.textContent = scheme === "dark" ? "Light" : "Dark";
  };
  const preference = matchMedia("(prefers-color-scheme: dark)");
  preference.addEventListener("change", () => use(preference.matches ? "dark" : "light"));
  button.addEventListener("click", () => use(root.dataset.scheme === "dark" ? "light" : "dark"));
  use(preference.matches ? "dark" : "light");
}

async function start() {
  useScheme();
  const file = playground.file = await (await fetch("file")).json();
  playground.text = playground.saved = file.text;
  playground.basis = playground.seen = file.version;
  byId("name").textContent = file.name;
  byId("name").title = file.path;
  byId("limits").textContent = `The largest of these meshes has about 20,000 elements. A mesh, the tests and the checks are stopped after ${file.seconds} s, and a mesh also when the rules make far more elements than expected.`;
  fill(byId("domain"), file.domains, file.domains[0].name);
  fill(byId("size"), file.sizes, "medium");
  for (const id of ["domain", "size", "color", "optimize"])
    byId(id).addEventListener("change", () => refreshMesh(playground.text));
  document.body.classList.toggle("watching", file.watches);
  byId("save").hidden = file.watches;
  if (!file.watches) {
    playground.editor = makeEditor(byId("editor"), file.text, file.keywords,
      { ask: (kind, position) => post(kind, position, playground.text), changed: textChanged, save: () => save() });
    playground.text = playground.saved = playground.editor.text();
    byId("save").addEventListener("click", () => save());
    addEventListener("beforeunload", (event) => { if (isDirty()) event.preventDefault(); });
  }
  showState();
  setTimeout(look, pauseBetweenLooks);
  await refresh();
}

start();
