# Ranks the readings of the paper by their mean accuracy over data sets and ratios, and says what a stepwise
# search would try next: the best one with each setting of the others that it does not have yet.
# usage: awk -f rank_readings.awk FOLDER/readings.csv...
BEGIN { FS = "," }
FNR == 1 || $2 == "published" { next } # what the paper reports is no reading of it
$3 == "accuracy" {
  if (!($2 in sum)) order[++readings] = $2
  sum[$2] += $6
  count[$2]++
  if (count[$2] > most) most = count[$2]
}

function factor(setting) { return substr(setting, 1, index(setting, "=") - 1) }

# The settings of a reading in alphabetical order, so that each set of them has one name.
function name_of(settings, n,    i, j, held, name) {
  for (i = 2; i <= n; ++i) {
    held = settings[i]
    for (j = i - 1; j > 0 && settings[j] > held; --j) settings[j + 1] = settings[j]
    settings[j + 1] = held
  }
  for (i = 1; i <= n; ++i) name = name (i > 1 ? "+" : "") settings[i]
  return name
}

END {
  for (i = 1; i <= readings; ++i) {
    reading = order[i]
    n = split(reading, settings, "+")
    tried[name_of(settings, n)]
    if (count[reading] < most) continue # a data set or ratio is missing: it cannot be compared
    mean[reading] = sum[reading] / count[reading]
    ranked[++complete] = reading
  }
  for (i = 2; i <= complete; ++i) {
    held = ranked[i]
    for (j = i - 1; j > 0 && mean[ranked[j]] < mean[held]; --j) ranked[j + 1] = ranked[j]
    ranked[j + 1] = held
  }
  for (i = 1; i <= complete; ++i) printf "%6.2f  %s\n", mean[ranked[i]], ranked[i]
  best = ranked[1]
  of_best = best == "base" ? 0 : split(best, own, "+")
  for (i = 1; i <= of_best; ++i) has[factor(own[i])]
  for (i = 1; i <= readings; ++i) {
    if (order[i] == "base" || order[i] ~ /\+/ || factor(order[i]) in has) continue
    for (j = 1; j <= of_best; ++j) settings[j] = own[j]
    settings[of_best + 1] = order[i]
    next_one = name_of(settings, of_best + 1)
    if (!(next_one in tried)) print "to try next: " next_one
  }
}
