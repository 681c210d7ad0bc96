"""The blocks of code in the documentation: for the tests that run them and for the site that draws them."""

import re

FENCE = re.compile(r"^```(\w*)([^\n]*)\n(.*?)^```$", re.M | re.S)
FREE_RULE = 'rule "any" quality 1 {\n  new c = mid(a, b) + (0, 0.866);\n  zone a, b, c;\n  tri a b c;\n'


def completed(text):
    """The whole rule file that an excerpt stands for."""
    if text.startswith("af2 "):
        return text
    if text.startswith("meta"):
        text = FREE_RULE + text + "}\n"
    if not re.search(r"^ruleset ", text, re.M):
        text += 'ruleset "example" { elements tri, quad; }\n'
    if not re.search(r"^(rule|use) ", text, re.M):
        text += FREE_RULE + "}\n"
    return "af2 1;\n" + text
