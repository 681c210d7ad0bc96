// extension_test.js AF2 EXTENSION FOLDER: the extension's commands, preview and test explorer.
const assert = require("assert");
const fs = require("fs");
const Module = require("module");
const { makeEditor, Uri } = require("./editor");

const [af2, extensionFolder, folder] = process.argv.slice(2);
const program = { path: af2 };
const { editor, vscode, client } = makeEditor(program, folder);
const load = Module._load;
Module._load = (name, ...rest) => {
  if (name === "vscode") return vscode;
  if (name === "vscode-languageclient/node") return client;
  return load(name, ...rest);
};

const rules = `af2 1;
ruleset "r" { elements tri; }
rule "free" quality 1 {
  new c = mid(a, b) + (0, 0.866);
  zone a, b, c;
  tri a b c;
}
test "holds" {
  front p (0, 0) -> r (1, 0);
  expect rule "free";
}
test "fails" {
  front p (0, 0) -> r (1, 0);
  expect stuck;
}
`;

async function status(address) {
  return (await fetch(address)).status;
}

async function checkPreview() {
  const preview = editor.commands.get("af2.preview");
  await preview();
  assert.deepStrictEqual(editor.messages.splice(0), ["Open a rule file (.af2) first."]);
  const file = `${folder}/rules.af2`;
  editor.active = { document: { uri: Uri.file(file), languageId: "af2", isUntitled: false } };
  await preview();
  const [panel] = editor.panels;
  assert.deepStrictEqual(editor.messages, []);
  const address = /<iframe [^>]*src="(http:\/\/127\.0\.0\.1:\d+\/[0-9a-f]{32}\/)"/.exec(panel.webview.html)[1];
  assert.match(panel.webview.html, new RegExp(`frame-src ${new URL(address).origin};`));
  assert.strictEqual(await status(address), 200);
  await preview();
  assert.strictEqual(editor.panels.length, 1, "one preview for a file");
  assert.strictEqual(panel.shown, 2);
  panel.dispose();
  for (let i = 0; i < 200 && await status(address).catch(() => 0); ++i) await new Promise((done) => setTimeout(done, 50));
  assert.strictEqual(await status(address).catch(() => 0), 0, "the program ends with its panel");

  program.path = "no-such-af2";
  await preview();
  assert.match(editor.messages.splice(0)[0], /'no-such-af2 playground' cannot be started/);
  program.path = af2;
  editor.active = { document: { uri: Uri.file(`${folder}/none.af2`), languageId: "af2", isUntitled: false } };
  await preview();
  assert.match(editor.messages.splice(0)[0], /there is no rule file/);
}

async function checkTests() {
  const token = { isCancellationRequested: false };
  await editor.run({}, token);
  const [run] = editor.runs;
  assert.ok(run.isOver);
  assert.deepStrictEqual([...run.results.keys()], ["holds", "fails"]);
  assert.strictEqual(run.results.get("holds").kind, "passed");
  const { kind, messages: [message] } = run.results.get("fails");
  assert.strictEqual(kind, "failed");
  assert.match(message.message, /^expected stuck.*, got rule "free"/);
  assert.match(message.message, /\n.*free .*applied/, "the table of the rules");
  assert.strictEqual(message.location.range.line, 13);

  const [file] = editor.controller.items.items.values();
  assert.strictEqual(file.label, "rules.af2");
  const tests = [...file.children.items.values()];
  assert.deepStrictEqual(tests.map((test) => test.range.start.line), [7, 11]);
  await editor.run({ include: [tests[1]] }, token);
  assert.deepStrictEqual([...editor.runs[1].results.keys()], ["fails"]);
  await editor.run({ exclude: [tests[1]] }, token);
  assert.deepStrictEqual([...editor.runs[2].results.keys()], ["holds"]);
}

async function main() {
  fs.writeFileSync(`${folder}/rules.af2`, rules);
  fs.writeFileSync(`${folder}/no_tests.af2`, "af2 1;\nconst H = 1;\n");
  const extension = require(extensionFolder + "/extension.js");
  await extension.activate({ subscriptions: [] });
  const contributed = require(extensionFolder + "/package.json").contributes.commands.map((c) => c.command);
  assert.deepStrictEqual([...editor.commands.keys()].sort(), contributed.sort());
  await checkPreview();
  await checkTests();
  await extension.deactivate();
}

main().then(() => process.exit(0), (error) => {
  console.error(error);
  process.exit(1);
});
