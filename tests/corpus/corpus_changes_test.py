"""Causes and changes of made-up rows; and a real run over a folder, twice: corpus_changes_test.py AF2 SOURCE."""

import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

AF2, SOURCE = sys.argv[1], Path(sys.argv[2])
sys.path.insert(0, str(SOURCE / "tests" / "corpus"))
try:
    from corpus_changes import cause_of, changes, has_worse, table_of_causes
    from run_corpus import Row
except ImportError as missing:
    print(f"{missing}; this test needs python3-numpy")
    sys.exit(77)


def row(model, status="complete", **more):
    return Row(model=model, status=status, **more)


stuck = row("a", "partial", reason="face 7 (plane): the front got stuck at (1, 2.5, -3e-4) after 12 elements")
also = row("b", "partial", reason='af2: face 12 "lid" (cylinder) failed: the front got stuck at (0, 0, 1) after 3 elements')
assert cause_of(stuck) == cause_of(also) == "the front got stuck at (place) after N elements", cause_of(also)
assert cause_of(row("c", "refused", reason="/tmp/x/part.step: is empty")) == "is empty"
causes = table_of_causes([stuck, also, row("good")])
assert "| 2 | partial | the front got stuck at (place) after N elements | a, b |" in causes, causes
assert table_of_causes([row("good")]) == "All models are complete and sound."

old = [row("a"), stuck.__class__(**{**stuck.__dict__, "model": "b"}), row("c", elements=10), row("gone")]
new = [row("a", "partial", reason="face 1 (plane): no"), row("b"), row("c", elements=11), row("new")]
told = changes(old, new)
for text in ("no longer complete and sound (1):\n  a: partial: no", "complete and sound now (1):\n  b: was partial",
             "c: 10 -> 11 elements", "only in the earlier run (1):\n  gone", "only in this run (1):\n  new"):
    assert text in told, told
assert has_worse(old, new) and not has_worse(new, new)
assert changes(old, old) == "nothing changed"

with tempfile.TemporaryDirectory() as temporary:
    folder = Path(temporary) / "models"
    folder.mkdir()
    shutil.copy(SOURCE / "examples/models/cylinder.step", folder)
    (folder / "empty.step").write_text("")

    def run(*more):
        command = [sys.executable, SOURCE / "tests/corpus/run_corpus.py", "--af2", AF2, folder, *more]
        return subprocess.run(command, capture_output=True, text=True, check=False)

    first = run("--json", Path(temporary) / "old.json")
    assert first.returncode == 0, first.stdout + first.stderr
    assert "| 1 | refused | is empty; export the model again | empty |" in first.stdout, first.stdout
    again = run("--compare", Path(temporary) / "old.json")
    assert again.returncode == 0 and "nothing changed" in again.stdout, again.stdout + again.stderr
    rows = json.loads((Path(temporary) / "old.json").read_text())
    for one in rows:
        one.update(status="complete", faults=[])
    (Path(temporary) / "old.json").write_text(json.dumps(rows))
    worse = run("--compare", Path(temporary) / "old.json")
    assert worse.returncode == 1 and "no longer complete and sound (1):\n  empty" in worse.stdout, worse.stdout
print("all as expected")
