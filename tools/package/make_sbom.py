#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Lists the components of an artefact of Luxel, as SPDX 2.3 in JSON: make_sbom.py --help.

Compiled in: the Debian packages whose headers or static libraries the build read, as ninja recorded them, and the npm
packages of the HTML page. Linked: the packages of the shared libraries that the programs load. Versions are dpkg's and
licences those of /usr/share/doc/*/copyright. The result depends on nothing else but SOURCE_DATE_EPOCH.
"""
import argparse
import datetime
import functools
import json
import os
import re
import shutil
import subprocess
import sys
import uuid

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from debian_licences import copyright_file, licence_of  # noqa: E402

COMMON_LICENCES = "/usr/share/common-licenses"
FIELDS = ["Package", "Version", "Architecture", "source:Package", "source:Version", "Homepage"]


def output_of(*command, folder="."):
    return subprocess.run(command, cwd=folder, check=True, capture_output=True, text=True).stdout


@functools.cache
def owners():
    """Path -> package, of all files of all installed packages."""
    found = {}
    for line in output_of("dpkg-query", "-W", "-f", "${Package}\n${db-fsys:Files}").splitlines():
        if line.startswith(" "):
            found[line.strip()] = package
        elif line:
            package = line
    return found


def packages_of(paths):
    """The Debian packages that own these files, each with its dpkg fields; files of no package are ignored."""
    names = set()
    for path in (os.path.realpath(path) for path in paths):
        # Since /usr and / were merged, dpkg may know a library by either name.
        names.add(owners().get(path) or owners().get(path[len("/usr"):]))
    names = sorted(names - {None})
    if not names:
        return {}
    form = "\t".join("${" + field + "}" for field in FIELDS) + "\n"
    rows = (line.split("\t") for line in output_of("dpkg-query", "-W", "-f", form, *names).splitlines())
    return {row[0]: dict(zip(FIELDS, row)) for row in rows}


def inputs_of(build, targets):
    """Files outside of the build folder that ninja read to make the targets: headers and static libraries."""
    inputs = set(output_of("ninja", "-t", "inputs", *targets, folder=build).splitlines())
    files = {path for path in inputs if path.startswith("/") and path.endswith(".a")}
    wanted = False
    for line in output_of("ninja", "-t", "deps", folder=build).splitlines():
        if line and not line[0].isspace():
            wanted = line.split(": #deps")[0] in inputs
        elif wanted and line.strip():
            files.add(line.strip())
    return files


def is_program(path):
    if os.path.islink(path) or not os.path.isfile(path):
        return False
    with open(path, "rb") as file:
        return file.read(4) == b"\x7fELF"


def libraries_of(root):
    """The shared libraries that the programs below a folder load, as they are installed on this machine."""
    libraries = set()
    for folder, _, files in os.walk(root):
        for path in (os.path.join(folder, file) for file in files):
            if is_program(path):
                # Without the libraries that lie beside the program: those have packages of their own here.
                listed = output_of("objdump", "-p", path)
                libraries |= set(re.findall(r"NEEDED +(\S+)", listed))
    return libraries


def closure_of(names):
    """The paths of these shared libraries and of those that they need in turn."""
    cache = dict(re.findall(r"^\t(\S+) \(libc6,x86-64.*\) => (\S+)$", output_of("/sbin/ldconfig", "-p"), re.M))
    paths, waiting = set(), [cache[name] for name in sorted(names) if name in cache]
    while waiting:
        path = waiting.pop()
        if path in paths:
            continue
        paths.add(path)
        waiting += [found for found in re.findall(r"=> (/\S+) \(", output_of("ldd", path)) if found not in paths]
    return paths


def page_packages(build):
    """The npm packages in the HTML page: those of web/package.json but the bundler."""
    template = os.path.join(build, "page", "page_template.cpp")
    if not os.path.isfile(template):
        return []
    with open(template, encoding="utf-8") as file:
        if "// no page" in file.read(200):
            return []
    modules = os.path.join(build, "page", "node_modules")
    with open(os.path.join(build, "page", "package.json"), encoding="utf-8") as file:
        names = [name for name in json.load(file)["dependencies"] if name != "esbuild"]
    found = []
    for name in sorted(names):
        with open(os.path.join(modules, name, "package.json"), encoding="utf-8") as file:
            found.append((json.load(file), os.path.join(modules, name, "LICENSE")))
    return found


def element(name):
    return "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", name)


def debian_package(fields, licences):
    text, extracted = licence_of(fields["Package"])
    for licence in extracted:
        licences.setdefault(licence["licenseId"], licence)
    package = {"SPDXID": element("Debian-" + fields["Package"]), "name": fields["Package"], "versionInfo": fields["Version"],
               "supplier": "Organization: Debian", "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
               "licenseConcluded": "NOASSERTION", "licenseDeclared": text,
               "sourceInfo": f"Debian source package {fields['source:Package']} {fields['source:Version']}",
               "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                                 "referenceLocator": f"pkg:deb/debian/{fields['Package']}@{fields['Version']}"
                                                     f"?arch={fields['Architecture']}"}]}
    if text == "NOASSERTION":
        package["licenseComments"] = f"See /usr/share/doc/{fields['Package']}/copyright, which is not machine-readable."
    if fields["Homepage"]:
        package["homepage"] = fields["Homepage"]
    return package


def npm_package(description):
    return {"SPDXID": element("npm-" + description["name"]), "name": description["name"],
            "versionInfo": description["version"], "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
            "licenseConcluded": "NOASSERTION", "licenseDeclared": description["license"],
            "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                              "referenceLocator": f"pkg:npm/{description['name']}@{description['version']}"}]}


def document(arguments, compiled, linked, page):
    licences = {}
    own = {"SPDXID": element(arguments.name), "name": arguments.name, "versionInfo": arguments.version,
           "supplier": "Organization: The Luxel authors", "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
           "licenseConcluded": "Apache-2.0", "licenseDeclared": "Apache-2.0"}
    packages = [own]
    relations = [("SPDXRef-DOCUMENT", "DESCRIBES", own["SPDXID"])]
    for group, relation in [(linked, "DYNAMIC_LINK"), (compiled, "STATIC_LINK")]:
        for name in sorted(group):
            packages.append(debian_package(group[name], licences))
            relations.append((own["SPDXID"], relation, packages[-1]["SPDXID"]))
    for description, _ in page:
        packages.append(npm_package(description))
        relations.append((own["SPDXID"], "CONTAINS", packages[-1]["SPDXID"]))
    seconds = int(os.environ.get("SOURCE_DATE_EPOCH") or datetime.datetime.now().timestamp())
    created = datetime.datetime.fromtimestamp(seconds, datetime.timezone.utc)
    content = {"packages": packages,
               "relationships": [dict(zip(("spdxElementId", "relationshipType", "relatedSpdxElement"), relation))
                                 for relation in relations],
               "hasExtractedLicensingInfos": [licences[name] for name in sorted(licences)]}
    identity = uuid.uuid5(uuid.NAMESPACE_OID, json.dumps(content, sort_keys=True))
    return {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT",
            "name": f"{arguments.name}-{arguments.version}", "documentNamespace": f"urn:uuid:{identity}",
            "creationInfo": {"created": f"{created:%Y-%m-%dT%H:%M:%SZ}",
                             "creators": ["Organization: The Luxel authors", "Tool: luxel-make-sbom"]}, **content}


def copy_licences(names, page, folder):
    """The licence texts of what is compiled in or travels along, with the common licences that they refer to."""
    os.makedirs(folder, exist_ok=True)
    common = set()
    for name in names:
        source = copyright_file(name)
        if source is None:
            sys.exit(f"make_sbom.py: the package {name} has no copyright file below /usr/share/doc: install it again")
        shutil.copyfile(source, os.path.join(folder, name + ".txt"))
        with open(source, encoding="utf-8", errors="replace") as file:
            common |= {name.rstrip(".") for name in re.findall(COMMON_LICENCES + r"/([\w.-]+)", file.read())}
    for name in common:
        if os.path.isfile(os.path.join(COMMON_LICENCES, name)):
            shutil.copyfile(os.path.join(COMMON_LICENCES, name), os.path.join(folder, f"common-{name}.txt"))
    for description, text in page:
        shutil.copyfile(text, os.path.join(folder, description["name"] + ".txt"))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--name", required=True, help="of the artefact")
    parser.add_argument("--version", required=True)
    parser.add_argument("--build", required=True, help="the build folder, of the generator Ninja")
    parser.add_argument("--targets", nargs="+", required=True, help="what was built there for the artefact")
    parser.add_argument("--root", required=True, help="the folder that becomes the artefact")
    parser.add_argument("--output", required=True)
    parser.add_argument("--licences", help="folder for the licence texts of what is compiled in")
    parser.add_argument("--bundled", action="store_true", help="the shared libraries travel along: their licence texts too")
    arguments = parser.parse_args()
    linked = packages_of(closure_of(libraries_of(arguments.root)))
    sources = {fields["source:Package"] for fields in linked.values()}
    # The headers of a library that is linked need no entry of their own.
    compiled = {name: fields for name, fields in packages_of(inputs_of(arguments.build, arguments.targets)).items()
                if fields["source:Package"] not in sources and fields["source:Package"] != "linux"}
    page = page_packages(arguments.build)
    with open(arguments.output, "w", encoding="utf-8") as file:
        json.dump(document(arguments, compiled, linked, page), file, indent=1, ensure_ascii=False)
        file.write("\n")
    if arguments.licences:
        copy_licences([*compiled, *(linked if arguments.bundled else [])], page, arguments.licences)


if __name__ == "__main__":
    main()
