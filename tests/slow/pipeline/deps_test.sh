#!/bin/bash
# Installation of packages, with stand-ins for dpkg-query, apt-get and sudo that record their calls.
# shellcheck source-path=SCRIPTDIR disable=SC2016
source "${0%/*}/../../pipeline/support.sh"

command_that() { # name, body
  printf '#!/bin/bash\n%s\n' "$2" >"path/$1"
  chmod +x "path/$1"
}

# Every package is installed except the named ones.
all_but() {
  command_that dpkg-query 'shift 3; for p; do case " '"$*"' " in
    *" $p "*) echo "config-files $p" ;; *) echo "installed $p" ;; esac; done'
}

# Has only the programs of a minimal Debian, and the stand-ins.
machine() {
  mkdir path
  local tool
  for tool in bash env grep; do ln -s "$(command -v $tool)" path/; done
  command_that apt-get 'echo "apt-get $* [$DEBIAN_FRONTEND]" >>apt-calls'
}

# Sets EUID, which deps.sh reads, so that the test needs neither root nor a user namespace.
deps_as() { # 0 or another id; LIBTORCH and targets, by default on and all
  local id=$1
  shift
  (($#)) || set -- on programs tests benches
  sed "s/((EUID == 0))/(($id == 0))/" pipeline/deps.sh >deps-as.sh
  PATH=$PWD/path bash deps-as.sh "$@" </dev/null
}

test_does_nothing_if_nothing_is_missing() {
  machine
  all_but
  expect_equal "$(deps_as 1000 2>&1)" ""
  [[ ! -e apt-calls ]] || fail "apt was called: $(<apt-calls)"
}

test_root_installs_only_what_is_missing() {
  machine
  all_but libtorch-dev curl
  deps_as 0 >/dev/null
  expect_equal "$(<apt-calls)" "$(printf '%s\n' 'apt-get --option DPkg::Lock::Timeout=300 update --quiet=2 [noninteractive]' \
    'apt-get --option DPkg::Lock::Timeout=300 install --quiet=2 --yes --no-install-recommends curl libtorch-dev [noninteractive]')"
}

test_sudo_is_used_when_it_works() {
  machine
  all_but curl
  command_that sudo '[[ $1 == -n ]] && exit; echo sudo >>apt-calls; exec "$@"'
  deps_as 1000 >/dev/null
  expect_equal "$(grep -c sudo apt-calls) $(grep -c 'install.*curl' apt-calls)" "2 1"
}

test_without_rights_prints_the_command() {
  machine
  all_but libtorch-dev
  expect_line "$(deps_as 1000 2>&1 || true)" \
    '^  sudo apt-get update && sudo apt-get install --yes --no-install-recommends libtorch-dev$'
  expect_exit 2 deps_as 1000
  command_that sudo 'exit 1'
  expect_exit 2 deps_as 1000
  [[ ! -e apt-calls ]] || fail "apt was called: $(<apt-calls)"
}

test_targets_that_are_not_requested_do_not_need_packages() {
  machine
  all_but libtorch-dev libopenblas-dev libgtest-dev libgmock-dev libbenchmark-dev hdf5-tools
  expect_equal "$(deps_as 0 off programs)" ""
  expect_equal "$(deps_as 0 on programs)" "deps: installing libtorch-dev libopenblas-dev"
  expect_equal "$(deps_as 0 off programs tests)" "deps: installing libgtest-dev libgmock-dev hdf5-tools"
  expect_equal "$(deps_as 0 off benches)" "deps: installing libbenchmark-dev"
  all_but python3-scipy octave
  expect_equal "$(deps_as 0 off programs tests)" ""
  expect_equal "$(deps_as 0 off readers)" "deps: installing python3-scipy octave"
  all_but dpkg-dev file
  expect_equal "$(deps_as 0 off programs tests)" ""
  expect_equal "$(deps_as 0 off programs package)" "deps: installing dpkg-dev file"
  all_but gnuplot-nox qpdf fonts-dejavu-core
  expect_equal "$(deps_as 0 off programs)" ""
  expect_equal "$(deps_as 0 off programs figures)" "deps: installing gnuplot-nox qpdf fonts-dejavu-core"
}

# Checks which packages make requests, and what it has built.
test_goals_request_what_they_need() {
  local script
  for script in deps build; do
    printf '#!/bin/bash\necho "%s $*" >>asked\n' $script >pipeline/$script.sh
  done
  mkdir -p tests build/bin
  printf '#!/bin/bash\n' >tests/run.sh
  chmod +x tests/run.sh
  asked() { rm -f asked && make --silent "$@" >/dev/null 2>&1; paste -sd, asked; }
  expect_equal "$(asked build)" "deps on programs,build native on programs"
  expect_equal "$(asked build LIBTORCH=off ARCH=x86-64-v3)" "deps off programs,build x86-64-v3 off programs"
  expect_equal "$(asked test)" "deps on programs tests,build native on programs tests"
  expect_equal "$(asked test-all)" \
    "deps on programs tests benches readers cluster,build native on programs tests slow_tests benches"
  expect_equal "$(asked package ARCH=x86-64 LIBTORCH=off)" "deps off programs package,build x86-64 off package"
  mkdir cmake
  printf '#!/bin/bash\necho "cmake [$DESTDIR] $*" >>asked\n' >cmake/cmake
  chmod +x cmake/cmake
  expect_equal "$(PATH=$PWD/cmake:$PATH DESTDIR=/root asked install PREFIX=here)" \
    "deps on programs,build native on programs,cmake [/root] --install build --prefix $PWD/here --strip"
  expect_equal "$(asked deps)" "deps on programs tests benches figures"
  ln -s "$programs/plan" build/bin
  expect_equal "$(asked demo)" "deps off demo figures,build native off demo"
}

test_a_failed_install_fails() {
  machine
  all_but curl
  command_that apt-get 'echo "E: no network" >&2; exit 100'
  expect_exit 1 deps_as 0
  expect_line "$(deps_as 0 2>&1 || true)" 'E: no network'
}

run_tests "$@"
