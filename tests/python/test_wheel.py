"""script/wheel.sh: a wheel whose RECORD is true, and which renders from where it is unpacked."""

import base64
import csv
import hashlib
import io
import os
import pathlib
import stat
import subprocess
import sys
import tempfile
import unittest
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ["RAYPRO"]).parent


class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        made = tempfile.TemporaryDirectory()
        cls.addClassCleanup(made.cleanup)
        cls.folder = pathlib.Path(made.name)
        subprocess.run(["sh", ROOT / "script/wheel.sh", BUILD, cls.folder], check=True, stdout=subprocess.DEVNULL)
        (cls.wheel,) = cls.folder.glob("raypro-*-py3-none-*.whl")

    def test_its_record_names_every_file_with_its_hash(self):
        with zipfile.ZipFile(self.wheel) as packed:
            (record,) = (name for name in packed.namelist() if name.endswith(".dist-info/RECORD"))
            rows = list(csv.reader(io.TextIOWrapper(packed.open(record), "utf-8")))
            files = [name for name in packed.namelist() if not name.endswith("/")]
            self.assertEqual(sorted(row[0] for row in rows), sorted(files))
            for name, digest, size in rows:
                if name == record:
                    continue
                content = packed.read(name)
                found = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
                self.assertEqual((digest, size), ("sha256=" + found, str(len(content))), name)

    def test_it_renders_where_it_is_unpacked(self):
        site = self.folder / "site"
        with zipfile.ZipFile(self.wheel) as packed:
            packed.extractall(site)
            for entry in packed.infolist():  # extractall forgets what pip keeps
                if entry.filename.startswith("raypro_programs/") and not entry.is_dir():
                    self.assertEqual(stat.S_IMODE(entry.external_attr >> 16) & 0o111, 0o111, entry.filename)
                    (site / entry.filename).chmod(0o755)
        program = (
            "import raypro; image = raypro.render('scenes/hello.scn', width=8, height=8); image._repr_png_(); "
            "print(raypro.__file__, raypro._find('raypro'), raypro._find('rayimg'), image.width)"
        )
        environment = {"PATH": "/usr/bin:/bin", "PYTHONPATH": str(site), "PYTHONDONTWRITEBYTECODE": "1"}
        done = subprocess.run(
            [sys.executable, "-c", program], cwd=ROOT, env=environment, check=True, stdout=subprocess.PIPE, text=True
        )
        names = ("raypro.py", "raypro_programs/raypro", "raypro_programs/rayimg")
        self.assertEqual(done.stdout.split(), [*(str(site.resolve() / name) for name in names), "8"])


if __name__ == "__main__":
    unittest.main()
