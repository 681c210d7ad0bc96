"""playground_server.py PROGRAM SOURCE: what `af2 playground` answers to its page, and to nobody else."""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent / "playground"))
from program import Playground

PROGRAM, SOURCE = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
PLATE = {"domain": "plate", "size": "coarse", "color": "rule", "optimize": "1"}


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=60)


def check_page(server):
    """Every file that the page names is there, and none is elsewhere."""
    page = server.get("")
    assert "<title>AF2 playground</title>" in page
    for name in ("page.css", "main.js", "panels.js", "editor.js", "codemirror/codemirror.min.js"):
        assert f'"{name}"' in page and len(server.get(name)) > 1000, name
    assert "http://" not in page and "https://" not in page


def check_answers(server, text):
    assert server.get("file")["text"] == text
    assert server.answer("diagnostics", text)["diagnostics"] == []
    assert server.answer("checks", text) == {"diagnostics": [], "late": False}

    rules = server.answer("rules", text)
    assert [rule["title"] for rule in rules["rules"]] == ["free", "right", "left", "ahead", "close"], rules
    assert all("<svg" in rule["svg"] for rule in rules["rules"])
    lines = text.splitlines()
    assert all(f'"{rule["title"]}"' in lines[rule["line"] - 1] for rule in rules["rules"])

    tests = server.answer("tests", text)
    assert [test["passed"] for test in tests["tests"]] == [True] * 3 and tests["fault"] == ""
    failing = text.replace('expect rule "right"', 'expect rule "left"')
    failed = [test for test in server.answer("tests", failing)["tests"] if not test["passed"]]
    assert len(failed) == 1 and 'rule "left"' in failed[0]["failures"][0]["expected"], failed
    assert "left" in failed[0]["explanation"], failed


def check_edits(server, text):
    """Another text gives another mesh; a broken one says where."""
    mesh = server.answer("mesh", text, **PLATE)
    assert mesh["fault"] == "" and mesh["withoutRule"] == 0, mesh
    assert sum(maker["count"] for maker in mesh["makers"]) == mesh["elements"] == mesh["svg"].count("<path d=")
    assert mesh == server.answer("mesh", text, **PLATE), "the mesh depends on something else"
    finer = server.answer("mesh", text, **{**PLATE, "size": "medium"})
    assert finer["elements"] > 2 * mesh["elements"]
    colored = server.answer("mesh", text, **{**PLATE, "color": "quality"})
    assert colored["svg"] != mesh["svg"] and colored["makers"] == mesh["makers"]

    without_left = text.replace('  mirror "left";\n', "")
    changed = server.answer("mesh", without_left, **PLATE)
    assert "left" not in [maker["title"] for maker in changed["makers"]] and changed["svg"] != mesh["svg"]
    raw = server.answer("mesh", text, **{**PLATE, "optimize": "0"})
    assert "changed by optimization" not in [maker["title"] for maker in raw["makers"]]

    stuck = server.answer("mesh", text[:text.index("## The next edge")], **PLATE)
    assert stuck["withoutRule"] > 0 and stuck["notes"], stuck
    assert any(maker["title"] == "without a rule: closing" for maker in stuck["makers"]), stuck["makers"]

    broken = text.replace("tri  a b c", "tri  a b d", 1)
    line = broken[:broken.index("tri  a b d")].count("\n")
    found = server.answer("diagnostics", broken)["diagnostics"]
    assert [d["code"] for d in found] == ["AF2-R1"] and found[0]["range"]["start"]["line"] == line, found
    assert server.answer("mesh", broken, **PLATE)["fault"].startswith(f"Line {line + 1}: ")
    assert server.answer("tests", broken)["fault"].startswith(f"Line {line + 1}: ")
    rest = server.answer("rules", broken)["rules"]
    assert "free" not in [rule["title"] for rule in rest] and len(rest) == 4
    assert server.answer("rules", "af2 1;")["fault"] == "The file has no rules."


