"""Writes the listings of a README, each introduced by its file's name ("`path`:"), into a folder: listings.py README
FOLDER"""
import pathlib
import re
import sys

readme, folder = map(pathlib.Path, sys.argv[1:])
found = re.findall(r"^`([\w/.]+)`:\n\n```\w+\n(.*?)^```$", readme.read_text(encoding="utf-8"), re.M | re.S)
for path, text in found:
    file = folder / path
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")
