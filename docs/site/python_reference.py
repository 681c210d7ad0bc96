"""The reference of the Python module, from the sources and stubs of python/af2 as they are, as a page of the site."""

import ast
import html
import inspect


def definitions(folder):
    """By name: the classes and functions of the module, with their signatures and texts."""
    found = {}
    for path in sorted([*folder.glob("*.pyi"), *folder.glob("*.py")]):
        for part in ast.parse(path.read_text(encoding="utf-8")).body:
            if isinstance(part, (ast.ClassDef, ast.FunctionDef)):
                found[part.name] = part
    return found


def public_names(folder):
    for part in ast.parse((folder / "__init__.py").read_text(encoding="utf-8")).body:
        if isinstance(part, ast.Assign) and getattr(part.targets[0], "id", "") == "__all__":
            return [name for name in ast.literal_eval(part.value) if not name.startswith("__")]
    return []


def text_of(part):
    return inspect.cleandoc(ast.get_docstring(part) or "")


def signature(function, prefix=""):
    arguments = ast.unparse(function.args).removeprefix("self, ").removeprefix("self")
    result = f" -> {ast.unparse(function.returns)}" if function.returns else ""
    is_property = any(getattr(d, "id", getattr(d, "attr", "")) in ("property", "cached_property")
                      for d in function.decorator_list)
    return f"{prefix}{function.name}" + (result if is_property else f"({arguments}){result}")


def shown(code, text):
    """Docstrings are laid out by hand: indented lines are lists of arguments."""
    text = f"<pre class=\"docstring\">{html.escape(text)}</pre>" if text else ""
    return f"<tr><td><code>{html.escape(code)}</code></td><td>{text}</td></tr>"


def rows(part):
    lines = []
    for member in part.body:
        if isinstance(member, ast.FunctionDef) and (not member.name.startswith("_") or member.name == "__init__"):
            lines.append(shown(signature(member), text_of(member)))
        elif isinstance(member, ast.AnnAssign) and not getattr(member.target, "id", "_").startswith("_"):
            lines.append(shown(ast.unparse(member), ""))
    return "\n<div class=\"members\"><table>\n" + "\n".join(lines) + "\n</table></div>\n" if lines else ""


def page(folder):
    """The text of the page; empty if there is no Python module."""
    if not (folder / "__init__.py").exists():
        return ""
    known = definitions(folder)
    text = "# The module `af2` of Python\n\n[AF2 in Python](../python.md) shows how these are used.\n"
    for name in public_names(folder):
        part = known.get(name)
        if part is None:
            continue
        kind = "class" if isinstance(part, ast.ClassDef) else "function"
        text += f"\n## {kind} `{name}`\n\n"
        if kind == "function":
            text += f"```python\n{signature(part, 'af2.')}\n```\n\n"
        description = text_of(part)
        text += f'<pre class="docstring">{html.escape(description)}</pre>\n' if description else ""
        text += rows(part) if kind == "class" else ""
    return text
