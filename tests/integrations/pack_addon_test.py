# SPDX-License-Identifier: Apache-2.0
"""tools/pack_addon.py: what Blender reads of its archives, without Blender."""
import ast
import os
import sys
import tempfile
import tomllib
import unittest
import zipfile
from unittest import mock

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "tools"))
import pack_addon  # noqa: E402

# What Blender 4.2 requires of a manifest.
REQUIRED = ("schema_version", "id", "version", "name", "tagline", "maintainer", "type", "blender_version_min", "license")


class Archives(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.extension, self.legacy = pack_addon.pack(self.folder.name)

    def files(self, path):
        with zipfile.ZipFile(path) as archive:
            self.assertIsNone(archive.testzip())
            return {name: archive.read(name) for name in archive.namelist()}

    def test_extension(self):
        files = self.files(self.extension)
        self.assertEqual(set(files), {"__init__.py", "blender_manifest.toml", "LICENSE"})
        manifest = tomllib.loads(files["blender_manifest.toml"].decode())
        for key in REQUIRED:
            self.assertTrue(manifest[key], key)
        self.assertEqual((manifest["id"], manifest["type"]), ("luxel_bake", "add-on"))
        self.assertGreaterEqual(tuple(map(int, manifest["blender_version_min"].split("."))), (4, 2, 0))
        for text in (manifest["tagline"], *manifest["permissions"].values()):
            self.assertLessEqual(len(text), 64)
            self.assertTrue(text[-1].isalnum(), f"'{text}' ends with punctuation")

    def test_legacy(self):
        files = self.files(self.legacy)
        self.assertEqual(set(files), {"luxel_bake/__init__.py", "luxel_bake/LICENSE"})
        # Blender reads bl_info from the first kilobytes, without running the module.
        info = next(ast.literal_eval(item.value) for item in ast.parse(files["luxel_bake/__init__.py"]).body
                    if isinstance(item, ast.Assign) and item.targets[0].id == "bl_info")
        self.assertEqual(info["blender"], (3, 4, 0))

    def test_modules_compile_and_are_the_sources(self):
        with open(os.path.join(ROOT, "integrations", "blender", "luxel_bake.py"), "rb") as file:
            source = file.read()
        modules = {os.path.basename(path): content for path in (self.extension, self.legacy)
                   for name, content in self.files(path).items() if name.endswith(".py")}
        self.assertEqual(len(modules), 2)
        for name, content in modules.items():
            compile(content, name, "exec")
            self.assertEqual(content, source)

    def test_same_sources_same_bytes(self):
        with tempfile.TemporaryDirectory() as again:
            for first, second in zip((self.extension, self.legacy), pack_addon.pack(again)):
                with open(first, "rb") as a, open(second, "rb") as b:
                    self.assertEqual(a.read(), b.read())

    def test_versions(self):
        found = pack_addon.versions()
        self.assertEqual(len(set(found.values())), 1, found)
        with mock.patch.object(pack_addon, "versions", return_value={**found, "bl_info": "9.9.9"}):
            with self.assertRaisesRegex(ValueError, "the versions differ: .*bl_info has 9.9.9"):
                pack_addon.pack(self.folder.name)


if __name__ == "__main__":
    unittest.main()
