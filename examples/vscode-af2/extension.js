// AF2 rules in VS Code: starts `af2 lsp`, shows its pictures, and tells of its tests.
const vscode = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");
const { closePreviews, showPreview } = require("./preview");
const { makeTestExplorer } = require("./tests");

let client;
let output;
let panel; // one for all pictures, beside the text

function settings() {
  return vscode.workspace.getConfiguration("af2");
}

/// What the server wants to know; it draws, this extension shows.
function serverSettings() {
  return {
    checks: settings().get("checks"),
    checkDelay: settings().get("checkDelay"),
    hoverPictures: settings().get("hoverPictures"),
    returnPictures: true,
  };
}

function showPicture(picture) {
  if (!panel) {
    panel = vscode.window.createWebviewPanel(
      "af2.picture", "AF2", { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true });
    panel.onDidDispose(() => { panel = undefined; });
  }
  panel.title = picture.title;
  const image = Buffer.from(picture.svg, "utf8").toString("base64");
  panel.webview.html = `<!DOCTYPE html>
<html>
<head>
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'">
<style>body { background: white; margin: 0; } img { display: block; margin: auto; max-width: 100%; }</style>
</head>
<body><img alt="" src="data:image/svg+xml;base64,${image}"></body>
</html>`;
}

function tell(result) {
  output.appendLine(`${result.passed} passed, ${result.failed} failed`);
  for (const test of result.results) {
    output.appendLine(`${test.passed ? "ok   " : "FAIL "} ${test.title}`);
    for (const failure of test.failures)
      output.appendLine(`      line ${failure.line}: expected ${failure.expected}, got ${failure.got}`);
  }
  if (result.failed > 0) output.show(true);
}

/// Commands of code lenses arrive here before they go to the server.
async function executeCommand(command, args, next) {
  const result = await next(command, args);
  if (command === "af2.draw" && result) showPicture(result);
  if (command === "af2.test" && result) tell(result);
  return result;
}

function currentUri() {
  const editor = vscode.window.activeTextEditor;
  if (editor && editor.document.languageId === "af2") return editor.document.uri.toString();
  vscode.window.showInformationMessage("Open a rule file (.af2) first.");
  return undefined;
}

/// The rule around the cursor, from the outline.
async function currentRule() {
  const editor = vscode.window.activeTextEditor;
  const symbols = await vscode.commands.executeCommand(
    "vscode.executeDocumentSymbolProvider", editor.document.uri);
  const around = (symbols || []).find(
    (s) => s.detail === "rule" && s.range.contains(editor.selection.active));
  return around && around.name;
}

async function drawRule() {
  const uri = currentUri();
  if (!uri) return;
  const rule = await currentRule();
  if (!rule) return vscode.window.showInformationMessage("The cursor stands in no rule.");
  await vscode.commands.executeCommand("af2.draw", { uri, rule });
}

async function onAll(command) {
  const uri = currentUri();
  if (uri) await vscode.commands.executeCommand(command, { uri });
}

function program() {
  return settings().get("path") || "af2";
}

async function preview() {
  if (!currentUri()) return;
  const { document } = vscode.window.activeTextEditor;
  if (document.isUntitled) return vscode.window.showInformationMessage("Save the file first: the preview reads it.");
  await showPreview(program(), document);
}

/// The answer of the server alone, without the message that the command shows.
function request(command, argument, token) {
  return client.sendRequest("workspace/executeCommand", { command, arguments: [argument] }, token);
}

async function start() {
  const command = program();
  const server = { command, args: ["lsp"] };
  client = new LanguageClient("af2", "AF2 rules", server, {
    documentSelector: [{ language: "af2" }],
    initializationOptions: serverSettings(),
    outputChannel: output,
    middleware: { executeCommand },
  });
  try {
    await client.start();
  } catch (error) {
    vscode.window.showErrorMessage(
      `'${command} lsp' cannot be started (${error.message}). Set af2.path to the program af2.`);
  }
}

async function restart() {
  if (client) await client.dispose();
  await start();
}

function settingsChanged(event) {
  if (!event.affectsConfiguration("af2") || !client) return;
  if (event.affectsConfiguration("af2.path")) return restart();
  client.sendNotification("workspace/didChangeConfiguration", { settings: { af2: serverSettings() } });
}

async function activate(context) {
  output = vscode.window.createOutputChannel("AF2");
  context.subscriptions.push(
    output,
    vscode.commands.registerCommand("af2.drawRule", drawRule),
    vscode.commands.registerCommand("af2.drawAll", () => onAll("af2.draw")),
    vscode.commands.registerCommand("af2.testAll", () => onAll("af2.test")),
    vscode.commands.registerCommand("af2.preview", preview),
    vscode.commands.registerCommand("af2.restart", restart),
    vscode.workspace.onDidChangeConfiguration(settingsChanged));
  await start();
  context.subscriptions.push(makeTestExplorer(request));
}

async function deactivate() {
  closePreviews();
  if (client) await client.stop();
}

module.exports = { activate, deactivate };
