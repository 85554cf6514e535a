"""Writes a folder as a wheel (packaging.python.org, Binary distribution format); wheel.sh calls it.

Of the same files it makes the same bytes.   usage: wheel.py CONTENTS VERSION FOLDER
"""

import base64
import hashlib
import os
import pathlib
import sys
import sysconfig
import zipfile

contents, version, into = pathlib.Path(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3])
tag = "py3-none-" + sysconfig.get_platform().replace("-", "_").replace(".", "_")
about = f"raypro-{version}.dist-info"
texts = {
    "METADATA": f"""Metadata-Version: 2.1
Name: raypro
Version: {version}
Summary: A ray tracer for people who want to understand an image and trust it
License: MIT
Requires-Python: >=3.9
Provides-Extra: arrays
Requires-Dist: numpy; extra == "arrays"
""",
    "WHEEL": f"Wheel-Version: 1.0\nGenerator: raypro {version}\nRoot-Is-Purelib: false\nTag: {tag}\n",
    "entry_points.txt": "[console_scripts]\nraypro = raypro:main\nrayimg = raypro:main\n",
    "LICENSE": pathlib.Path("LICENSE").read_text(encoding="utf-8"),
}
found = sorted(path for path in contents.rglob("*") if path.is_file())
files = [(str(path.relative_to(contents)), path.read_bytes(), os.access(path, os.X_OK)) for path in found]
files += [(f"{about}/{name}", text.encode("utf-8"), False) for name, text in texts.items()]

record = ""
for name, content, _ in files:
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode("ascii")
    record += f"{name},sha256={digest},{len(content)}\n"
record_name = f"{about}/RECORD"
files.append((record_name, f"{record}{record_name},,\n".encode("utf-8"), False))

wheel = into / f"raypro-{version}-{tag}.whl"
earliest = (1980, 1, 1, 0, 0, 0)  # that a zip file can tell
regular_file = 0o100000
with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as packed:
    for name, content, is_program in files:
        entry = zipfile.ZipInfo(name, earliest)
        entry.compress_type = zipfile.ZIP_DEFLATED
        entry.create_system = 3  # Unix, whose modes follow
        entry.external_attr = (regular_file | (0o755 if is_program else 0o644)) << 16
        packed.writestr(entry, content)
