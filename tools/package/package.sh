#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Packages for administrators, of ./dev package: .deb files, an archive for other distributions, and the root that both are
# tried in. dev sources this file after its own functions; it runs in the root of the sources.

packages=out/packages
packager=(debhelper dpkg-dev lintian file patchelf mmdebstrap man-db desktop-file-utils appstream python3)
((EUID == 0)) || packager+=(uidmap)  # roots without root: a user's range of identifiers

# What is packaged has the date of the last commit, so that the same sources give the same bytes.
set_package_version() {
  if [[ -z ${SOURCE_DATE_EPOCH-} ]]; then
    SOURCE_DATE_EPOCH=$(git log -1 --format=%ct 2>/dev/null) || SOURCE_DATE_EPOCH=$(stat -c %Y CHANGELOG.md)
  fi
  export SOURCE_DATE_EPOCH
  version=$(sed -n 's/^project(luxel VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
  # Below the version itself, so that the release replaces it.
  [[ $(git tag --points-at HEAD 2>/dev/null) == *"v$version"* ]] || version+="~$(date -u -d "@$SOURCE_DATE_EPOCH" +%Y%m%d.%H%M)"
  archive=luxel-${version/\~/-}-linux-$(uname -m)
}

# The module for Python is made where the sources have it.
python_options=() python_target=
if grep -q '^option(LUXEL_PYTHON ' CMakeLists.txt; then
  python_options=(-DLUXEL_PYTHON=ON -DLUXEL_PYTHON_DIR=lib/python3/dist-packages) python_target=all packager+=(dh-python)
fi

# ---- Debian packages ----

maintainer="The Luxel authors <${DEBEMAIL:-luxel@luxel.example}>"

# debian_folder FOLDER: what debhelper reads.
debian_folder() {
  rm -rf -- "$1"
  mkdir -p "$1"
  cp -R tools/package/debian "$1"
  sed -i "s/@MAINTAINER@/$maintainer/" "$1/debian/control"
  [[ -z $python_target ]] || cat "$1/debian/control.python" >>"$1/debian/control"
  rm -- "$1/debian/control.python"
  cat >"$1/debian/changelog" <<END
luxel ($version-1) unstable; urgency=medium

  * Built from the sources of Luxel; their changes are in changelog.gz.

 -- $maintainer  $(date -u -R -d "@$SOURCE_DATE_EPOCH")
END
}

# make_debs FOLDER: the packages of build/package in a folder.
make_debs() {
  local staging=build/package/debhelper
  debian_folder "$staging"
  mkdir -p "$1"
  rm -f -- "$1"/*.deb
  (cd "$staging" && LUXEL_SOURCES=$root LUXEL_BUILD=$root/build/package LUXEL_PACKAGES=$(realpath -- "$OLDPWD/$1") \
    LUXEL_VERSION=$version LUXEL_PYTHON_TARGET=$python_target debian/rules binary)
}

check_reproducible() {
  local again=build/package/again deb
  rm -rf -- "$again"
  make_debs "$again"
  make_archive "$again"
  for deb in "$again"/*.deb "$again"/*.tar.gz; do cmp -- "$deb" "$packages/${deb##*/}" || return; done
}

