"""What the rows of run_corpus.py have in common, and what changed between two runs."""

import re

NUMBER = r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?"


def cause_of(row) -> str:
    """The reason without names of files, ids, places and numbers, so that equal causes have equal texts."""
    text = "; ".join(row.faults) or (row.reason if row.status != "complete" else "")
    text = re.sub(r"^(af2: )?(error: )?(\S*/)?[^/ ]+\.\w+: ", "", text)
    text = re.sub(r"^(af2: )?(face \d+( \"[^\"]*\")? \([^)]*\)( failed)?: )", "", text)
    text = re.sub(rf"\({NUMBER}(, {NUMBER})+\)", "(place)", text)
    text = re.sub(rf"(?<![A-Za-z#]){NUMBER}", "N", text)
    return text.replace("|", "/").strip()[:120] or "no reason given"


def table_of_causes(rows: list) -> str:
    """The models that are not complete and sound, by cause, the most frequent first."""
    models = {}
    for row in rows:
        if row.status != "complete" or row.faults:
            models.setdefault((cause_of(row), row.status), []).append(row.model)
    if not models:
        return "All models are complete and sound."
    lines = ["| models | status | cause | for example |", "|---|---|---|---|"]
    for (cause, status), names in sorted(models.items(), key=lambda item: (-len(item[1]), item[0])):
        shown = ", ".join(sorted(names)[:3])
        lines.append(f"| {len(names)} | {status} | {cause} | {shown} |")
    return "\n".join(lines)


def is_sound(row) -> bool:
    return row.status == "complete" and not row.faults


def changes(old: list, new: list) -> str:
    """Models that became better, worse or otherwise different; rows belong together by their models."""
    before = {row.model: row for row in old}
    after = {row.model: row for row in new}
    lines = []

    def tell(head: str, names: list) -> None:
        if names:
            lines.append(f"{head} ({len(names)}):")
            lines.extend(f"  {name}" for name in names)

    both = sorted(before.keys() & after.keys())
    worse = [m for m in both if is_sound(before[m]) and not is_sound(after[m])]
    better = [m for m in both if not is_sound(before[m]) and is_sound(after[m])]
    tell("no longer complete and sound", [f"{m}: {after[m].status}: {cause_of(after[m])}" for m in worse])
    tell("complete and sound now", [f"{m}: was {before[m].status}: {cause_of(before[m])}" for m in better])
    rest = [m for m in both if not is_sound(before[m]) and not is_sound(after[m])]
    tell("another cause", [f"{m}: {cause_of(before[m])} -> {cause_of(after[m])}" for m in rest
                           if (before[m].status, cause_of(before[m])) != (after[m].status, cause_of(after[m]))])
    tell("more faces failed", [f"{m}: {before[m].failed} -> {after[m].failed}" for m in rest
                               if after[m].failed > before[m].failed])
    tell("fewer faces failed", [f"{m}: {before[m].failed} -> {after[m].failed}" for m in rest
                                if after[m].failed < before[m].failed])
    tell("another mesh", [f"{m}: {before[m].elements} -> {after[m].elements} elements" for m in both
                          if is_sound(before[m]) and is_sound(after[m]) and before[m].elements != after[m].elements])
    tell("at least twice as slow, and by a second", [
        f"{m}: {before[m].seconds:.1f} -> {after[m].seconds:.1f} s" for m in both
        if after[m].seconds > 2 * before[m].seconds and after[m].seconds > before[m].seconds + 1])
    tell("only in the earlier run", sorted(before.keys() - after.keys()))
    tell("only in this run", sorted(after.keys() - before.keys()))
    return "\n".join(lines) if lines else "nothing changed"


def has_worse(old: list, new: list) -> bool:
    after = {row.model: row for row in new}
    return any(is_sound(row) and row.model in after and not is_sound(after[row.model]) for row in old)
