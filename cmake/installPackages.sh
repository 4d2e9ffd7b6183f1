#!/bin/sh
# Installs the Debian packages that polymesh is built, tested and pictured with. Does nothing when
# all are there. Run as root or as a user who may sudo.
set -eu

build="cmake ninja-build g++ ccache git ca-certificates
  libboost-dev libboost-program-options-dev libcgal-dev libgmp-dev libmpfr-dev libfmt-dev libfast-float-dev
  nlohmann-json3-dev libtbb-dev zlib1g-dev libtet1.5-dev"
test="libgtest-dev clang clang-format-14 clang-tidy-14 libclang-rt-14-dev
  openfoam openfoam-examples libcgal-demo gmsh python3 python3-numpy"
picture="python3-vtk9 xvfb xauth libgl1-mesa-dri"

missing=""
for package in $build $test $picture; do
    status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$status" = installed ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

asRoot=""
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || {
        echo "installPackages.sh: needs root to install:$missing" >&2
        exit 1
    }
    asRoot="sudo"
fi
echo "Installing$missing"
export DEBIAN_FRONTEND=noninteractive
$asRoot apt-get update -qq
# shellcheck disable=SC2086 # a list of words on purpose
$asRoot apt-get install -y -qq --no-install-recommends $missing
