#!/usr/bin/env python3
"""Packs scenes and the files they name into one JSON file for the page.

usage: page/examples.py FOLDER... > examples.json

{"scenes": [{"name", "about", "options"}], "files": {name: text}, "binary": {name: base64}}. A scene's first comment
says what it shows and, behind "Seen with", which options.
"""
import base64
import json
import pathlib
import re
import sys

SCENES = {".scn", ".json", ".yaml", ".yml", ".txt"}


def first_comment(text):
    """The comment a scene begins with, in one line."""
    lines = []
    for line in text.splitlines():
        found = re.match(r"\s*(?:#|//)\s?(.*)", line) or (re.match(r'\s*"(?:comment|about)": "(.*)",?', line))
        if found:
            lines.append(found.group(1))
        elif lines:
            break
    return " ".join(lines)


def options_of(comment):
    """The options behind "Seen with", up to the end of the sentence."""
    found = re.search(r"Seen with (-.*?)(?:\.(?=\s|$)|;|$)", comment)
    return found.group(1).split() if found else []


def main():
    packed = {"scenes": [], "files": {}, "binary": {}}
    for file in (file for folder in sys.argv[1:] for file in sorted(pathlib.Path(folder).rglob("*"))):
        name = file.as_posix()
        if file.is_dir() or "thumbnails" in file.parts or file.suffix == ".md":
            continue
        data = file.read_bytes()
        try:
            packed["files"][name] = data.decode()
        except UnicodeDecodeError:
            packed["binary"][name] = base64.b64encode(data).decode()
            continue
        if file.suffix in SCENES:
            comment = first_comment(packed["files"][name])
            about = re.sub(r"\s*Seen with .*", "", comment)
            packed["scenes"].append({"name": name, "about": about, "options": options_of(comment)})
    print(json.dumps(packed, ensure_ascii=False, separators=(",", ":")))


main()
