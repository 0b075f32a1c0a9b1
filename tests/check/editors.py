# SPDX-License-Identifier: Apache-2.0
"""editors.py GRAMMAR SAMPLES: reads a TextMate grammar that has only patterns with "match", as an editor does, and compares the scopes
of words in lines of examples with SAMPLES: FILE | LINE | TOKEN | SCOPE | VIM GROUP. Prints what differs, and the counts."""
import json
import re
import sys


def load(path):
    with open(path, encoding="utf-8") as file:
        grammar = json.load(file)
    return [(re.compile(rule["match"]), rule["captures"]) for rule in grammar["patterns"]]


def scopes_of(rules, line):
    """The scope of each character of a line. The match that begins first is used; of several, that of the first rule."""
    scopes, at = [""] * len(line), 0
    while at < len(line):
        found = [(m.start(), n, m) for n, (pattern, _) in enumerate(rules) for m in [pattern.search(line, at)] if m and m.end() > m.start()]
        if not found:
            break
        _, n, match = min(found, key=lambda f: f[:2])
        for group, capture in rules[n][1].items():
            for i in range(*match.span(int(group))):
                scopes[i] = capture["name"]
        at = match.end()
    return scopes


def read_samples(path):
    with open(path, encoding="utf-8") as file:
        for row in file:
            if row.strip() and not row.startswith("#"):
                yield [cell.strip() for cell in row.split(" | ")]


def main():
    rules, passed, failed = load(sys.argv[1]), 0, 0
    for path, text, token, scope, _ in read_samples(sys.argv[2]):
        with open(path, encoding="utf-8") as file:
            line = next((line.rstrip("\n") for line in file if line.strip().startswith(text)), None)
        if line is None:
            got = "no such line"
        else:
            at = line.index(text) + text.rindex(token)
            got = "/".join(sorted(set(scopes_of(rules, line)[at:at + len(token)])))
        if got == ("" if scope == "-" else scope + ".smc"):
            passed += 1
        else:
            failed += 1
            print(f"{path}: {text}: {token}: expected {scope}, got {got}")
    print(passed, failed)


main()
