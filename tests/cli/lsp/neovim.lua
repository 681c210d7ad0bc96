-- Runs inside Neovim: its own client talks to `af2 lsp` about rules.af2 in this folder.
local say = function(text) io.stdout:write(text .. "\n") end

local function fail(what)
  say("FAILED: " .. what)
  vim.cmd("cquit 1")
end

local function check(what, holds, seen)
  if holds then return say("ok " .. what) end
  fail(what .. ", saw: " .. vim.inspect(seen))
end

local function waitFor(what, holds)
  if not vim.wait(20000, holds, 20) then fail("waited in vain for " .. what) end
  say("ok " .. what)
end

local exited
vim.cmd("edit rules.af2")
local buffer = vim.api.nvim_get_current_buf()
local id = vim.lsp.start_client({
  name = "af2",
  cmd = { vim.g.af2, "lsp" },
  root_dir = vim.fn.getcwd(),
  init_options = { checkDelay = 50 },
  on_exit = function(code) exited = code end,
})
if not id then fail("the server does not start") end
vim.lsp.buf_attach_client(buffer, id)
local client = vim.lsp.get_client_by_id(id)
waitFor("the handshake", function() return client.initialized end)

local function lines() return vim.api.nvim_buf_get_lines(buffer, 0, -1, true) end
local function text() return table.concat(lines(), "\n") end

-- Puts the cursor on the n-th byte of the first match.
local function goTo(word, into)
  for number, line in ipairs(lines()) do
    local column = line:find(word, 1, true)
    if column then
      vim.api.nvim_win_set_cursor(0, { number, column - 1 + (into or 0) })
      return
    end
  end
  fail("the text lacks " .. word)
end

local function ask(method, more)
  local params = vim.lsp.util.make_position_params(0, client.offset_encoding)
  for key, value in pairs(more or {}) do params[key] = value end
  local answers, fault = vim.lsp.buf_request_sync(buffer, method, params, 20000)
  if fault then fail(method .. ": " .. fault) end
  return answers[id]
end

local function diagnostics() return vim.diagnostic.get(buffer) end

-- Diagnostics while typing.
goTo("mid(a, b)")
local original = text()
local row = vim.api.nvim_win_get_cursor(0)[1]
vim.cmd("normal! cwmud")
waitFor("an error where a name is wrong", function()
  local found = diagnostics()
  return #found == 1 and found[1].lnum == row - 1 and found[1].message:find("did you mean 'mid'", 1, true)
end)

-- Its quick fix.
local action = ask("textDocument/codeAction", {
  range = { start = { line = row - 1, character = 0 }, ["end"] = { line = row - 1, character = 20 } },
  context = { diagnostics = {} },
}).result[1]
check("a quick fix", action.title == "'mud' becomes 'mid'", action)
vim.lsp.util.apply_workspace_edit(action.edit, client.offset_encoding)
check("the quick fix mends the text", text() == original, text())
waitFor("the error goes away", function() return #diagnostics() == 0 end)

-- The slow checks.
vim.cmd("%s/zone a, b, c;/zone a, b, m + (0, 0.1);/")
waitFor("a finding of the checks over many matches", function()
  for _, found in ipairs(diagnostics()) do
    if found.code == "AF2-Z1" then return true end
  end
end)
vim.cmd("undo")
waitFor("it goes away with its cause", function() return #diagnostics() == 0 end)

-- Hover.
goTo('"free" quality', 2)
local hover = ask("textDocument/hover").result.contents.value
check("hover shows the doc comment", hover:find("the ideal apex", 1, true), hover)
check("hover shows derived edges", hover:find("new edges: a -> c -> b", 1, true), hover)
check("hover leaves pictures out in a terminal", not hover:find("data:image", 1, true), hover)

-- Definition, also in another file.
goTo("H * 2")
vim.lsp.buf.definition()
waitFor("the way to a definition", function()
  return vim.api.nvim_win_get_cursor(0)[1] == 6
end)
goTo("HALF")
local definition = ask("textDocument/definition").result
check("the way into an imported file", definition.uri:find("lib.af2", 1, true), definition)

-- References.
goTo("m + (0")
local references = ask("textDocument/references", { context = { includeDeclaration = true } }).result
check("references", #references == 2, references)

-- Rename.
goTo("m + (0")
vim.lsp.buf.rename("middle")
waitFor("a rename of all places", function()
  return text():find("let  middle = mid(a, b);", 1, true) and text():find("c = middle + (0", 1, true)
end)
goTo("H * 2")
local refused = ask("textDocument/rename", { newName = "front" })
check("a rename that is refused", (refused.error or refused.err or {}).message and
  (refused.error or refused.err).message:find("is a keyword", 1, true), refused)

-- Completion.
goTo('free";')
local titles = ask("textDocument/completion").result.items
check("completion of titles", #titles == 1 and titles[1].label == "free", titles)
goTo("zone")
local words = {}
for _, item in ipairs(ask("textDocument/completion").result.items) do words[item.label] = true end
check("completion of clauses", words.zone and words.require and not words.ruleset, words)

-- Signature help.
goTo("mid(a, b)", 4)
local signature = ask("textDocument/signatureHelp").result
check("signature help", signature.signatures[1].label == "mid(p, q)", signature)

-- Formatting.
vim.cmd("%s/  tri  a b c;/        tri a    b c ;/")
vim.lsp.buf.formatting_sync(nil, 20000)
check("formatting", text():find("\n  tri  a b c;", 1, true), text())

-- Code lenses and their commands.
local lenses = ask("textDocument/codeLens").result
local test
for _, lens in ipairs(lenses) do
  if lens.command.title == "test" then test = lens.command end
end
check("code lenses", test, lenses)
local result = ask("workspace/executeCommand", { command = test.command, arguments = test.arguments }).result
check("a test run from its lens", result.passed == 1 and result.failed == 0, result)
local picture = vim.fn.getcwd() .. "/free.svg"
result = ask("workspace/executeCommand", { command = "af2.draw", arguments = {
  { uri = vim.uri_from_bufnr(buffer), rule = "free", path = picture } } }).result
check("a picture drawn from a command", vim.fn.filereadable(picture) == 1, result)

-- Outline and folds.
check("document symbols", #ask("textDocument/documentSymbol").result == 5, nil)
check("folding ranges", #ask("textDocument/foldingRange").result > 0, nil)

-- The unsaved text of an imported file.
vim.cmd("split lib.af2")
vim.lsp.buf_attach_client(0, id)
vim.cmd("%s/HALF/THIRD/")
waitFor("an error because of an unsaved import", function() return #diagnostics() > 0 end)

client.stop()
waitFor("the end of the server", function() return exited ~= nil end)
check("the server ends with 0", exited == 0, exited)
say("all is well")
vim.cmd("qall!")
