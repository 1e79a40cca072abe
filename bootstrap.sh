#!/usr/bin/env bash
# Sets nacre up on Debian 12: installs what is missing from Debian's packages (as root or through sudo), configures and
# builds into build/. Safe to run again: it then only builds what changed. Nothing else is downloaded.
#   ./bootstrap.sh            release build in build/
#   ./bootstrap.sh asan       the preset `asan` in build/asan
set -euo pipefail
cd "$(dirname "$0")"
preset=${1:-release}

packages=(g++ cmake ninja-build git ca-certificates
          libembree-dev ocl-icd-opencl-dev opencl-headers opencl-clhpp-headers pocl-opencl-icd
          libopenimageio-dev openimageio-tools libimath-dev libeigen3-dev libceres-dev libcli11-dev libfmt-dev nlohmann-json3-dev
          libtinygltf-dev libtinyobjloader-dev libxxhash-dev libgtest-dev libbenchmark-dev
          fonts-dejavu-core # captions of contact sheets
          oclgrind mesa-opencl-icd) # two more OpenCL implementations, for tests

missing=()
for package in "${packages[@]}"; do
    [ "$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null)" = "install ok installed" ] || missing+=("$package")
done

if [ ${#missing[@]} -gt 0 ]; then
    root=()
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || { echo "bootstrap: needs root or sudo to install: ${missing[*]}" >&2; exit 1; }
        root=(sudo)
    fi
    echo "bootstrap: installing ${missing[*]}"
    "${root[@]}" apt-get update -qq
    "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
fi

echo "bootstrap: configuring ($preset)"
cmake --preset "$preset" -Wno-dev >/dev/null
echo "bootstrap: building"
cmake --build --preset "$preset"
