"""Colours of rule files on the site: a lexer for Pygments, with the words of the grammar that editors use."""

import json
import pathlib
import re

from pygments.lexer import RegexLexer, words
from pygments.token import Comment, Keyword, Name, Number, Operator, Punctuation, String

__all__ = ["Af2Lexer"]
GRAMMAR = pathlib.Path(__file__).parents[2] / "examples" / "vscode-af2" / "syntaxes" / "af2.tmLanguage.json"


def words_of(kind):
    """All words in the expressions that the grammar gives this kind of name."""
    found = set()

    def look(part):
        if isinstance(part, dict):
            if part.get("name", "").startswith(kind):
                found.update(re.findall(r"(?<![\\\w])[a-z_]+\d?(?![\w\]])", re.sub(r"\\[a-zA-Z]", " ", part.get("match", ""))))
            for value in part.values():
                look(value)
        elif isinstance(part, list):
            for value in part:
                look(value)

    look(json.loads(GRAMMAR.read_text(encoding="utf-8")))
    return sorted(found)


class Af2Lexer(RegexLexer):
    name = "AF2 rules"
    aliases = ["af2"]
    filenames = ["*.af2"]
    tokens = {
        "root": [
            (r"##.*$", Comment.Special),
            (r"#.*$", Comment.Single),
            (r'"(\\.|[^"\\])*"', String),
            (r"(?<![\w.])(\d+(\.\d+)?|\.\d+)([eE][-+]?\d+)?(deg\b)?", Number),
            (words("af2 ruleset rule test property import use const def metric template extern function shape".split(),
                   prefix=r"\b", suffix=r"\b"), Keyword.Declaration),
            (words(words_of("keyword.control") or ["front"], prefix=r"\b", suffix=r"\b(?!\s*\()"), Keyword),
            (words(words_of("keyword.other") + ["and", "or", "not", "in", "any"], prefix=r"\b", suffix=r"\b"), Keyword),
            (r"[A-Za-z_]\w*(?=\s*\()", Name.Function),
            (r"[A-Za-z_]\w*", Name),
            (r"->|=>|<=|>=|==|!=|\.\.|[-+*/^|&=<>~]", Operator),
            (r"[{}(),;:.\[\]]", Punctuation),
            (r"\s+", Punctuation),
        ]
    }
