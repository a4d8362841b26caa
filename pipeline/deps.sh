#!/bin/bash
# Installs missing packages by apt, as root or with sudo. If neither is possible, prints the command for an
# administrator and exits with 2. If nothing is missing, does nothing and does not need a network.
# usage: pipeline/deps.sh LIBTORCH TARGET...      (LIBTORCH: on or off)
# TARGETs are `programs`, `tests`, `benches`, `figures`, `readers`, `cluster`, `lint` and `package`. The packages that
# only one of them needs are installed for that target only.
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
# The tests of `export_windows` read its files with other programs.
[[ " $* " != *" readers "* ]] || packages+=(python3-numpy python3-scipy octave)
[[ " $* " != *" package "* ]] || packages+=(dpkg-dev file) # to find the libraries and packages that a program needs
# The tests on a real Slurm start it themselves, in a network namespace.
[[ " $* " != *" cluster "* ]] || packages+=(slurm-wlm iproute2)
# Lint uses only the version of clang's tools in Debian 12.
if [[ " $* " == *" lint "* ]]; then
  packages+=(shellcheck)
  ! grep -qs '^VERSION_ID="12"' /etc/os-release || packages+=(clang-format clang-tidy libc++-dev libomp-dev)
fi

if ! command -v dpkg-query >/dev/null; then
  echo "deps: not Debian or Ubuntu, so nothing is installed here; install these packages: ${packages[*]}" >&2
  exit 0
fi

installed=$(dpkg-query --show --showformat '${db:Status-Status} ${Package}\n' "${packages[@]}" 2>/dev/null || true)
missing=()
for package in "${packages[@]}"; do
  grep -qx "installed $package" <<<"$installed" || missing+=("$package")
done
((${#missing[@]})) || exit 0

# A fresh machine may be installing its own updates; apt waits for them.
apt="env DEBIAN_FRONTEND=noninteractive apt-get --option DPkg::Lock::Timeout=300"
packages_to_install="--yes --no-install-recommends ${missing[*]}"
if ((EUID == 0)); then
  as_root=
elif command -v sudo >/dev/null && { sudo -n true 2>/dev/null || { [[ -t 0 ]] && sudo -v; }; }; then
  as_root=sudo
else
  echo "deps: packages are missing, and installing them needs root. Run this, or ask an administrator to:" >&2
  echo "  sudo apt-get update && sudo apt-get install $packages_to_install" >&2
  exit 2
fi

echo "deps: installing ${missing[*]}"
# Show apt's progress on a terminal only; a log would get hundreds of lines.
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
