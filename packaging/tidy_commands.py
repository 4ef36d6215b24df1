"""Writes a compilation database for clang-tidy: without GCC's precompiled headers, which clang cannot read.

Usage: tidy_commands.py BUILD_FOLDER OUTPUT_FOLDER; also prints, for `tidy_commands.py --preprocess OUTPUT_FOLDER FILE`,
the shell command that preprocesses one file (exit 1 when it is not built)."""
import json
import os
import shlex
import sys

DROPPED = {"-Winvalid-pch", "-fpch-preprocess"}


def without_precompiled_headers(command):
    words = shlex.split(command)
    while words and not words[0].endswith(("g++", "c++", "clang++")):
        words.pop(0)
    kept = []
    skip = False
    for i, word in enumerate(words):
        if skip:
            skip = False
        elif word == "-include" and i + 1 < len(words) and "cmake_pch" in words[i + 1]:
            skip = True
        elif word not in DROPPED:
            kept.append(word)
    return kept


def write(build, output):
    with open(os.path.join(build, "compile_commands.json")) as file:
        entries = json.load(file)
    for entry in entries:
        entry["command"] = shlex.join(without_precompiled_headers(entry["command"]))
    os.makedirs(output, exist_ok=True)
    with open(os.path.join(output, "compile_commands.json"), "w") as file:
        json.dump(entries, file)


def preprocess(output, source):
    with open(os.path.join(output, "compile_commands.json")) as file:
        entries = json.load(file)
    for entry in entries:
        if entry["file"] == source:
            words = shlex.split(entry["command"])
            kept = [words[0], "-E", "-P"]
            skip = False
            for word in words[1:]:
                if skip:
                    skip = False
                elif word in ("-o", "-MF", "-MT"):
                    skip = True
                elif word not in ("-c", "-MD"):
                    kept.append(word)
            print("cd", shlex.quote(entry["directory"]), "&&", shlex.join(kept))
            return 0
    return 1


if sys.argv[1] == "--preprocess":
    sys.exit(preprocess(sys.argv[2], sys.argv[3]))
write(sys.argv[1], sys.argv[2])
