#!/bin/bash
# The numbers in the README and in the tables of the pages are those of results/reference.
# shellcheck source-path=SCRIPTDIR
source "${0%/*}/support.sh"

reference=$project/results/reference

# Prints mean±deviation of ten seeds' values, one in a line, with six decimals; or how many there are, if not ten.
spread() {
  awk '{ n++; sum += $1; squares += $1 * $1 }
    END {
      if (n != 10) { print n + 0 " seeds"; exit }
      mean = sum / n
      printf "%.6f±%.6f\n", mean, sqrt((squares - n * mean * mean) / (n - 1) + 1e-12)
    }'
}

# Prints mean±deviation of the accuracy of a method in percent.
accuracy() { # stored numbers, method, classifier, ratio
  awk -F, -v method="$2" -v classifier="$3" -v ratio="$4" '
    $1 == method && $2 == classifier && $3 == ratio && $4 == "accuracy" { printf "%.9f\n", 100 * $6 }' "$reference/$1" | spread
}

# Prints the accuracy of each seed in another condition: of one data set, or the mean over all; by the classifier that was
# chosen on the tuning seeds, or by this one. `column` is accuracy or kind (of the fault type alone).
of_seeds() { # stored table, method, [data set or '', [column, [classifier]]]
  awk -F, -v method="$2" -v dataset="${3-}" -v column="${4:-accuracy}" -v classifier="${5-}" '
    NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
    $at["method"] != method || $at["seed"] !~ /^[0-9]+$/ || dataset != "" && $1 != dataset { next }
    classifier ? $at["classifier"] != classifier : !$at[column == "kind" ? "kind_recorded" : "recorded"] { next }
    { sum[$at["seed"]] += $at[column]; count[$at["seed"]]++ }
    END { for (seed in sum) printf "%s %.9f\n", seed, sum[seed] / count[seed] }' "$reference/$1" | sort -n | cut -d' ' -f2
}
transferred() { of_seeds "$@" | spread; } # prints mean±deviation

# Prints a cell of a stored page: of the first table below the heading with such a column and such a row. A row is named
# by its first cell, or by its first cells, separated by |.
cell() { # page, heading, row, column
  awk -v heading="## $2" -v row="|$3|" -v column="$4" '
    /^## / { inside = ($0 == heading) }
    !inside || !/^\|/ { at = 0; next }
    { gsub(/ *\| */, "|") }
    !at { at = -1; n = split($0, cells, "|"); for (i = 2; i < n; i++) if (cells[i] == column) at = i; next }
    at > 0 && index($0, row) == 1 { split($0, cells, "|"); print cells[at]; exit }' "$reference/$1"
}

# Rounds both numbers of mean±deviation, or one number. Halves, which floating-point sums miss by little, go up.
rounded() { # decimals, text
  awk -F± -v decimals="$1" -v text="$2" 'BEGIN {
    n = split(text, numbers)
    for (i = 1; i <= n; i++) {
      up = numbers[i] < 0 ? -1e-7 : 1e-7
      printf "%s%." decimals "f", (i > 1 ? "±" : ""), numbers[i] + up
    }
  }'
}
mean() { rounded "$1" "${2%±*}"; } # decimals, text
percent() { rounded 1 "$(accuracy "$@")"; }
elsewhere() { # as transferred(); a dash for a method that is not in the table
  local accuracy
  accuracy=$(transferred "$@")
  if [[ $accuracy == '0 seeds' ]]; then printf –; else rounded 1 "$accuracy"; fi
}

# Fails unless the page contains the text. Line breaks, spaces that only align a table, and bold print do not count.
expect_said() { # page, text
  tr '\n' ' ' <"$project/$1" | sed 's/  */ /g; s/\*\*//g' | grep -qF -- "$2" || fail "$1 does not say: $2"
}

speeds=random/transfer@speeds.csv
sizes=random/transfer@sizes.csv
uestc=random/transfer@uestc-speeds.csv
uestc_true=random/transfer@uestc-true-speeds.csv