check_lintian() { lintian --fail-on error --info --tag-display-limit 0 "$packages"/*.deb; }

# ---- The archive for other distributions ----

# HDF5 is linked as a static library: Debian's shared one brings curl, Kerberos and LDAP, for files in a cloud store.
archive_options() {
  local libraries
  libraries=/usr/lib/$(gcc -dumpmachine)
  printf '%s\n' "-Dpkgcfg_lib_luxel_hdf5_hdf5=$libraries/hdf5/serial/libhdf5.a" \
    "-DCMAKE_CXX_STANDARD_LIBRARIES=$libraries/libsz.a $libraries/libaec.a"
}

# What every Linux has, in the version that the program asks for or a later one.
system_libraries='^(linux-vdso|ld-linux.*|libc|libm|libdl|libpthread|librt|libresolv)\.so'

# make_archive FOLDER: the program of build/portable with its libraries, in a folder.
make_archive() {
  local tree=build/portable/$archive name path
  rm -rf -- "$tree"
  mkdir -p "$tree/lib" "$1"
  DESTDIR=$root/build/portable/installed cmake --install build/portable --component program --strip
  mv -- build/portable/installed/opt/luxel/* "$tree"
  rm -rf -- build/portable/installed
  while read -r name _ path _; do
    [[ $name =~ $system_libraries ]] || install -m 644 -- "$path" "$tree/lib/$name"
  done < <(ldd "$tree/bin/luxel" "$tree/libexec/luxel/luxel-import" | grep '=> /' | sort -u)
  patchelf --set-rpath "\$ORIGIN/../lib" "$tree/bin/luxel"
  patchelf --set-rpath "\$ORIGIN/../../lib" "$tree/libexec/luxel/luxel-import"
  for path in "$tree"/lib/*; do patchelf --set-rpath "\$ORIGIN" "$path"; done
  install -D -m 644 -t "$tree/share/doc/luxel" LICENSE README.md CHANGELOG.md
  python3 -B tools/package/make_sbom.py --name luxel --version "$version" --build build/portable --targets luxel luxel-import \
    --root "$tree" --output "$tree/share/doc/luxel/luxel.spdx.json" --licences "$tree/share/doc/luxel/licences" --bundled
  tar --create --use-compress-program="gzip -9n" --file "$1/$archive.tar.gz" --directory build/portable --sort=name --owner=0 --group=0 --numeric-owner \
    --mtime="@$SOURCE_DATE_EPOCH" --format=gnu --mode=go-w "$archive"
}

# The newest version of glibc that a program or library below a folder asks for.
glibc_of() {
  find "$1/bin" "$1/lib" "$1/libexec" -type f -exec objdump -T {} + | grep -oE 'GLIBC_[0-9.]+' | sort -uV | tail -n 1 | tr _ ' '
}

# ---- Trying them ----

# The machine's own sources of Debian, as lines for mmdebstrap.
debian_sources() {
  # shellcheck disable=SC2016
  apt-get indextargets --format 'deb $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Origin: Debian' | sort -u
}

# new_root TARGET SCRIPT FILE...: makes a bare Debian root, with the files in its folder /try, runs the script in it, and
# leaves it as TARGET, a .tar file or nothing ("-"). mmdebstrap finds a way with root or without. root_options: more of it.
root_options=()
new_root() {
  local target=$1 script=$2 file uploads=()
  shift 2
  for file in "$script" "$@"; do uploads+=("--customize-hook=copy-in '$root/$file' /try"); done
  [[ $target != - ]] || target=/dev/null
  debian_sources | mmdebstrap --variant=minbase "${root_options[@]}" --customize-hook='mkdir -p "$1/try"' "${uploads[@]}" \
    --customize-hook="chroot \"\$1\" bash /try/${script##*/}" --customize-hook='rm -rf "$1/try"' \
    "$(. /etc/os-release && echo "$VERSION_CODENAME")" "$target" -
}

scene_files=(scenes/cornell-box.obj scenes/cornell-box.mtl tools/package/box.dae)
# The root becomes that of the image, without translations and documents but licences.
try_archive() {
  local root_options=(--dpkgopt='path-exclude=/usr/share/doc/*' --dpkgopt='path-include=/usr/share/doc/*/copyright'
    --dpkgopt='path-exclude=/usr/share/locale/*' --dpkgopt='path-exclude=/usr/share/man/*')
  new_root "$packages/luxel-root.tar.gz" tools/package/try_archive.sh "$packages/$archive.tar.gz" "${scene_files[@]}"
}
try_debs() { new_root - tools/package/try_debs.sh "$packages"/*.deb "${scene_files[@]}" examples; }

# The image of tools/package/Containerfile, where there is a program that makes it.
try_image() {
  local maker=podman
  command -v podman >/dev/null || maker=buildah
  "$maker" build --isolation chroot --file tools/package/Containerfile --build-arg "ARCHIVE=$archive" --tag luxel "$packages"
  [[ $maker != podman ]] || podman run --rm luxel --version
}

# ---- All of it ----

make_and_try_packages() {
  need_packages "${compiler[@]}" "${packager[@]}"
  wish_node
  set_package_version
  [[ -n $python_target ]] || say "python3-luxel is left out: these sources have no module for Python"
  export CCACHE_BASEDIR=$root  # both builds share their objects
  local options
  mapfile -t options < <(archive_options)
  configure package "${python_options[@]}"
  step "building what becomes Debian packages" compile package luxel luxel-import luxel_library $python_target || fail "the build failed"
  configure portable "${options[@]}"
  step "building what becomes the archive" compile portable luxel luxel-import || fail "the build failed"
  rm -rf -- "$packages"
  step "making Debian packages" quietly make-debs make_debs "$packages" || fail "the Debian packages could not be made"
  step "making the archive" quietly make-archive make_archive "$packages" || fail "the archive could not be made"
  say "the archive needs $(glibc_of "build/portable/$archive") or later"
  check "checking the packages with lintian" check_lintian
  check "making all again, which gives the same bytes" quietly make-again check_reproducible
  check "trying the archive in a bare root" tried try-archive
  check "trying the packages in a bare root: installing, using and removing them" tried try-debs
  if command -v podman >/dev/null || command -v buildah >/dev/null; then check "making the image" quietly image try_image; fi
  (cd "$packages" && du -h --apparent-size -- *)
  say "ready: $root/$packages"
}

# tried NAME: try_NAME, and of what it prints the lines that say what was tried.
tried() {
  local status=0
  quietly "$1" "${1/-/_}" || status=$?
  grep '^try: ' "build/log/$1" || true
  return "$status"
}
