#!/bin/bash
# `make data` from an official site on this machine, which a wrapper of curl reaches without a network.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/../../pipeline/support.sh"

# Makes an official site with two recordings, and an `ingest --sources` that names them.
site() {
  rm -f pipeline/datasets/*
  touch pipeline/datasets/real.toml
  mkdir site
  seq 1 20000 >site/1.mat
  seq 1 30000 >site/2.mat
  local n
  for n in 1 2; do
    echo "$(sha256sum <site/$n.mat | cut -d' ' -f1)  real/file $n.mat  http://site/$n.mat"
  done >sources
  rm fake/ingest
  # shellcheck disable=SC2016
  printf '#!/bin/bash\n[[ $1 == --sources ]] && cat sources\n' >fake/ingest
  chmod +x fake/ingest
  # serves the site's addresses; passes all others to the real curl
  mkdir commands
  cat >commands/curl <<CURL
#!/bin/bash
printf '%s\n' "\$@" >>curl-options
[[ \${!#} == http://site/* ]] || exec $(command -v curl) "\$@"
options=("\${@/#http:\/\/site/file://$PWD/site}")
exec $(command -v curl) "\${options[@]/#=http,https/=file}"
CURL
  chmod +x commands/curl
  PATH=$PWD/commands:$PATH
}

data() { make --silent data BIN=fake DATASETS=real DATA_DIR=d; }

test_fetches_and_checks() {
  site
  expect_line "$(data)" "real: 2 files fetched, 0 existed"
  cmp "d/real/file 1.mat" site/1.mat
  cmp "d/real/file 2.mat" site/2.mat
  expect_line "$(data)" "real: 0 files fetched, 2 existed"
}

test_simulated_data_sets_do_not_need_recordings() {
  site
  printf '[simulation]\nnoise = 0.1\n' >pipeline/datasets/made.toml
  printf 'name = "like-made"\nlike = "made"\n[split]\nwindow = 512\n' >pipeline/datasets/like-made.toml
  # shellcheck disable=SC2016
  printf '#!/bin/bash\n[[ $3 != */real.toml ]] || exec cat sources\nexec %q "$@"\n' "$programs/ingest" >fake/ingest
  make --silent data BIN=fake DATASETS="like-made real made" DATA_DIR=d METHODS=smote >output
  expect_equal "$(grep -v ' from ' output)" "data: real: 2 files fetched, 0 existed"
}

test_continues_where_it_was_stopped() {
  site
  mkdir -p d/real
  head -c 5000 site/1.mat >"d/real/file 1.mat.part"
  cp site/2.mat "d/real/file 2.mat.part"
  expect_line "$(data)" "real: 2 files fetched"
  cmp "d/real/file 1.mat" site/1.mat
  expect_equal "$(ls d/real)" "$(printf '%s\n' 'file 1.mat' 'file 2.mat')"
}

test_a_wrong_sum_is_refused() {
  site
  tr 1 2 <site/2.mat >other
  mv other site/2.mat
  expect_line "$(data 2>&1 || true)" "d/real/file 2.mat: the file from http://site/.* is not the described recording"
  expect_exit 2 data
  expect_equal "$(ls d/real)" "file 1.mat"
  cp site/2.mat "d/real/file 2.mat"
  expect_exit 2 data
}

test_names_what_cannot_be_fetched_with_the_alternatives() {
  site
  rm site/1.mat
  expect_line "$(data 2>&1 || true)" \
    "d/real/file 1.mat: could not be downloaded .*Run the same command to continue, or put the file there by hand .*DATA_DIR="
  expect_exit 2 data
}

test_recordings_without_an_address() {
  site
  echo "-  real/mine.csv  -" >sources
  expect_line "$(data 2>&1 || true)" "real: no official address for d/real/mine.csv"
  expect_exit 2 data
  mkdir -p d/real
  touch d/real/mine.csv
  expect_line "$(data)" "real: 0 files fetched, 1 existed"
}

# The programs refuse such addresses (tests/signal/description_test.cpp), and curl is told to refuse them, too.
test_only_http_and_https_are_used() {
  site
  data >/dev/null
  rm -r d
  sed -i "s,http://site,file://$PWD/site," sources
  expect_line "$(data 2>&1 || true)" 'could not be downloaded from file://.*rotocol "file" '
  expect_exit 2 data
  expect_equal "$(ls d/real)" ""
  expect_line "$(<curl-options)" '^--globoff$'
  expect_line "$(<curl-options)" '^--url$'
}

test_a_site_cannot_fill_the_disk_or_block() {
  site
  truncate --size=4100000000 site/1.mat
  expect_line "$(data 2>&1 || true)" 'file 1.mat: could not be downloaded from .* \(more than 4000000000 bytes\)'
  expect_equal "$(ls d/real)" ""
  expect_line "$(<curl-options)" '^--speed-time$'
}

test_nothing_is_written_outside_the_data_folder() {
  site
  mkdir d elsewhere
  echo precious >elsewhere/victim
  ln -s ../elsewhere d/real
  expect_line "$(data 2>&1 || true)" "d/real/file 1.mat: its folder is a link out of d, so nothing is downloaded"
  expect_exit 2 data
  expect_equal "$(ls elsewhere)" victim
  rm d/real
  mkdir d/real
  ln -s "$PWD/elsewhere/victim" "d/real/file 1.mat.part"
  expect_line "$(data 2>&1 || true)" "d/real/file 1.mat: it or its .part is a link"
  expect_equal "$(<elsewhere/victim)" precious
  # an existing file may be a link
  rm d/real/*
  ln -s "$PWD"/site/* d/real/
  for n in 1 2; do mv "d/real/$n.mat" "d/real/file $n.mat"; done
  expect_line "$(data)" "real: 0 files fetched, 2 existed"
}

# A pipe would block, and a file would be moved into a folder.
test_refuses_what_is_not_a_file() {
  site
  mkdir -p d/real
  mkfifo "d/real/file 1.mat.part"
  expect_line "$(timeout 20 make --silent data BIN=fake DATASETS=real DATA_DIR=d 2>&1)" \
    "d/real/file 1.mat: d/real/file 1.mat.part is not a regular file; remove it"
  expect_exit 2 timeout 20 make --silent data BIN=fake DATASETS=real DATA_DIR=d
  rm d/real/*
  mkdir "d/real/file 1.mat"
  expect_line "$(data 2>&1 || true)" "d/real/file 1.mat is not a regular file; remove it"
  expect_exit 2 data
  expect_equal "$(ls "d/real/file 1.mat")" ""
}

run_tests "$@"
