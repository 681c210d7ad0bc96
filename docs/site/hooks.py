"""For MkDocs: rule files get their colours."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))


def on_startup(**_):
    import pygments.lexers
    from pygments.lexers import _mapping

    entry = ("af2_lexer", "AF2 rules", ("af2",), ("*.af2",), ())
    for table in (pygments.lexers.LEXERS, _mapping.LEXERS):
        table["Af2Lexer"] = entry
