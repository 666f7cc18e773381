#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs in a bare Debian root, in which /try has the .deb files, a scene and the examples: installs, tries and removes them.
set -euo pipefail
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8
cd /try

# say SENTENCE: with the seconds since the last one.
begin=$SECONDS
say() { printf 'try: %s (%d s)\n' "$1" $((SECONDS - begin)); begin=$SECONDS; }
fail() { printf 'try: FAILED: %s\n' "$1" >&2; exit 1; }
install() { apt-get -qq -y -o DPkg::Lock::Timeout=60 install --no-install-recommends "$@" >install.log 2>&1 || { tail install.log; fail "installing $*"; }; }
# MB of all installed packages, by their own account.
used() { dpkg-query -W -f='${Installed-Size}\n' | awk '{ sum += $1 } END { print int(sum / 1000) }'; }

apt-get -qq update
before=$(used)
install ./luxel_*.deb
say "luxel is installed: with what it depends on, $(($(used) - before)) MB"

luxel bake cornell-box.obj -o box.vtkhdf -o box.png -o box.glb -o box.html --error 20% --quiet
[[ -s box.png && -s box.glb && -s box.html ]] || fail "a bake wrote no picture, mesh or page"
luxel info box.dae >/dev/null || fail "a COLLADA file was not read"
say "a scene is baked, and a COLLADA file read"
for file in paraview/luxel_light.py paraview/luxel_light.pvsm blender/luxel_bake.py; do
  [[ -s /usr/share/luxel/$file ]] || fail "/usr/share/luxel/$file is missing"
done

install man-db bash-completion xvfb xauth shared-mime-info desktop-file-utils libglib2.0-bin
for page in luxel luxel-bake luxel-view; do
  [[ $(MANWIDTH=80 man "$page") == *NAME*"$page"* ]] || fail "man $page shows nothing"
done
[[ $(man luxel-bake) == *--quality* ]] || fail "luxel-bake(1) lacks an option"
say "man shows luxel, luxel-bake and luxel-view"

loaded=$(bash -c 'source /usr/share/bash-completion/bash_completion; _completion_loader luxel; complete -p luxel')
[[ $loaded == *"_luxel luxel"* ]] || fail "bash does not load the completion"
say "bash loads the completion"

printf 'wait light\nwait view\nsnapshot window.png\nclose\n' >close.script
{ xvfb-run --auto-servernum luxel view box.vtkhdf --script close.script && [[ -s window.png ]]; } || fail "the window did not open"
[[ $(gio info -a standard::content-type box.vtkhdf) == *application/x-vtkhdf* ]] || fail "the desktop does not know .vtkhdf"
[[ $(gio mime application/x-vtkhdf) == *luxel.desktop* ]] || fail "the desktop does not open .vtkhdf with luxel"
say "the window opens, and the desktop opens .vtkhdf with it"

install ./libluxel-dev_*.deb g++ cmake ninja-build
cmake -S examples -B built -G Ninja >cmake.log || { tail cmake.log; fail "CMake does not find libluxel-dev"; }
cmake --build built --target bake_from_arrays >cmake.log || { tail cmake.log; fail "an example does not build"; }
./built/bake_from_arrays >/dev/null || fail "an example does not run"
say "an example builds with libluxel-dev and runs"

packages=(luxel libluxel-dev)
if compgen -G './python3-luxel_*.deb' >/dev/null; then
  install ./python3-luxel_*.deb
  cat >bake.py <<'END'
import luxel
solution = luxel.bake("cornell-box.obj", error=0.2)
solution.write("python.png")
print(luxel.__version__, solution.mean("white"))
assert luxel.load_scene("box.dae"), "a COLLADA file was not read"
END
  python3 bake.py || fail "Python does not bake"
  [[ -s python.png ]] || fail "Python wrote no picture"
  packages+=(python3-luxel)
  say "Python imports luxel, bakes, and reads a COLLADA file"
fi

apt-get -qq -y purge "${packages[@]}" >/dev/null
# man-db tends its own cache.
left=$(find / -xdev -iname '*luxel*' -not -path '/try/*' -not -path '/proc/*' -not -path '/sys/*' -not -path '/var/cache/man/*')
[[ -z $left ]] || fail "removed packages leave $left"
say "removed, they leave nothing"
