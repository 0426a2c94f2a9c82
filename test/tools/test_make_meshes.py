#!/usr/bin/env python3
"""The shipped meshes are what make_meshes.py writes."""
import pathlib
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / 'scripts'))
import make_meshes  # noqa: E402


class Meshes(unittest.TestCase):
    def check(self, write, shipped, cuboids):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / 'mesh'
            write(path, cuboids)
            self.assertEqual(path.read_text(), (ROOT / shipped).read_text())

    def test_pallet(self):
        self.check(make_meshes.write_stl, 'config/meshes/eur_pallet.stl', make_meshes.eur_pallet())

    def test_crate(self):
        self.check(make_meshes.write_ply, 'test/data/bottle_crate.ply', make_meshes.bottle_crate())


if __name__ == '__main__':
    unittest.main()
