# SPDX-License-Identifier: Apache-2.0
"""Hooks that mkdocs.yml names: what the manual's site needs beside what MkDocs does.

- Files outside docs/ to which pages link, such as CONTRIBUTING.md, become pages or files of the site; links to folders
  become text.
- KaTeX is copied from Debian's package libjs-katex, so equations need no network.
- The C++ reference that `./dev reference` made is copied to cpp/, and the nav links to it.
- Search works on pages that are opened from disk, where browsers neither read its index nor start its worker.
"""
import glob
import json
import logging
import os
import posixpath
import re
import shutil

from mkdocs.structure.files import File
from mkdocs.structure.nav import Link

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
DOCS = "docs/"
KATEX = "/usr/share/javascript/katex"
REFERENCE = os.path.join(ROOT, "build", "reference", "html")
FENCE = re.compile(r"(^[ ]*```.*?^[ ]*```[ ]*$)", re.DOTALL | re.MULTILINE)
LINK = re.compile(r"\[([^\[\]]*)\]\(([^()\s:#]+)(#[^()\s]*)?\)")
FROM_DISK = """<script>
if (location.protocol === "file:") document.write('<script src="{}assets/search-from-disk.js"><' + "/script>");
</script>"""
# The worker of the search as text, since a page from disk may start it from a Blob only, and its index as a promise.
SEARCH = """var __search = {{ index: Promise.resolve({index}) }};
(function () {{
  const url = URL.createObjectURL(new Blob([{worker}]));
  const FromServer = window.Worker;
  window.Worker = function () {{ return new FromServer(url); }};
}})();
"""
log = logging.getLogger("mkdocs.manual")


def root_path(page, target):
    """The path from the root of what a page links to; page: its path from the root."""
    return posixpath.normpath(posixpath.join(posixpath.dirname(page), target))


def site_path(path):
    """Where a file of the repository is in the site."""
    return path[len(DOCS):] if path.startswith(DOCS) else path


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def outside_files():
    """The files outside docs/ that pages link to, directly or by other pages outside; paths from the root."""
    pages, found = [DOCS + name for name in os.listdir(os.path.join(ROOT, DOCS)) if name.endswith(".md")], set()
    while pages:
        page = pages.pop()
        for _, target, _ in LINK.findall(FENCE.sub("", read(os.path.join(ROOT, page)))):
            path = root_path(page, target)
            if path in found or path.startswith(DOCS) or not os.path.isfile(os.path.join(ROOT, path)):
                continue
            found.add(path)
            if path.endswith(".md"):
                pages.append(path)
    return found


def on_files(files, config):
    for path in sorted(outside_files()):
        files.append(File(path, ROOT, config["site_dir"], config["use_directory_urls"]))
    return files


def on_page_markdown(markdown, page, config, **_):
    """Links that lead out of docs/ or back, and fences that only the test of the commands understands."""
    in_docs = page.file.abs_src_path.startswith(os.path.join(config["docs_dir"], ""))
    name = (DOCS if in_docs else "") + page.file.src_path

    def site_link(match):
        text, target, anchor = match[1], match[2], match[3] or ""
        path = root_path(name, target)
        if not os.path.isfile(os.path.join(ROOT, path)):
            return text if os.path.isdir(os.path.join(ROOT, path)) else match[0]
        return f"[{text}]({posixpath.relpath(site_path(path), posixpath.dirname(site_path(name)) or '.')}{anchor})"

    parts = FENCE.split(markdown)
    parts[::2] = [LINK.sub(site_link, part) for part in parts[::2]]
    return re.sub(r"^(\s*```sh) no-run$", r"\1", "".join(parts), flags=re.MULTILINE)


def on_nav(nav, **_):
    if os.path.isdir(REFERENCE):
        section = next(item for item in nav.items if item.title == "Reference")
        section.children.append(Link("C++ headers", "cpp/index.html"))
    return nav


def on_post_page(output, page, **_):
    return output.replace("</head>", FROM_DISK.format("../" * page.url.count("/")) + "</head>", 1)


def on_post_build(config, **_):
    site = config["site_dir"]
    if os.path.isdir(KATEX):
        assets = os.path.join(site, "assets", "katex")
        os.makedirs(assets, exist_ok=True)
        for name in ("katex.min.js", "katex.min.css"):
            shutil.copyfile(os.path.join(KATEX, name), os.path.join(assets, name))
        shutil.copytree(os.path.join(KATEX, "fonts"), os.path.join(assets, "fonts"), dirs_exist_ok=True)
    else:
        log.warning("there is no KaTeX in %s: please install Debian's package libjs-katex", KATEX)
    if os.path.isdir(REFERENCE):
        shutil.copytree(REFERENCE, os.path.join(site, "cpp"), dirs_exist_ok=True)
    worker, = glob.glob(os.path.join(glob.escape(site), "assets", "javascripts", "workers", "search.*.min.js"))
    with open(os.path.join(site, "assets", "search-from-disk.js"), "w", encoding="utf-8") as file:
        file.write(SEARCH.format(index=read(os.path.join(site, "search", "search_index.json")),
                                 worker=json.dumps(read(worker))))
