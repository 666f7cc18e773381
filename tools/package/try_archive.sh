#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs in a bare Debian root, in which /try has the archive and a scene: unpacks it at an odd place and bakes with it.
set -euo pipefail
export LC_ALL=C.UTF-8
cd /try
fail() { printf 'try: FAILED: %s\n' "$1" >&2; exit 1; }

place="/opt/odd place (1)"
mkdir -p "$place"
tar -xzf luxel-*-linux-*.tar.gz -C "$place"
cd "$place"/luxel-*
[[ $(bin/luxel --version) == "luxel "* ]] || fail "the program does not start"
foreign=$(LD_TRACE_LOADED_OBJECTS=1 bin/luxel | grep -E "not found|=> /" | grep -vF "=> $PWD/" | grep -vE '/lib(c|m|dl|pthread|rt|resolv)\.so' || true)
[[ -z $foreign ]] || fail "libraries of this machine are used: $foreign"
bin/luxel bake /try/cornell-box.obj -o "/try/a box.png" -o /try/box.glb -o /try/box.vtkhdf --error 20% --quiet
[[ -s "/try/a box.png" && -s /try/box.glb ]] || fail "a bake wrote no picture or mesh"
bin/luxel info /try/box.dae >/dev/null || fail "a COLLADA file was not read"
printf 'try: the archive bakes at "%s"\n' "$place"
rm -rf -- "$place"
