"""Rule sets: from files, from those that AF2 comes with, and from texts."""

from __future__ import annotations

import os
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

from . import _af2
from ._errors import RuleError

Point = Tuple[float, float]


def rule_names() -> List[str]:
    """The rule files that AF2 comes with: "tri/even.af2", "quad/classic.af2", ..."""
    return _af2.shipped_files()


class Rules:
    """A rule set, loaded and without errors. Make it with `af2.load_rules` or `Rules.from_text`.

    It is immutable: threads may use it at once, and to load rules once saves time if many models are meshed.
    """

    def __init__(self, file: Any):
        self._file = file

    @classmethod
    def from_text(cls, text: str, name: str = "<text>", *, check: bool = True) -> "Rules":
        """Loads rules from a text.

        Args:
            text: a whole rule file, which begins with `af2 1;`.
            name: of the text, in messages. Files that it imports are searched in the folder of this name, and then among
                the rules of AF2.
            check: also refuse rules that are wrong at some match, which a short search finds. `False` runs them all
                the same, as `af2 mesh --unchecked` does.

        Raises:
            RuleError: the rules have errors.
        """
        return _checked(_af2.rules_from_text(name, text, check), check)

    @property
    def name(self) -> str:
        """The name of the rule set, as written in the file."""
        return self._file.name

    @property
    def titles(self) -> List[str]:
        """The titles of all rules, mirror images among them, in the order of the rule set."""
        return self._file.titles

    @property
    def makes_quads(self) -> bool:
        """Whether any rule makes quadrilaterals."""
        return self._file.makes_quads

    @property
    def diagnostics(self) -> List[Any]:
        """The warnings about the rules."""
        return self._file.diagnostics

    def test(self, filter: str = "") -> List[Any]:
        """Runs the tests in the rule file, as `af2 test` does.

        Args:
            filter: only tests whose title contains this text.

        Returns:
            Results with `title`, `passed`, `failures` (each with `expected`, `got`, `line`), `rule` (which was applied),
            `score`, `is_property`, `samples`, `explanation`. `str(result)` is what the program prints.
        """
        return self._file.test(filter)

    def evaluate(self, rule: str, match: Optional[Mapping[str, Point]] = None, *, level: int = 1,
                 points: Sequence[Point] = (), segments: Sequence[Tuple[Point, Point]] = (),
                 environment: Optional[Mapping[str, float]] = None) -> Dict[str, Any]:
        """Evaluates one rule at given positions, as `af2 eval` does.

        Args:
            rule: its title.
            match: positions of matched vertices by name, with a at (0, 0), b on the x axis, and the wanted edge length
                as the unit. Other vertices are at their references.
            level: quality level, counted from 1.
            points: places that are tested: are they in the free zone?
            segments: edges that are tested: do they meet the inside of the free zone?
            environment: facts about the surroundings, such as {"h": 0.8, "turn(c)": 120}.

        Returns:
            A dictionary with `refused` (the reason, or "none"), `because`, `matches`, `require`, `new` (positions of
            new vertices), `zones` (corners), `points_in_zone`, `segments_meet_zone`, `score`, `text`.

        Raises:
            InputError: there is no such rule or vertex, or a number is out of range.
        """
        return self._file.evaluate(rule, level, dict(match or {}), list(points), list(segments), dict(environment or {}))

    def __repr__(self) -> str:
        return f"<af2.Rules '{self.name}': {len(self.titles)} rules>"


RulesLike = Union[str, "os.PathLike[str]", Rules, None]


def load_rules(rules: Union[str, "os.PathLike[str]", Rules], *, check: bool = True) -> Rules:
    """Loads rules from a path, a name such as "quad/paving" (see `rule_names`), or a text.

    A string with a line break is a text; any other one is a path if there is such a file, and a name otherwise.

    Args:
        rules: the path, name or text; `Rules` are returned as they are.
        check: as in `Rules.from_text`. The rules of AF2 are not checked again.

    Raises:
        RuleError: the rules have errors.
        InputError: there is neither such a file nor such a name.
    """
    if isinstance(rules, Rules):
        return rules
    if isinstance(rules, str) and "\n" in rules:
        return Rules.from_text(rules, check=check)
    path = os.fspath(rules)
    if os.path.isfile(path):
        return _checked(_af2.load_rules(path, check), check)
    for name in (path, path + ".af2"):
        if name in rule_names():
            return _checked(_af2.shipped_rules(name), check)
    raise _af2.InputError(f"rules={path!r}: there is no such file, and AF2 comes with no rules of this name; "
                          f"it has {', '.join(rule_names())}")


def _checked(file: Any, check: bool) -> Rules:
    if not file.is_usable:
        found = file.diagnostics
        if not any(d.severity == "error" for d in found):
            raise _af2.InputError("the rule file has no rule set with rules; it may be a library for others to import")
        raise RuleError(found)
    if check:
        errors = file.proven_errors()
        if errors:
            raise RuleError(errors)
    return Rules(file)
