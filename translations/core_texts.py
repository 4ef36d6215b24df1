#!/usr/bin/env python3
"""Collects what core/ says to people, for the studio's translations.

core/ knows no languages: its findings, errors and steps are English. The studio recognises them by their wording, the
numbers and names in them aside (ui/common/core_text.h). This script reads the wordings off the sources, so that none is
forgotten, and writes the table. A message is a string literal with words in it; {} of fmt and what is joined to a literal
by + become %1, %2 ... Names in the rigs and skeletons that we ship are collected too (ui/common/shown_names.h).

core_texts.py            writes ui/common/core_texts.h
core_texts.py --check    fails, naming the texts, when that file does not fit the sources
"""
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLE = ROOT / "ui/common/core_texts.h"
# Whose words a user of the studio meets. What only the command line can bring about stays English.
FOLDERS = ["base", "acquire", "decode", "body", "calibrate", "estimate", "motion", "interchange", "take", "solve"]
# Not for people: keys, names of settings, what the program says to other programs.
SKIPPED = re.compile(
    r"^(WAVE|RIFF|schema |Producer |Lcl |MOTION\n|CHANNELS |End Site\n|Kaydara |FBX is little|glTF is little)|\.json$|^[\w.-]+\.[a-z]+$"
)
LITERAL = r'"(?:[^"\\\n]|\\.)*"'


def without_comments(text):
    pattern = re.compile(rf"({LITERAL}|'(?:[^'\\]|\\.)')|//[^\n]*|/\*.*?\*/", re.S)
    text = re.sub(r"(?<=\d)'(?=\d)", "", text)
    # A quotation mark as a character begins no text.
    return pattern.sub(lambda m: "' '" if m.group(1) == "'\"'" else m.group(1) or " ", text)


def unescaped(literals):
    joined = "".join(one[1:-1] for one in re.findall(LITERAL, literals))
    return joined.replace('\\"', '"').replace("\\\\", "\\").replace("\\n", "\n")


def operand_end(text, at):
    """Where an operand of + ends that begins at `at`."""
    depth = 0
    while at < len(text):
        if text[at] == '"':
            at = re.compile(LITERAL).match(text, at).end()
            continue
        if text[at] in "([{":
            depth += 1
        elif text[at] in ")]}":
            if depth == 0:
                return at
            depth -= 1
        elif depth == 0 and text[at] in "+,;?:" and text[at : at + 2] != "::" and text[at - 1 : at + 1] != "::":
            return at
        at += 1
    return at


def messages(text):
    group = re.compile(rf"{LITERAL}(?:\s*{LITERAL})*")
    at = 0
    while found := group.search(text, at):
        at = found.end()
        wording = unescaped(found.group())
        before = text[: found.start()].rstrip()
        # std::string("...") + x
        if re.search(r"std::string\($", before) and re.match(r"\s*\)\s*\+", text[at:]):
            at = text.index(")", at) + 1
        elif before.endswith("+"):
            wording = "{}" + wording
        while plus := re.compile(r"\s*\+\s*").match(text, at):
            start = plus.end()
            literal = group.match(text, start)
            if literal:
                wording += unescaped(literal.group())
                at = literal.end()
            else:
                wording += "{}"
                at = operand_end(text, start)
        yield wording


def template(wording):
    count = 0

    def place(match):
        nonlocal count
        if match.group() in ("{{", "}}"):
            return match.group()[0]
        count += 1
        return f"%{count}"

    return re.sub(r"\{\{|\}\}|\{[^{}]*\}", place, wording)


def for_people(text):
    words = re.sub(r"%\d+", " ", text)
    return " " in text.strip() and re.search(r"[a-z]{3}", words) is not None and not SKIPPED.search(text)


def collected():
    found = {}
    for folder in FOLDERS:
        for path in sorted((ROOT / "core" / folder).glob("*.cpp")) + sorted((ROOT / "core" / folder).glob("*.h")):
            text = re.sub(r"^\s*#.*$|\bassert\([^;]*;", "", without_comments(path.read_text("utf-8")), flags=re.M)
            for wording in messages(text):
                made = template(wording)
                if for_people(made):
                    found.setdefault(made, folder)
    return found


# What people read in the rigs and skeletons that we ship.
FILES = ["resources/rigs", "resources/skeletons"]
KEYS = ["name", "title", "instruction"]


def shipped_names():
    found = {}

    def look(node, depth):
        for key, value in node.items() if isinstance(node, dict) else enumerate(node):
            if isinstance(value, (dict, list)):
                look(value, depth + 1)
            elif key in KEYS and isinstance(value, str) and (depth > 0 or key != "name"):
                found[value.replace("_", " ")] = True

    for folder in FILES:
        for path in sorted((ROOT / folder).glob("*.json")):
            look(json.loads(path.read_text("utf-8")), 0)
    return list(found)


def quoted(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'


def table(found):
    lines = [
        "/// What core/ says to people. Written by translations/core_texts.py from the sources of core/; not by hand.",
        "#pragma once",
        "",
        "#include <QtGlobal>",
        "",
        "// clang-format off",
        "namespace limbwave::ui {",
        "",
        "inline constexpr const char* kCoreTexts[] = {",
    ]
    folder = ""
    for text, home in found.items():
        if home != folder:
            folder = home
            lines.append(f"    // core/{folder}")
        lines.append(f'    QT_TRANSLATE_NOOP("Core", {quoted(text)}),')
    lines += ["};", "", "inline constexpr const char* kShippedNames[] = {"]
    lines += [f'    QT_TRANSLATE_NOOP("Names", {quoted(name)}),' for name in shipped_names()]
    lines += ["};", "", "}  // namespace limbwave::ui"]
    return "\n".join(lines) + "\n"


def main():
    found = collected()
    wanted = table(found)
    if "--check" not in sys.argv:
        TABLE.write_text(wanted, "utf-8")
        return 0
    present = TABLE.read_text("utf-8") if TABLE.exists() else ""
    if present == wanted:
        return 0
    for line in sorted(set(wanted.splitlines()) ^ set(present.splitlines())):
        print(("missing: " if line in wanted else "gone: ") + line)
    print("run translations/core_texts.py, then `ninja update_translations`, and translate what is new")
    return 1


if __name__ == "__main__":
    sys.exit(main())