def check_language(server, text):
    place = text.index("  tri  a b c")
    line = text[:place].count("\n")
    items = server.answer("completion", text[:place] + "  zo\n" + text[place:], line=line, character=4)["items"]
    assert "zone" in [item["label"] for item in items]
    hover = server.answer("hover", text, line=line, character=3)
    assert "tri" in hover["contents"]["value"]
    assert server.post("hover", text, line="x", character=3)[0] == 400


def check_cancelled(server, text):
    """A run that a newer one of the same page overtakes ends early, and says so."""
    for attempt in range(10):  # on a busy machine, the first run may begin after the second has ended
        answers = {}
        slow = threading.Thread(target=lambda: answers.update(
            slow=server.answer("mesh", text, **{**PLATE, "domain": "square", "size": "finest", "page": "2", "run": 1})))
        slow.start()
        time.sleep(0.02 * attempt)
        answers["quick"] = server.answer("mesh", text, **{**PLATE, "page": "2", "run": 2})
        slow.join()
        assert answers["quick"]["elements"] > 0
        if answers["slow"] == {"overtaken": True}:
            return
    raise AssertionError("no run was overtaken")


def check_save(server, path, text):
    """Only the given file is written, and only if nobody else has changed it."""
    before = sorted(os.listdir(path.parent))
    version = server.get("file")["version"]
    assert server.get("state")["version"] == version
    edited = text + "# edited ä\n"
    saved = server.answer("save", edited, basis=version)
    assert saved["changed"] is False and path.read_text(encoding="utf-8") == edited
    assert server.get("state")["version"] == saved["version"] != version

    path.write_text(text + "# by somebody else\n", encoding="utf-8")
    refused = server.answer("save", edited, basis=saved["version"])
    assert refused["changed"] is True and "somebody else" in path.read_text(encoding="utf-8")
    assert server.answer("save", text, basis=saved["version"], overwrite=1)["changed"] is False
    assert path.read_text(encoding="utf-8") == text
    assert sorted(os.listdir(path.parent)) == before


def check_refusals(server, text):
    base, own = server.base, f"http://127.0.0.1:{server.port}"
    plain = {"Origin": own, "Content_Type": "text/plain"}
    ask, body = server.ask, text.encode()
    assert ask("GET", base, Host=f"localhost:{server.port}")[0] == 200
    for host in ("evil.example", f"evil.example:{server.port}", "127.0.0.1", "127.0.0.1:1", None):
        assert ask("GET", base, Host=host)[0] in (400, 403), host
    for path in ("/", "/file", base[:-1], base[:-2] + "0/" if base[-2] != "0" else base[:-2] + "1/", "/" + 32 * "0" + "/",
                 "/../../etc/passwd"):
        status, answer = ask("GET", path)
        assert status == 403 and "token" in answer, (path, status, answer)
    for path in ("../../etc/passwd", "../../../../etc/passwd", "%2e%2e/%2e%2e/etc/passwd", "/etc/passwd", "nothing",
                 "web/main.js", "codemirror/../main.js", "mesh"):
        status, answer = ask("GET", base + path)
        assert status in (403, 404) and "root:" not in answer, (path, status, answer)
    for origin in ("http://evil.example", f"https://127.0.0.1:{server.port}", "null", None):
        assert ask("POST", base + "rules?page=1&run=1", body, **{**plain, "Origin": origin})[0] == 403, origin
    for kind in ("application/json", "multipart/form-data; boundary=x", "application/x-www-form-urlencoded", None):
        assert ask("POST", base + "rules?page=1&run=1", body, **{**plain, "Content_Type": kind})[0] == 415, kind
    for coding in ({"Content_Encoding": "gzip"}, {"Transfer_Encoding": "chunked"}):
        assert ask("POST", base + "rules?page=1&run=1", b"0\r\n\r\n", **{**plain, **coding})[0] == 411, coding
    for method in ("PUT", "DELETE", "OPTIONS", "PATCH"):
        assert ask(method, base + "save", body, **plain)[0] == 405, method
    assert ask("POST", base + "nothing", body, **plain)[0] == 404
    status, answer = ask("POST", base + "rules?page=1&run=1", b"#" * (8 << 20) + b"##", **plain)
    assert status == 413 and "8 MiB" in answer, (status, answer)
    for wrong in ({"run": "x"}, {"domain": "torus"}, {"size": "0.001"}):
        status, answer = server.post("mesh", text, **{**PLATE, **wrong})
        assert status == 400 and next(iter(wrong)) in answer, (wrong, status, answer)


