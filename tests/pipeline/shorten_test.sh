#!/bin/bash
# pipeline/figures/shorten.awk: gnuplot's SVG becomes shorter but looks the same.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/support.sh"

shortened() { awk -f pipeline/figures/shorten.awk <<<"$1"; }

test_points_of_a_path_are_relative() {
  expect_equal "$(shortened "  <path stroke='black'  d='M10.00,20.04 L10.56,9.96 L-0.26,9.96
    L-0.26,10.26  '/>")" "  <path stroke='black'  d='M10 20l.6-10-10.9 0 0 .3'/>"
}

test_rounding_does_not_add_up() { # 100 steps of 0.04
  local path="M0.00,0.00" i
  for ((i = 1; i <= 100; ++i)); do path+=" L$((4 * i / 100)).$(printf %02d $((4 * i % 100))),0.00"; done
  local steps
  steps=$(shortened "  <path stroke='black' d='$path  '/>" | sed "s/.*l//; s/'.*//" | tr ' ' '\n' | awk '{ sum += $1 } END { print sum }')
  expect_equal "$steps" 4
}

test_a_path_can_continue_elsewhere_and_be_closed() {
  expect_equal "$(shortened "  <path stroke='black'  d='M1.00,1.00 L2.00,1.00 M5.00,5.00 L6.00,6.50 Z  '/>")" \
    "  <path stroke='black'  d='M1 1l1 0M5 5l1 1.5Z  '/>"
}

mark() { # number, place, attributes
  echo "  <use xlink:href='#gpPt$1' transform='translate($2) scale(2.25)' $3/>"
}

test_marks_of_one_kind_become_one_path() {
  local red="color='rgb(213,  94,   0)'" blue="color='rgb(  0, 114, 178)' opacity='0.44'" svg
  svg=$(shortened "$(mark 6 1.00,2.00 "$red")

$(mark 6 3.50,1.00 "$red")

$(mark 5 9.00,9.00 "$blue")
$(mark 6 4.00,4.00 "$red")
</g>")
  expect_equal "$(grep -c '<marker ' <<<"$svg")" 2
  expect_line "$svg" "<marker id='[^']*' .*<use xlink:href='#gpPt5' transform='scale\(2.25\)' color='rgb\(  0, 114, 178\)' opacity='0.44'/></marker>"
  expect_line "$svg" " d='M1 2l2.5-1'/>"
  expect_line "$svg" " d='M9 9'/>"
  expect_line "$svg" " d='M4 4'/>"
  local id
  id=$(sed -n "s/<marker id='\([^']*\)'.*gpPt6.*/\1/p" <<<"$svg")
  expect_equal "$(grep -c "marker:url(#$id)" <<<"$svg")" 2
}

test_only_empty_groups_are_left_out() {
  expect_equal "$(shortened '<g fill="none" color="black">
</g>
<g fill="none" color="red">
  <text>10.25 m, L1.23,4.56</text>
</g>')" '<g fill="none" color="red">
  <text>10.25 m, L1.23,4.56</text>
</g>'
}

run_tests "$@"
