#!/bin/bash
# Installs by apt what the project needs and the machine lacks: as root, or with sudo. Where neither
# is possible it prints the line for somebody who may, and exits with 2. When nothing is missing it
# does nothing, and needs no network.
# usage: pipeline/deps.sh LIBTORCH TARGET...      (LIBTORCH: on or off)
# TARGETs are `programs`, `tests`, `benches`, `figures`, `readers`, `cluster`, `lint` and `package`: what one of
# them needs beyond the programs comes for it alone.
set -euo pipefail

libtorch=$1
shift
packages=(
  g++ make cmake ninja-build mold pkgconf git         # to build; git also names the commit in artefacts
  libeigen3-dev libhdf5-dev libsoxr-dev               # linear algebra, artefacts, resampling
  libmatio-dev zlib1g-dev libsndfile1-dev             # recordings: MATLAB files, sound
  libcli11-dev libtomlplusplus-dev libspdlog-dev      # options, settings, log lines
  libboost-dev libboost-math-dev libssl-dev           # differential equations, statistics, sha256
  curl ca-certificates                                # make data
)
[[ $libtorch == off ]] || packages+=(libtorch-dev libopenblas-dev)
[[ " $* " != *" tests "* ]] || packages+=(libgtest-dev libgmock-dev hdf5-tools gnuplot-nox qpdf fonts-dejavu-core)
[[ " $* " != *" benches "* ]] || packages+=(libbenchmark-dev time)
[[ " $* " != *" figures "* ]] || packages+=(gnuplot-nox qpdf fonts-dejavu-core)
# The tests of `export_windows` have others read what it writes.
[[ " $* " != *" readers "* ]] || packages+=(python3-numpy python3-scipy octave)
[[ " $* " != *" package "* ]] || packages+=(dpkg-dev file) # which libraries, of which packages, a program needs
# The tests on a real Slurm start it themselves, in a network namespace.
[[ " $* " != *" cluster "* ]] || packages+=(slurm-wlm iproute2)
# Lint asks clang's tools of one version alone, that of Debian 12.
if [[ " $* " == *" lint "* ]]; then
  packages+=(shellcheck)
  ! grep -qs '^VERSION_ID="12"' /etc/os-release || packages+=(clang-format clang-tidy libc++-dev libomp-dev)
fi

if ! command -v dpkg-query >/dev/null; then
  echo "deps: not Debian or Ubuntu, so nothing is installed here; needed are: ${packages[*]}" >&2
  exit 0
fi

installed=$(dpkg-query --show --showformat '${db:Status-Status} ${Package}\n' "${packages[@]}" 2>/dev/null || true)
missing=()
for package in "${packages[@]}"; do
  grep -qx "installed $package" <<<"$installed" || missing+=("$package")
done
((${#missing[@]})) || exit 0

# A fresh machine may be installing its own updates; apt waits for that.
apt="env DEBIAN_FRONTEND=noninteractive apt-get --option DPkg::Lock::Timeout=300"
packages_to_install="--yes --no-install-recommends ${missing[*]}"
if ((EUID == 0)); then
  as_root=
elif command -v sudo >/dev/null && { sudo -n true 2>/dev/null || { [[ -t 0 ]] && sudo -v; }; }; then
  as_root=sudo
else
  echo "deps: packages are missing, and installing them needs root. Run this, or have it run:" >&2
  echo "  sudo apt-get update && sudo apt-get install $packages_to_install" >&2
  exit 2
fi

echo "deps: installing ${missing[*]}"
# On a terminal apt shows how far it is; a log needs none of its hundreds of lines.
quiet=--quiet=2
show=/dev/null
[[ -t 1 ]] && quiet='' show=/dev/stdout
for command in "$apt update $quiet" "$apt install $quiet $packages_to_install"; do
  # shellcheck disable=SC2086
  $as_root $command >$show || {
    echo "deps: failed: $as_root $command" >&2
    exit 1
  }
done
