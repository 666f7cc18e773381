# SPDX-License-Identifier: Apache-2.0
"""debian_licences.py and make_sbom.py on small copyright files and one program: what is planted is in the list."""
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

TOOLS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tools", "package")
sys.path.insert(0, TOOLS)
import debian_licences  # noqa: E402
import make_sbom  # noqa: E402

COPYRIGHT = """Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/

Files: *
License: Expat

Files: src/a.c
License: GPL-2+ or Own

Files: debian/*
License: GPL-3+

License: Own
 Do as
 .
 you like.
"""


class Licences(unittest.TestCase):
    def licence_of(self, text):
        with tempfile.NamedTemporaryFile("w", suffix=".txt") as file:
            file.write(text)
            file.flush()
            with mock.patch.object(debian_licences, "copyright_file", return_value=file.name):
                return debian_licences.licence_of("planted")

    def test_names_of_debian_become_those_of_spdx(self):
        expression, extracted = self.licence_of(COPYRIGHT)
        self.assertEqual(expression, "MIT AND (GPL-2.0-or-later OR LicenseRef-Debian-Own)")
        self.assertEqual([(e["licenseId"], e["extractedText"]) for e in extracted],
                         [("LicenseRef-Debian-Own", "Do as\n.\nyou like.")])

    def test_a_comma_binds_less_than_or(self):
        expression, _ = self.licence_of("Format: x\n\nFiles: *\nLicense: LGPL-2.1 or Zlib, and ISC\n")
        self.assertEqual(expression, "(LGPL-2.1-only OR Zlib) AND (ISC)")

    def test_free_text_is_no_licence(self):
        self.assertEqual(self.licence_of("This package was made by hand.\n"), ("NOASSERTION", []))


class Document(unittest.TestCase):
    FIELDS = {"Package": "libplanted1", "Version": "1:2-3", "Architecture": "amd64", "source:Package": "planted",
              "source:Version": "1:2-3", "Homepage": ""}

    def document(self):
        arguments = mock.Mock(version="0.1.0")
        arguments.name = "luxel"
        with mock.patch.object(make_sbom, "licence_of", return_value=("NOASSERTION", [])), \
                mock.patch.dict(os.environ, SOURCE_DATE_EPOCH="86400"):
            return make_sbom.document(arguments, {}, {"libplanted1": self.FIELDS},
                                      [({"name": "three", "version": "1.0", "license": "MIT"}, "")])

    def test_each_part_is_listed_and_related(self):
        document = self.document()
        self.assertEqual(document["spdxVersion"], "SPDX-2.3")
        self.assertEqual(document["creationInfo"]["created"], "1970-01-02T00:00:00Z")
        names = {package["SPDXID"]: package["name"] for package in document["packages"]}
        related = [(r["relationshipType"], names.get(r["relatedSpdxElement"])) for r in document["relationships"]]
        self.assertEqual(related, [("DESCRIBES", "luxel"), ("DYNAMIC_LINK", "libplanted1"), ("CONTAINS", "three")])
        self.assertEqual(len(names), len(document["packages"]))
        for package in document["packages"]:
            self.assertRegex(package["SPDXID"], r"^SPDXRef-[A-Za-z0-9.-]+$")
            self.assertIn("downloadLocation", package)
        self.assertEqual(document["packages"][1]["externalRefs"][0]["referenceLocator"],
                         "pkg:deb/debian/libplanted1@1:2-3?arch=amd64")

    def test_it_is_the_same_each_time(self):
        self.assertEqual(json.dumps(self.document()), json.dumps(self.document()))

    @unittest.skipUnless(shutil.which("dpkg-query") and shutil.which("objdump"), "no Debian here")
    def test_a_program_names_the_packages_of_its_libraries(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(shutil.which("objdump"), folder)
            found = make_sbom.packages_of(make_sbom.closure_of(make_sbom.libraries_of(folder)))
        self.assertIn("libc6", found)
        version = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", "libc6"], check=True, capture_output=True, text=True)
        self.assertEqual(found["libc6"]["Version"], version.stdout)


if __name__ == "__main__":
    unittest.main()
