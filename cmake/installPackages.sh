#!/bin/sh
# Installs the Debian packages that polymesh is built, tested and pictured with. Does nothing when
# all are there. Run as root or as a user who may sudo.
set -eu

build="cmake ninja-build g++ ccache git ca-certificates
  libboost-dev libboost-program-options-dev libcgal-dev libgmp-dev libmpfr-dev libfmt-dev libfast-float-dev
  nlohmann-json3-dev libtbb-dev zlib1g-dev libdeflate-dev libtet1.5-dev libp4est-dev libopenmpi-dev
  openmpi-bin"
test="libgtest-dev clang clang-format-14 clang-tidy-14 libclang-rt-14-dev
  openfoam openfoam-examples libcgal-demo gmsh python3 python3-numpy"
picture="python3-vtk9 xvfb xauth libgl1-mesa-dri"

# Surfaces that tests and tutorials use come as documentation, which small images of Debian leave out.
surfaces="openfoam-examples:/usr/share/doc/openfoam-examples/examples/resources/geometry
  libcgal-demo:/usr/share/doc/libcgal-dev/data.tar.gz"

missing=""
for package in $build $test $picture; do
    status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$status" = installed ] || missing="$missing $package"
done
again=""
for surface in $surfaces; do
    [ -e "${surface#*:}" ] || again="$again ${surface%%:*}"
done
[ -n "$missing$again" ] || exit 0

asRoot=""
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || {
        echo "installPackages.sh: needs root (or sudo) to install:$missing$again" >&2
        exit 1
    }
    asRoot="sudo"
fi
echo "Installing$missing$again"
apt() {
    # shellcheck disable=SC2086 # no word when root
    $asRoot env DEBIAN_FRONTEND=noninteractive apt-get -qq "$@"
}
apt update
# shellcheck disable=SC2086 # a list of words on purpose
apt install -y --no-install-recommends --reinstall \
    -o 'Dpkg::Options::=--path-include=/usr/share/doc/openfoam-examples/*' \
    -o 'Dpkg::Options::=--path-include=/usr/share/doc/libcgal-dev/*' $missing $again
