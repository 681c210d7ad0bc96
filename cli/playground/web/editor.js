// The editor of the rule file: CodeMirror, which asks the language server about the text.
"use strict";

/** Colours of rule files. The words that begin clauses are names elsewhere. */
function ruleLanguage(words) {
  const keywords = new Set(words);
  return CM.StreamLanguage.define({
    name: "af2",
    startState: () => ({ isStart: true }),
    token(stream, state) {
      if (stream.eatSpace()) return null;
      const isStart = state.isStart;
      if (stream.match(/#.*/)) return "comment";
      state.isStart = false;
      if (stream.match(/"[^"\n]*"?/)) return "string";
      if (stream.match(/(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?/)) return "number";
      const word = stream.match(/[A-Za-z_]\w*/);
      if (word) return keywords.has(word[0]) && (isStart || keywordsWithin.has(word[0])) ? "keyword" : "variableName";
      const sign = stream.next();
      state.isStart = sign === ";" || sign === "{" || sign === "}";
      return null;
    },
    languageData: { commentTokens: { line: "#" } },
  });
}

/** Keywords within clauses. */
const keywordsWithin = new Set(["rule", "quality", "mirror", "expect", "not", "of", "for", "in", "import"]);

const editorTheme = (() => {
  const { tags } = CM;
  const look = CM.EditorView.theme({
    "&": { backgroundColor: "var(--card)", color: "var(--ink)", fontSize: "13px" },
    ".cm-scroller": { fontFamily: "ui-monospace, 'DejaVu Sans Mono', Menlo, Consolas, monospace", lineHeight: "1.5" },
    "&.cm-focused": { outline: "none" },
    ".cm-content": { caretColor: "var(--ink)" },
    ".cm-cursor": { borderLeftColor: "var(--ink)" },
    ".cm-gutters": { backgroundColor: "var(--card)", color: "var(--muted)", border: "none" },
    ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "var(--line)" },
    "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground":
      { backgroundColor: "var(--selected)" },
    ".cm-tooltip": { backgroundColor: "var(--card)", color: "var(--ink)", border: "1px solid var(--frame)" },
    ".cm-tooltip-autocomplete ul li[aria-selected]": { backgroundColor: "var(--accent)", color: "var(--card)" },
    ".cm-completionInfo": { backgroundColor: "var(--card)" },
    ".cm-panels": { backgroundColor: "var(--page)", color: "var(--ink)" },
    ".cm-diagnostic": { whiteSpace: "pre-wrap", fontSize: "12.5px" },
  });
  const style = CM.HighlightStyle.define([
    { tag: tags.keyword, color: "var(--keyword)" },
    { tag: tags.string, color: "var(--string)" },
    { tag: tags.number, color: "var(--number)" },
    { tag: tags.comment, color: "var(--comment)", fontStyle: "italic" },
  ]);
  return [look, CM.syntaxHighlighting(style)];
})();

/** Positions of the language server protocol are lines and UTF-16 units, those of CodeMirror units from the start. */
function offsetAt(doc, { line, character }) {
  if (line >= doc.lines) return doc.length;
  const at = doc.line(line + 1);
  return Math.min(at.from + character, at.to);
}

function positionAt(doc, offset) {
  const line = doc.lineAt(offset);
  return { line: line.number - 1, character: offset - line.from };
}

const severities = { 1: "error", 2: "warning", 3: "info", 4: "hint" };

function marksOf(doc, diagnostics) {
  return diagnostics.map((d) => {
    const from = offsetAt(doc, d.range.start), to = offsetAt(doc, d.range.end);
    return { from, to: Math.max(from, to), severity: severities[d.severity] ?? "info", message: d.message,
      source: d.code ?? "af2" };
  });
}

const completionTypes = { 3: "function", 5: "property", 6: "variable", 7: "class", 9: "namespace", 14: "keyword",
  17: "text", 18: "variable", 19: "namespace", 21: "constant" };

/** Snippets of the protocol have $1 and $0 where those of CodeMirror have ${1} and an empty field at the end. */
function snippetOf(text) {
  return text.replace(/\$(\d+)/g, "${$1}").replace(/\$\{0\}/g, "${}");
}

function optionOf(item) {
  const text = item.textEdit?.newText ?? item.insertText ?? item.label;
  const help = item.documentation?.value ?? item.documentation;
  const option = { label: item.label, detail: item.detail, type: completionTypes[item.kind], sortText: item.sortText,
    boost: -Number.parseInt(item.sortText ?? "0", 10) || 0 };
  if (help) option.info = () => helpOf(help);
  return item.insertTextFormat === 2 ? CM.snippetCompletion(snippetOf(text), option) : { ...option, apply: text };
}

function completionSource(ask) {
  return async (context) => {
    const before = context.matchBefore(/[\w."/]+/);
    if (!before && !context.explicit) return null;
    const answer = await ask("completion", positionAt(context.state.doc, context.pos));
    const items = answer?.items ?? [];
    if (items.length === 0) return null;
    const start = items.find((item) => item.textEdit)?.textEdit.range.start;
    return { from: start ? offsetAt(context.state.doc, start) : context.pos, options: items.map(optionOf),
      validFor: /^\w*$/ };
  };
}

/** The little Markdown that the language server writes: code, pictures as data, and plain lines. */
function helpOf(markdown) {
  const help = node("div", { class: "help" });
  for (const [i, part] of markdown.split(/```\w*\n?/).entries()) {
    if (i % 2 === 1) {
      help.append(node("pre", {}, part.trimEnd()));
      continue;
    }
    const picture = /!\[[^\]]*\]\((data:image\/svg\+xml;base64,[A-Za-z0-9+/=]+)\)/.exec(part);
    const text = part.replace(picture?.[0] ?? "", "").trim();
    if (text) help.append(node("p", {}, text));
    if (picture) help.append(node("img", { src: picture[1], alt: "Picture of the rule" }));
  }
  return help;
}

function hoverSource(ask) {
  return async (view, pos) => {
    const answer = await ask("hover", positionAt(view.state.doc, pos));
    if (!answer?.contents) return null;
    const range = answer.range;
    return {
      pos: range ? offsetAt(view.state.doc, range.start) : pos,
      end: range ? offsetAt(view.state.doc, range.end) : pos,
      above: true,
      create: () => ({ dom: helpOf(answer.contents.value) }),
    };
  };
}

/** `ask(what, position)` asks the language server; `changed` and `save` are called when the user does so. */
function makeEditor(parent, text, words, { ask, changed, save }) {
  const lineBreak = text.includes("\r\n") ? "\r\n" : "\n";
  const view = new CM.EditorView({
    parent,
    state: CM.EditorState.create({
      doc: text,
      extensions: [
        CM.EditorState.lineSeparator.of(lineBreak), CM.lineNumbers(), CM.lintGutter(), CM.history(),
        CM.drawSelection(), CM.highlightActiveLine(), CM.bracketMatching(), CM.indentOnInput(),
        CM.indentUnit.of("  "), CM.highlightSelectionMatches(), CM.EditorView.lineWrapping,
        CM.EditorView.contentAttributes.of({ "aria-label": "Text of the rule file" }),
        CM.autocompletion({ override: [completionSource(ask)] }),
        CM.hoverTooltip(hoverSource(ask)),
        CM.keymap.of([{ key: "Mod-s", run: () => { save(); return true; } }, { key: "Tab", run: CM.acceptCompletion },
          CM.indentWithTab, ...CM.completionKeymap, ...CM.lintKeymap, ...CM.searchKeymap, ...CM.historyKeymap,
          ...CM.defaultKeymap]),
        CM.EditorView.updateListener.of((update) => { if (update.docChanged) changed(); }),
        ruleLanguage(words), editorTheme,
      ],
    }),
  });
  return {
    view,
    text: () => view.state.sliceDoc(),
    replace: (other) => view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: other } }),
    mark: (diagnostics) => view.dispatch(CM.setDiagnostics(view.state, marksOf(view.state.doc, diagnostics))),
    goTo(line) {
      const at = view.state.doc.line(Math.min(line, view.state.doc.lines)).from;
      view.dispatch({ selection: { anchor: at }, effects: CM.EditorView.scrollIntoView(at, { y: "center" }) });
      view.focus();
    },
  };
}