def check_large_text(server):
    """As large as a text may be: the parser says what is wrong with it."""
    found = server.answer("diagnostics", "#" * (8 << 20))["diagnostics"]
    assert found, "a text without rules has a problem"


def check_runaway(server, text):
    """Rules that never come to an end are stopped, and the server answers meanwhile."""
    tiny = text.replace("H * max(0.2, 1.1 - 0.1*q)", "0.004").replace("accept   score < 2 + 0.5*q^2;", "")
    begun = time.monotonic()
    answer = server.answer("mesh", tiny, domain="disc", size="medium", color="rule", optimize="1")
    assert time.monotonic() - begun < 40, "the mesh was not stopped"
    assert answer["fault"] or answer["notes"], {k: v for k, v in answer.items() if k != "svg"}


def check_imports(folder):
    """A change of an imported file is seen."""
    library, main = folder / "lib.af2", folder / "main.af2"
    library.write_text("af2 1;\nconst H = 0.8;\n")
    main.write_text('af2 1;\nimport "lib.af2" as lib;\nruleset "m" { elements tri; }\n'
                    'rule "any" quality 1 {\n  new c = mid(a, b) + (0, lib.H);\n  zone a, b, c;\n  tri a b c;\n}\n')
    with Playground(PROGRAM, main) as server:
        text = main.read_text()
        assert server.answer("diagnostics", text)["diagnostics"] == []
        before = server.get("state")
        library.write_text("af2 1;\nconst G = 0.8;\n")
        os.utime(library, ns=(1, 10**18))
        assert server.get("state")["imports"] != before["imports"]
        assert server.answer("diagnostics", text)["diagnostics"] != []


def check_watch(path, text):
    with Playground(PROGRAM, path, "--watch") as server:
        assert server.get("file")["watches"] is True
        status, answer = server.post("save", "other", basis=server.get("file")["version"], overwrite=1)
        assert status == 400 and "--watch" in answer and path.read_text(encoding="utf-8") == text
        # A taken port is no port for a second program.
        other = run("playground", path, "--port", server.port)
        assert other.returncode == 1 and f"port {server.port} of 127.0.0.1 cannot be used" in other.stderr, other
        assert server.end(signal.SIGTERM) == 0


def check_usage(folder):
    def refused(code, words, *arguments):
        done = run("playground", *arguments)
        assert done.returncode == code and words in done.stderr and done.stdout == "", (arguments, done)
        assert done.stderr.count("\n") <= 2, done.stderr

    refused(2, "RULES")
    refused(1, "there is no rule file", folder / "none.af2")
    refused(1, "is a directory", folder)
    refused(2, "--port", folder / "mine.af2", "--port", "70000")
    refused(2, "--port", folder / "mine.af2", "--port", "x")
    os.mkfifo(folder / "pipe.af2")
    refused(1, "is not a regular file", folder / "pipe.af2")
    (folder / "latin.af2").write_bytes(b"af2 1; # \xe4\n")
    refused(1, "is not UTF-8", folder / "latin.af2")
    (folder / "long.af2").write_bytes(b"#" * ((8 << 20) + 1))
    refused(1, "8 MiB", folder / "long.af2")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        path = folder / "mine.af2"
        assert run("new", "ruleset", path).returncode == 0
        text = path.read_text(encoding="utf-8")
        with Playground(PROGRAM, path) as server:
            check_page(server)
            check_answers(server, text)
            check_edits(server, text)
            check_language(server, text)
            check_cancelled(server, text)
            check_save(server, path, text)
            check_refusals(server, text)
            check_large_text(server)
            check_runaway(server, text)
            assert server.end(signal.SIGINT) == 0
        check_imports(folder)
        check_watch(path, text)
        check_usage(folder)


main()