of_blind() { # judge, column
  cell random/cwru-blind/verdicts.md 'Right verdicts, by how clearly a record shows its fault' "$1" "$2"
}

# Prints the accuracy of a classifier without generated windows on the four data sets without a known fault.
untaught() { # decimals, classifier
  local dataset
  for dataset in cwru hit-sm uestc uestc-true; do
    mean "$1" "$(accuracy blocked/$dataset-types-zero.csv none "$2" 100to1)"
    echo
  done
}

# Prints the least and the greatest accuracy of a method over the six ratios with generated windows.
least_and_most() { # stored numbers, method
  local ratio
  for ratio in 50to1 25to1 10to1 5to1 2to1 1to1; do
    mean 1 "$(accuracy "$1" "$2" wdcnn $ratio)"
    echo
  done | sort -g | sed -n '1p; $p'
}

test_the_answers_of_the_readme() {
  expect_said README.md "(\`exclusion-rule\`) name $(of_blind exclusion-rule 'all faults (60)') of CWRU's 60 fault records, $(
    # Faults of cwru.toml had been used before; a record's name ends with the number of its file.
    sed -n 's,^file = "cwru/\(.*\).mat"$,-\1,p' "$project/pipeline/datasets/cwru.toml" >used
    awk -F, 'FNR == NR { used[$1]; next }
      { number = $7; sub(/^[^-]*/, "", number) }
      $2 == "exclusion-rule" && $9 == 1 && !(number in used) { ++count; right += $12 }
      END { print right " of the " count }' used "$reference/random/cwru-blind/verdicts.csv"
  ) new to us"
  expect_said README.md "a public tool, without a healthy record, $(of_blind predictive-maintenance-mcp 'all faults (60)')."
  local network rule
  mapfile -t network < <(untaught 0 any-bearing)
  mapfile -t rule < <(untaught 0 exclusion-rule)
  expect_said README.md "CWRU ${network[0]}, HIT-SM ${network[1]}, UESTC ${network[2]} by nominal speeds, ${network[3]} by \
true ones. The rule: ${rule[0]}, ${rule[1]}, ${rule[2]}, ${rule[3]}."

  local twin
  mapfile -t twin < <(least_and_most random/cwru.csv piae-dt)
  expect_said README.md "No: $(rounded 0 "${twin[0]}") to $(rounded 0 "${twin[1]}") on CWRU, a public data set. Without \
generated windows: $(mean 0 "$(accuracy random/cwru.csv none wdcnn 100to1)")."
  at_1to1() { mean 0 "$(accuracy "$1" "$2" wdcnn 1to1)"; }
  expect_said README.md "\`piae-dt-phase\` $(at_1to1 random/cwru.csv piae-dt-phase), \`shift\` $(
    at_1to1 random/cwru.csv shift
  ). \`spectral\`, without shaft angles: $(at_1to1 rivals/random/cwru.csv spectral)."
  expect_said README.md "$(at_1to1 rivals/random/cwru.csv ddpm) and $(
    at_1to1 rivals/random/cwru.csv flow
  ); at random shaft angles $(at_1to1 rivals/random/cwru.csv ddpm-angle),"
  expect_equal "$(at_1to1 rivals/random/cwru.csv flow-angle)" "$(at_1to1 rivals/random/cwru.csv ddpm-angle)"
  times_of_shift() { # in hundreds
    awk -F, '$4 == "1to1" { s[$1] = $5 } END { printf "%.0f", s["ddpm-angle"] / s["shift"] / 100 }' \
      "$reference/rivals/random/cwru/figures/cost.csv"
  }
  expect_said README.md "for over $(times_of_shift)00 times the time of \`shift\`"
  expect_said README.md "nearest neighbour on spectra, $(mean 1 "$(accuracy random/cwru.csv none nearest 100to1)")."

  best_rival() { # stored table, pattern of other methods that do not count
    awk -F, 'NR > 1 { print $3 }' "$reference/$1" | sort -u | grep -vxE "strike-twin|oracle|$2" |
      while read -r method; do rounded 4 "$(transferred "$1" "$method")" && echo; done | sort -g | tail -1
  }
  expect_said README.md "HIT-SM: \`strike-twin\` $(mean 0 "$(transferred $speeds strike-twin)"), best rival $(
    mean 0 "$(best_rival $speeds none)"
  )."
  twin_rival_none() { # stored table
    local best
    best=$(best_rival "$1" none)
    mean 1 "$(transferred "$1" strike-twin)"
    printf '%s' "$2"
    mean 1 "$best"
    printf '%s' "$3"
    mean 1 "$(transferred "$1" none)"
  }
  expect_said README.md "UESTC: $(twin_rival_none $uestc ', best rival ' ', no generated windows ') (by true speeds $(
    twin_rival_none $uestc_true ', ' ', '
  ))."
  expect_equal "$(mean 0 "$(transferred $sizes strike-twin)")" "$(mean 0 "$(transferred $sizes spectral)")"
  expect_said README.md "\`strike-twin\` and \`spectral\` $(mean 0 "$(transferred $sizes spectral)"), all others below $(
    awk '{ print int($1) + 1 }' <<<"$(best_rival $sizes spectral)"
  )."
  twin_by() { mean 0 "$(transferred classifiers/blocked/transfer@sizes.csv strike-twin '' accuracy "$1")"; }
  expect_said README.md "unlabelled windows of the tested size \`strike-twin\` has $(twin_by cdan) to $(twin_by dann), by the \
same network without them $(twin_by wdcnn-orders)."
  identified() {
    awk -v method="$1" -v parameter="$2" -F' *[|] *' '/^## Scatter/ { exit }
      NF > 4 && $2 != "" { of = $2 } NF > 4 && $3 != "" { what = $3 }
      of == method && what == parameter && $4 == "all" { print $5; exit }' \
      "$reference/random/simulated/identifiability.md" | tr -d ' '
  }
  expect_said README.md "(R² $(mean 0 "$(identified piae-dt stiffness)"), $(mean 0 "$(identified piae-dt damping)")); \
\`piae-dt-phase\` does ($(mean 3 "$(identified piae-dt-phase stiffness)"), $(mean 3 "$(identified piae-dt-phase damping)"))."
}

# Fails unless docs/results.md has this row.
expect_row() { # cell...
  local row cell
  for cell in "$@"; do row+=" $cell |"; done
  expect_said docs/results.md "|$row"
}

test_the_papers_task() {
  local method ratio cells
  expect_row "\`none\` (paper: 62.0)" "$(percent random/cwru.csv none wdcnn 100to1)" \
    "$(percent random/hit-sm.csv none wdcnn 100to1)"
  expect_row "\`none\` by \`nearest\`, on spectra" "$(percent random/cwru.csv none nearest 100to1)" \
    "$(percent random/hit-sm.csv none nearest 100to1)"
  for method in cwru/{piae-dt,smote,dynamics,oversample,shift,piae-dt-phase,oracle} \
    hit-sm/{piae-dt,physics,shift,piae-dt-phase,oracle}; do
    cells=()
    for ratio in 50to1 10to1 2to1 1to1; do
      cells+=("$(percent "random/${method%/*}.csv" "${method#*/}" wdcnn $ratio)")
    done
    method=\`${method#*/}\`
    expect_row "${method/%\`oracle\`/\`oracle\` (real windows)}" "${cells[@]}"
  done
}

# Prints the mean score of the generated windows of a method, over ten seeds.
quality() { # stored numbers, method, quantity, decimals
  rounded "$4" "$(awk -F, -v method="$2" -v quantity="$3" '$1 == method && $4 == quantity { n++; sum += $6 }
    END { if (n == 10) printf "%.6f", sum / n }' "$reference/$1")"
}

# Prints the differences of two methods at the six ratios, or of a method and none.
differences_by_ratio() { # stored numbers, method, other method, decimals
  local ratio of other
  for ratio in 50to1 25to1 10to1 5to1 2to1 1to1; do
    of=$(accuracy "$1" "$2" wdcnn $ratio)
    other=$(accuracy "$1" "$3" wdcnn "$([[ $3 == none ]] && echo 100to1 || echo $ratio)")
    rounded "$4" "$(awk -v of="${of%±*}" -v other="${other%±*}" 'BEGIN { printf "%.6f", of - other }')"
    echo
  done
}
differences() { differences_by_ratio "$@" | sort -g | sed -n '1p; $p'; } # the least and the greatest

# Prints how windows of piae-dt compare with real ones: percent of the amplitude, dB between the spectra, dB that fault
# lines are weaker.
like_real() { # stored numbers
  awk -v part="$(quality "$1" piae-dt amplitude_ratio 4)" -v apart="$(quality "$1" piae-dt spectral_distance_db 4)" \
    -v weaker="$(quality "$1" piae-dt fault_line_difference_db 4)" \
    'BEGIN { printf "%.0f\n%.0f\n%.1f\n", 100 * part, apart, -weaker }'
}

test_the_papers_claims() {
  local cwru hit_sm
  # Keeps what a command prints of the stored numbers, which are its first argument.
  of_both() { # command, its further arguments
    mapfile -t cwru < <("$1" random/cwru.csv "${@:2}")
    mapfile -t hit_sm < <("$1" random/hit-sm.csv "${@:2}")
  }
  said() { expect_said docs/claims.md "$1"; }
  of_both least_and_most piae-dt
  said "| ${cwru[0]} to ${cwru[1]}; HIT-SM ${hit_sm[0]} to ${hit_sm[1]} | not reproduced |"
  of_both differences piae-dt none 1
  said "| ${cwru[1]} to ${cwru[0]}; HIT-SM ${hit_sm[1]} to ${hit_sm[0]} | not reproduced |"
  of_both differences ae piae-dt 0
  said "Model 2 ${cwru[0]} to ${cwru[1]} points"
  of_both differences physics piae-dt 0
  said "Model 3 ${cwru[0]} to ${cwru[1]}. HIT-SM"
  said "Model 3 +${hit_sm[0]} to +${hit_sm[1]} |"
  local in_words=(none one two three four five six)
  losses() { # number of the six ratios at which these methods are all below Model 1
    local method
    for method; do differences_by_ratio random/cwru.csv "$method" piae-dt 9 | cut -c1 | paste -sd ' '; done |
      awk '{ for (i = 1; i <= NF; i++) lost[i] += $i == "-" } END { for (i in lost) n += lost[i] == NR; print n + 0 }'
  }
  expect_equal "$(losses physics)" "$(losses ae)"
  said "CWRU in sign, each at ${in_words[$(losses ae)]} of six ratios, both at ${in_words[$(losses ae physics)]}; HIT-SM for Model 2"
  of_both least_and_most piae-dt-tcn
  said "CWRU: $(rounded 0 "${cwru[0]}") to $(rounded 0 "${cwru[1]}") % and"
  said "HIT-SM: $(rounded 0 "${hit_sm[0]}") to $(rounded 0 "${hit_sm[1]}") and"
  said "MMD² $(quality random/cwru.csv piae-dt mmd 2) is the highest (\`dynamics\` $(quality random/cwru.csv dynamics mmd 2);"
  said "RMSE $(quality random/cwru.csv piae-dt rmse 3) third. HIT-SM: $(quality random/hit-sm.csv piae-dt mmd 2), highest; $(
    quality random/hit-sm.csv piae-dt rmse 3
  ), second"
  of_both like_real
  said "${cwru[0]} % of their amplitude, spectra ${cwru[1]} dB apart, fault lines ${cwru[2]} dB weaker; HIT-SM ${hit_sm[0]} %, \
${hit_sm[1]} dB, ${hit_sm[2]} dB"
}

test_how_far_seeds_lie_apart() {
  expect_said docs/results.md "seeds lie up to $(cd "$reference" && awk -F, '$4 == "accuracy" {
      cell = FILENAME "," $1 "," $2 "," $3
      if (!(cell in least) || $6 < least[cell]) least[cell] = $6
      if (!(cell in most) || $6 > most[cell]) most[cell] = $6
    }
    END { for (cell in least) if (most[cell] - least[cell] > apart) apart = most[cell] - least[cell]
      printf "%.0f", 100 * apart }' {,rivals/}random/{cwru,hit-sm}.csv) points apart."
}

test_the_sweep_of_the_paper() {
  swept() { # parameter, value
    awk -v parameter="$1" -v value="$2" -F' *[|] *' '/^[|]/ { if ($4 == "ratio") of = $2 }
      of == parameter && $2 == value { split($5, numbers, " "); printf "%.1f", numbers[1] + 1e-7 }' \
      "$reference/random/cwru/sweep.md"
  }
  expect_said docs/claims.md "1:1 on CWRU, five seeds: $(swept batch 1) (1), $(swept batch 2) (2), $(swept batch 5) (5), $(
    swept batch 10
  ) (10), $(swept batch 20) (20)"
  expect_said docs/claims.md "$(swept depth 1) (1), $(swept depth 2), $(swept depth 3), $(swept depth 4) (4), $(
    swept depth 5
  ), $(swept depth 6) (6)"
  expect_said docs/claims.md "$(swept loss-weights adaptive), $(swept loss-weights adaptive-without-log), $(
    swept loss-weights fixed
  ); spread"
  expect_said docs/claims.md "$(swept learning-rate 1e-4) (1e-4), $(swept learning-rate 2e-4), $(
    swept learning-rate 5e-4
  ) (5e-4), $(swept learning-rate 1e-3), $(swept learning-rate 5e-3) (5e-3)"
}

test_another_speed_or_size() {
  local method dataset cells
  for method in none dynamics smote physics shift mixup aligned-mixup spectral adasyn borderline-smote resample randomise \
    strike-twin oracle; do
    cells=()
    for dataset in hit-sm-1200to900 hit-sm-1200to600 hit-sm-600to1200 ''; do
      cells+=("$(elsewhere $speeds $method "$dataset")")
    done
    cells+=("$(elsewhere $speeds $method '' kind)" "$(elsewhere $uestc $method)" "$(elsewhere $uestc_true $method)"
      "$(elsewhere $sizes $method)")
    expect_row "\`$method\`" "${cells[@]}"
  done
}

# Prints the mean over data sets of a stored sweep of strike-twin: the first number in the column of a setting's row.
swept_twin() { # setting, column, data set...
  rounded 1 "$(cd "$reference/effects/random" && awk -v setting="$1" -v column="$2" -F' *[|] *' '
    $2 == "setting" { at = 0; for (i = 3; i < NF; i++) if ($i == column) at = i }
    $2 == setting && at { split($at, numbers, " "); n++; sum += numbers[1] }
    END { if (n == 3) printf "%.6f", sum / n }' "${@:3}")"
}

test_the_effects_of_parts() {
  local speeds sizes rows row setting zero
  speeds=(hit-sm-{1200to900,1200to600,600to1200}/sweep@strike-twin.md)
  sizes=(cwru-sizes-{7,14,21}/sweep@strike-twin.md)
  rows=('none:as in the grid' 'lag of the known speed:edges=known' "eq. 13's resonance:response=ring"
    'windows cut at impacts:response=cut' 'no shared structure:own-structure=1' 'known impact rate:rhythm=known'
    'equal strengths:strengths=alike' 'no background:background=0' 'background of healthy colour:background-from=healthy'
    'no lag deviation:lag-deviation=0' 'no tilt:tilt=0')
  for row in "${rows[@]}"; do
    setting=${row#*:}
    expect_said docs/strike-twin.md "| ${row%%:*} | $(swept_twin "$setting" accuracy "${speeds[@]}") | $(
      swept_twin "$setting" 'by fault type' "${speeds[@]}"
    ) | $(swept_twin "$setting" accuracy "${sizes[@]}") |"
  done
  spread() { # table...
    (cd "$reference/effects/random" && grep -h -m 1 '^| as in the grid' "$@") | awk '{ print $9 }' | sort -g |
      awk '{ s[NR] = $1 } END { printf "%.0f to %.0f", s[1], s[NR] }'
  }
  expect_said docs/strike-twin.md "Seeds spread by $(spread "${speeds[@]}") points (sizes $(spread "${sizes[@]}"))"
  zero=$reference/effects/blocked/cwru-types-zero/sweep@piae-dt-zero.md
  for setting in level-to-db=10 ball-random=0 stray-knocks=0 both-races=1 ball-track=1 path-db=0 load-zone=off; do
    row=$(awk -v setting="$setting" -F' *[|] *' '$2 == setting {
      split($5, difference, " "); gsub(/[][]/, "", $6); print difference[1] " (" $6 ")" }' "$zero")
    expect_said docs/piae-dt-zero.md "(\`$setting\`) | $row |"
  done
}

# Prints Wilcoxon's two-sided p of paired differences, one in a line: the share of all changes of their signs that make
# the sum of signed ranks as large.
wilcoxon() {
  awk '$1 != 0 { d[++n] = $1 }
    function size(x) { return x < 0 ? -x : x }
    END {
      for (i = 1; i <= n; i++) {
        rank[i] = 0.5
        for (j = 1; j <= n; j++) rank[i] += size(d[j]) < size(d[i]) - 1e-12 ? 1 : size(d[j]) < size(d[i]) + 1e-12 ? 0.5 : 0
        own += d[i] > 0 ? rank[i] : -rank[i]
      }
      for (signs = 0; signs < 2 ^ n; signs++) {
        sum = 0
        for (i = 1; i <= n; i++) sum += int(signs / 2 ^ (i - 1)) % 2 ? rank[i] : -rank[i]
        as_large += size(sum) > size(own) - 1e-9
      }
      printf "%.6f\n", as_large / 2 ^ n
    }'
}

# Prints p values, one in a line, after the correction of Holm.
holm() {
  awk '{ p[NR] = $1 }
    END {
      for (step = 1; step <= NR; step++) {
        least = 0
        for (i = 1; i <= NR; i++) if (!(i in done) && (!least || p[i] < p[least])) least = i
        done[least] = 1
        highest = p[least] * (NR - step + 1) > highest ? p[least] * (NR - step + 1) : highest
        corrected[least] = highest < 1 ? highest : 1
      }
      for (i = 1; i <= NR; i++) printf "%.6f\n", corrected[i]
    }'
}

# The ranks 1 to 5 with the sign of the lowest changed: 4 of 32 sums are as large. For 10 differences the least p is 2/1024.
test_the_tests_of_significance() {
  expect_equal "$(printf '%s\n' -0.1 0.2 0.3 0.4 0.5 | wilcoxon)" 0.125000
  expect_equal "$(seq 10 | wilcoxon)" 0.001953
  expect_equal "$(printf '%s\n' 0.01 0.04 0.03 | holm | xargs)" '0.030000 0.060000 0.060000'
}

test_what_adaptation_gains() {
  local group classifier table gains=() p
  for classifier in dann cdan; do
    for group in speeds sizes; do
      table=classifiers/blocked/transfer@$group.csv
      paste <(of_seeds "$table" strike-twin '' accuracy $classifier) \
        <(of_seeds "$table" strike-twin '' accuracy wdcnn-orders) | awk '{ printf "%.9f\n", $1 - $2 }' >differences
      gains+=("$(mean 1 "$(spread <differences)")")
      wilcoxon <differences >>p_values
    done
  done
  mapfile -t p < <(holm <p_values)
  expect_said docs/generative-models.md "\`dann\` by ${gains[0]} points at other speeds (p = $(rounded 3 "${p[0]}")) and ${gains[1]} in"
  expect_said docs/generative-models.md "(p = $(rounded 2 "${p[1]}")), \`cdan\` by ${gains[2]} and ${gains[3]} (p = $(rounded 2 "${p[2]}"))"
  expect_equal "$(rounded 2 "${p[2]}")" "$(rounded 2 "${p[3]}")"
}

# Prints the least and the largest number of diffusion and flow.
range_of_diffusion() { # function that prints the number of its first argument, a method; its other arguments
  local method least_first
  mapfile -t least_first < <(for method in {ddpm,ddpm-healthy,flow}{,-angle}; do
    "$1" "$method" "${@:2}" && echo
  done | sort -g)
  printf '%s to %s' "${least_first[0]}" "${least_first[5]}"
}

# Prints a method's mean accuracy over five seeds of three pairs of speeds of UESTC.
on_uestc() { # method, classifier
  local ratio=1to1
  [[ $1 != none ]] || ratio=100to1
  rounded 1 "$(cat "$reference"/classifiers/blocked/uestc-*.csv | awk -F, -v cell="$1,$2,$ratio,accuracy" '
    $1 "," $2 "," $3 "," $4 == cell { n++; sum += 100 * $6 } END { if (n == 15) printf "%.6f", sum / n }')"
}

# Prints the mean magnitude of a score of a method's windows over five seeds of three data sets that test another
# condition.
scored() { # method, pattern of data sets, quantity, decimals
  # shellcheck disable=SC2086 # a pattern
  rounded "$4" "$(cat "$reference"/rivals/random/$2.csv | awk -F, -v cell="$1,,,$3" '
    $1 "," $2 "," $3 "," $4 == cell { n++; sum += $6 < 0 ? -$6 : $6 } END { if (n == 15) printf "%.6f", sum / n }')"
}
test_windows_for_another_condition() {
  local quantity datasets least_first diffusion='| diffusion, flow' page=docs/generative-models.md
  local shift="| \`shift\`" twin_row="| \`strike-twin\`"
  local costs="$reference/rivals/random/hit-sm-1200to600/figures/cost@wdcnn-orders.csv"
  for quantity in 'fault_line_difference_db 1' 'spectral_distance_db 1' 'mmd 2'; do
    for datasets in 'hit-sm-*to*' 'cwru-sizes-*'; do
      # shellcheck disable=SC2086 # a quantity and its decimals
      {
        diffusion+=" | $(range_of_diffusion scored "$datasets" $quantity)"
        shift+=" | $(scored shift "$datasets" $quantity)"
        twin_row+=" | $(scored strike-twin "$datasets" $quantity)"
      }
    done
  done
  expect_said $page "$diffusion |"
  expect_said $page "$shift |"
  expect_said $page "$twin_row |"
  mapfile -t least_first < <(awk -F, '/^(ddpm|flow)/ { print $5 }' "$costs" | sort -g)
  expect_said $page "take $(rounded 0 "${least_first[0]}") to $(rounded 0 "${least_first[5]}") s (Zen 4), \`strike-twin\` $(
    rounded 1 "$(awk -F, '$1 == "strike-twin" { print $5 }' "$costs")"
  ) s."
}

test_adaptation_on_uestc() {
  expect_said docs/generative-models.md "\`strike-twin\` $(on_uestc strike-twin wdcnn-orders) and $(
    on_uestc strike-twin cdan
  ), \`shift\` $(on_uestc shift wdcnn-orders) and $(on_uestc shift cdan), diffusion and flow $(
    range_of_diffusion on_uestc wdcnn-orders
  ) and $(range_of_diffusion on_uestc cdan), \`none\` $(
    on_uestc none wdcnn-orders
  ) and $(on_uestc none cdan); by \`nearest-orders\` $(on_uestc none nearest-orders)."
}

test_generative_models() {
  local method dataset cells classifier
  for method in vae ddpm ddpm-healthy flow ddpm-angle ddpm-healthy-angle flow-angle shift strike-twin \
    piae-dt-phase oracle; do
    cells="| \`$method\`"
    cells=${cells/%\`oracle\`/\`oracle\`, real windows}
    for dataset in cwru hit-sm; do
      cells+=" | $(mean 1 "$(accuracy rivals/random/$dataset.csv $method wdcnn 1to1)")"
    done
    expect_said docs/generative-models.md "$cells |"
  done
  for dataset in speeds sizes; do
    for method in none shift strike-twin; do
      cells="| $dataset, \`$method\`"
      for classifier in nearest-orders wdcnn-orders dann cdan; do
        cells+=" | $(mean 1 "$(transferred classifiers/blocked/transfer@$dataset.csv $method '' accuracy $classifier)")"
      done
      expect_said docs/generative-models.md "$cells |"
    done
  done
}

test_no_fault_known() {
  local classifier method cells dataset
  decided() { # method, classifier, windows
    rounded 1 "$(cell blocked/cwru-types-zero/tables.md \
      "Decisions over several windows of a record on cwru-types-zero, percent, by $2" "$1" "$3" | tr -d ' ')"
  }
  answered() { # data set, method, classifier
    mean 0 "$(cell "blocked/$1/tables.md" "Share answered at 95 % precision on $1, percent, by $3" "$2" answered | tr -d ' ')"
  }
  for classifier in envelope-rule exclusion-rule any-bearing; do
    expect_row "\`$classifier\`" "$(percent blocked/cwru-types-zero.csv none $classifier 100to1)" \
      "$(decided none $classifier '10 windows')" "$(decided none $classifier '60 windows')" \
      "$(answered cwru-types-zero none $classifier)"
    mapfile -t cells < <(untaught 1 $classifier)
    expect_said docs/results.md "| \`$classifier\` | ${cells[1]} | ${cells[2]} | ${cells[3]}"
  done
  for method in healthy-plus-impulses piae-dt-zero; do
    expect_row "\`$method\` by \`symptom-net\`" "$(percent blocked/cwru-types-zero.csv $method symptom-net 1to1)" \
      "$(decided $method symptom-net '10 windows')" "$(decided $method symptom-net '60 windows')" \
      "$(answered cwru-types-zero $method symptom-net)"
    cells=()
    for dataset in hit-sm uestc uestc-true; do
      cells+=("$(mean 1 "$(accuracy blocked/$dataset-types-zero.csv $method symptom-net 1to1)")")
    done
    expect_said docs/results.md "| \`$method\` by \`symptom-net\` | ${cells[0]} | ${cells[1]} | ${cells[2]}"
  done
  cells=()
  for dataset in cwru uestc uestc-true; do
    for method in piae-dt-zero healthy-plus-impulses; do cells+=("$(answered $dataset-types-zero $method symptom-net)"); done
  done
  expect_said docs/results.md "may answer ${cells[0]} % of CWRU's windows (the common recipe ${cells[1]}), ${cells[2]} of \
UESTC's (${cells[3]}), by true speeds ${cells[4]} (${cells[5]})"
}

test_calibration() {
  local place row first
  trusted() { # page, row, column
    cell "$1" 'How sure a classifier says it is, and how often it is right, percent' "$2" "$3" | tr -d ' '
  }
  for place in random/cwru random/hit-sm blocked/cwru blocked/hit-sm; do
    for row in 'none|100:1' 'shift|1:1' 'none by nearest|100:1'; do
      [[ $row != *nearest* || $place == */cwru ]] || continue
      first=\`${row%|*}\`
      first=${first/ by /\` by \`}
      expect_said docs/results.md "| $first | $(trusted $place/trust.md "$row" accuracy) | $(
        trusted $place/trust.md "$row" 'error as is'
      ) | $(trusted $place/trust.md "$row" calibrated) |"
    done
  done
}

run_tests "$@"
