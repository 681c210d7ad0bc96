"""The errors that need more than a text. `InputError` and `GeometryError` are those of the C++ library."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Sequence

from . import _af2

if TYPE_CHECKING:
    from ._mesh import Mesh


class RuleError(ValueError):
    """A rule file has errors. The text is what the program af2 prints: each error with its line and a caret.

    Attributes:
        diagnostics: the errors, and warnings beside them, with `code`, `severity`, `message`, `file`, `line`, `column`,
            `help`, `notes` and `edits`.
    """

    def __init__(self, diagnostics: Sequence[Any]):
        self.diagnostics = list(diagnostics)
        errors = [d for d in self.diagnostics if d.severity == "error"] or self.diagnostics
        super().__init__(_af2.pretty(errors).rstrip("\n"))

    def __reduce__(self):
        return (ValueError, (str(self),))  # diagnostics stay in the process that has loaded the rules


class MeshError(RuntimeError):
    """A mesh is not complete: faces failed, or it lacks what was asked for. The text lists why.

    Attributes:
        mesh: the mesh of the faces that did not fail.
        problems: the reasons, one text each.
    """

    def __init__(self, mesh: "Mesh"):
        self.mesh = mesh
        self.problems = mesh.problems
        shown = self.problems[:10]
        if len(self.problems) > len(shown):
            shown.append(f"and {len(self.problems) - len(shown)} more")
        super().__init__("; ".join(shown) + ". With allow_incomplete=True, af2.mesh returns the rest of the mesh.")

    def __reduce__(self):
        return (RuntimeError, (str(self),))
