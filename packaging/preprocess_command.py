"""Prints the shell command that preprocesses one file as the build compiles it; exit 1 when it is not built."""
import json
import shlex
import sys

for entry in json.load(open(sys.argv[1])):
    if entry["file"] == sys.argv[2]:
        words = shlex.split(entry["command"])
        while words and not words[0].endswith(("g++", "c++", "clang++")):
            words.pop(0)
        kept = [words[0], "-E", "-P"]
        skip = False
        for word in words[1:]:
            if skip:
                skip = False
            elif word in ("-o", "-c", "-MF", "-MT"):
                skip = word != "-c"
            elif word not in ("-MD", "-fpch-preprocess", "-Winvalid-pch"):
                kept.append(word)
        print("cd", shlex.quote(entry["directory"]), "&&", shlex.join(kept))
        sys.exit(0)
sys.exit(1)
