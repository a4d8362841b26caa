#!/bin/bash
# Makes the files that the storm damages: one small artefact of every kind and method; the options of the stage that
# reads each (`consumers`: a line each, "FILE STAGE OPTION..."); raw recordings of every format, with descriptions and
# settings, in inputs/, one folder for each reader.
# usage: tests/slow/storm/corpus.sh FOLDER BIN      (BIN: the programs, storm_raw among them)
set -euo pipefail

project=$(realpath "${BASH_SOURCE[0]%/*}/../../..")
mkdir -p "$1/artefacts"
folder=$(realpath "$1") bin=$(realpath "$2")
export OMP_NUM_THREADS=1
cd "$folder/artefacts"

bearing='sample_rate_hz = 12000
shaft_speed_rpm = 1797
[bearing]
balls = 9
ball_diameter_mm = 7.94
pitch_diameter_mm = 39.0
inner_raceway_mm = 31.06
outer_raceway_mm = 46.94
contact_angle_deg = 0
'
classes='[[class]]
name = "Normal"
defect = "none"
[[class]]
name = "IR007"
defect = "inner"
defect_size_mm = 0.1778
[[class]]
name = "OR021"
defect = "outer"
defect_size_mm = 0.5334
'
simulation='[simulation]
seed = 0
records_per_class = 2
record_s = 0.2
mass_kg = 1.0
stiffness_n_per_m = 1e8
stiffness_spread = 0.1
damping_ns_per_m = 500
damping_spread = 0.2
clearance_um = 2.0
load_n = 1000
slip_max = 0.01
speed_spread = 0.001
snr_db = 10
'
# ---- artefacts ----------------------------------------------------------------------------------
stage() { "$bin/$1" "${@:2}" >/dev/null || { echo "storm: no corpus: $* failed" >&2; exit 1; }; }
consumer() { echo "$*" >>consumers; }

: >consumers
printf '%s' $'name = "tiny"\n' "$bearing" "$classes" "$simulation" >tiny.toml
stage simulate --description tiny.toml --output records.h5
split=(--seed 0 --window 1024 --max-stride 64 --windows-per-class 30 --test-per-class 8 --known-per-class 5)
stage split --records records.h5 "${split[@]}" --output-dir .
consumer records.h5 split --records records.h5 "${split[@]}" --output-dir out

# Faults known at one speed and tested at another.
speeds='[[simulation.condition]]
name = "900 rpm"
shaft_speed_rpm = 900
[[simulation.condition]]
name = "1200 rpm"
shaft_speed_rpm = 1200
'
transfer='[transfer]
known = ["900 rpm"]
test = ["1200 rpm"]
'
printf '%s' $'name = "speeds"\n' "$bearing" "$classes" "$simulation" "$speeds" "$transfer" >speeds.toml
stage simulate --description speeds.toml --output speeds.h5
stage split --records speeds.h5 "${split[@]}" --output-dir speeds
consumer speeds.h5 split --records speeds.h5 "${split[@]}" --output-dir out
consumer speeds/C.h5 train --method dynamics --known speeds/C.h5 --seed 0 --output out.h5

for method in resample randomise strike-twin piae-dt-zero healthy-plus-impulses; do
  healthy=()
  [[ ! $method =~ ^(strike-twin|piae-dt-zero|healthy-plus-impulses)$ ]] || healthy=(--healthy speeds/B.h5)
  stage train --method $method --known speeds/C.h5 "${healthy[@]}" --seed 0 --output $method.model.h5
  consumer $method.model.h5 generate --model $method.model.h5 --count 5 --seed 0 --output out.h5
done
stage generate --model strike-twin.model.h5 --count 5 --seed 0 --output speeds/E.h5
consumer speeds/E.h5 score --generated speeds/E.h5 --real speeds/D.h5 --output out.h5

# A machine with unknown bearing and a fault elsewhere.
sed -E '/^\[bearing\]/,/^contact_angle_deg/d; /^defect_size_mm/d; /^\[simulation\]/,$d; s/^defect = "(inner|outer)"/defect = "other"/
  s/"tiny"/"loose"/' tiny.toml >loose.toml
seed=0
for class in Normal IR007 OR021; do
  awk -v seed="$((++seed))" 'BEGIN { srand(seed); for (i = 0; i < 4000; ++i) print rand() - 0.5 }' >$class.csv
  printf '[[record]]\nclass = "%s"\nfile = "%s.csv"\nvariable = "1"\nsample_rate_hz = 12000\n' $class $class >>loose.toml
done
awk 'BEGIN { for (i = 0; i < 12; ++i) printf "%.6f\n", i / 30 }' >turns.csv # of the last record
echo 'shaft_speed_rpm = { file = "turns.csv", variable = "1" }' >>loose.toml
stage ingest --description loose.toml --data-dir . --output loose.h5
stage split --records loose.h5 "${split[@]}" --output-dir loose
consumer loose.h5 split --records loose.h5 "${split[@]}" --output-dir out
consumer loose/C.h5 train --method smote --known loose/C.h5 --seed 0 --output out.h5

networks=(--epochs 2 --width 4)
train() { # method, option...
  stage train --method "$1" --known C.h5 --seed 0 "${@:2}" --output "$1.model.h5"
  consumer "$1.model.h5" generate --model "$1.model.h5" --count 5 --seed 0 --output out.h5
}
train piae-dt "${networks[@]}"
train piae-dt-tcn "${networks[@]}"
train piae-dt-transformer "${networks[@]}"
train piae-dt-phase "${networks[@]}" --simulations 60 --inference-epochs 2 --inference-width 16
train ae "${networks[@]}"
train vae "${networks[@]}"
train wgan-gp "${networks[@]}"
diffusion=(--epochs 2 --channels 16 --blocks 1 --steps 2)
train ddpm "${diffusion[@]}"
train ddpm-healthy "${diffusion[@]}" --healthy-epochs 1 --healthy B.h5
train flow "${diffusion[@]}"
train physics --stiffness-grid 3 --damping-grid 2
train dynamics
train smote
train oversample
train shift
train mixup
train spectral
train adasyn --healthy B.h5
train borderline-smote --healthy B.h5
train oracle --real D.h5
for method in piae-dt-phase smote; do # their windows record start angles and parents
  stage generate --model $method.model.h5 --count 5 --seed 0 --output $method.E.h5
  consumer $method.E.h5 score --generated $method.E.h5 --real D.h5 --output out.h5
  consumer $method.E.h5 export_windows --windows $method.E.h5 --output out.mat
done
consumer C.h5 train --method piae-dt --known C.h5 --seed 0 "${networks[@]}" --output out.h5
stage generate --model piae-dt.model.h5 --count 5 --seed 0 --output E.h5

cell=run/tiny/seed0
diagnose=(diagnose --test A.h5 --normal B.h5 --known C.h5 --generated E.h5 --ratio 50to1 --seed 0
  --epochs 1 --reproducible)
baseline=(diagnose --test A.h5 --normal B.h5 --known C.h5 --ratio 100to1 --seed 0 --epochs 1 --reproducible)
stage score --generated E.h5 --real D.h5 --output $cell/piae-dt/score.h5
stage "${baseline[@]}" --output $cell/none/100to1/wdcnn/diagnosis.h5
stage "${baseline[@]}" --classifier nearest --output $cell/none/100to1/nearest/diagnosis.h5
stage "${diagnose[@]}" --output $cell/piae-dt/50to1/wdcnn/diagnosis.h5
stage "${diagnose[@]}" --keep-features --output $cell/piae-dt/50to1/wdcnn/features.h5
for file in A B C E; do consumer $file.h5 "${diagnose[@]}" --output out.h5; done
for file in D E; do consumer $file.h5 score --generated E.h5 --real D.h5 --output out.h5; done
for file in $cell/piae-dt/score.h5 $cell/piae-dt/50to1/wdcnn/diagnosis.h5 $cell/none/100to1/nearest/diagnosis.h5; do
  consumer "$file" tabulate --run run --dataset tiny --methods none piae-dt --ratios 100to1 50to1 --seeds 0 \
    --published "$project/results/published"
done

# Keeps one classifier of every learned kind, and one classification of a recording. A refusal names the classifier or
# the unfitting recording, so the recording's name contains the classifier's.
keep=(diagnose --test A.h5 --normal B.h5 --known C.h5 --ratio 100to1 --seed 0 --epochs 1)
awk 'BEGIN { srand(1); for (i = 0; i < 4096; ++i) printf "%.6f\n", sin(i / 3) + rand() }' >classifier.h5.csv
classify=(--recording classifier.h5.csv --variable 1 --sample-rate-hz 12000 --speed-rpm 1797)
for classifier in wdcnn nearest exclusion-rule symptom-net nearest-orders prototypes; do
  kept=$cell/none/100to1/$classifier/classifier.h5
  stage "${keep[@]}" --classifier $classifier --keep-classifier $kept
  consumer $kept classify --classifier $kept "${classify[@]}" --csv out.csv --picture out.svg --output out.h5
done
consumer $cell/none/100to1/wdcnn/classifier.h5 trust --run run --dataset tiny --methods none --ratios 100to1 --seeds 0 \
  --classifiers wdcnn
for classifier in wdcnn nearest; do
  kept=$cell/none/100to1/$classifier
  stage classify --classifier $kept/classifier.h5 --records records.h5 --output $kept/classification.h5
  consumer $kept/classification.h5 verdicts --run run --dataset tiny --methods none --ratios 100to1 --seeds 0 \
    --classifiers wdcnn
done
consumer D.h5 "${baseline[@]}" --classifier dann --unlabelled D.h5 --output out.h5
stage teach --machines 3 --output any-bearing.h5
consumer any-bearing.h5 "${baseline[@]}" --classifier any-bearing --network any-bearing.h5 --output out.h5

# Keeps the baseline of a machine, with fault lines: eight windows of a record.
stage monitor --healthy 0.00005 --window-s 0.024 --records records.h5 --record Normal-01 --keep-baseline baseline.h5
consumer baseline.h5 monitor --baseline baseline.h5 --records records.h5 --record Normal-02 --picture out.svg

# A stopped training leaves a checkpoint.
long=(--method vae --known C.h5 --seed 0 --epochs 400 --width 4 --output long.h5)
for delay in 0.1 0.2 0.05 0.4 0.02 0.8; do
  [[ ! -f long.h5.checkpoint ]] || break
  rm -f long.h5
  timeout --preserve-status --signal=TERM $delay "$bin/train" "${long[@]}" >/dev/null 2>&1 || true
done
if [[ -f long.h5.checkpoint ]]; then
  consumer long.h5.checkpoint train "${long[@]}"
else
  rm -f long.h5
fi

# ---- inputs other than artefacts ----------------------------------------------------------------
mkdir -p "$folder"/inputs/{mat,csv,hdf5,sound,npy,tdms,uff,lvm,description,simulation,protocol,published,artefact}
cd "$folder/inputs"
"$bin/storm_raw" .
{
  echo "x,y"
  awk 'BEGIN { for (i = 0; i < 60; ++i) printf "%.6f,%d\n", sin(i), i }'
} >csv/comma.csv
awk 'BEGIN { for (i = 0; i < 40; ++i) printf "%d;%.3e;text\r\n", i, cos(i) }' >csv/semicolon.csv
samples() { head -c 480 "$1" | tail -c 240; } # any 16-bit samples
npy="{'descr': '<i2', 'fortran_order': False, 'shape': (120,), }"
{
  printf '\x93NUMPY\x01\x00\x76\x00%-117s\n' "$npy"
  samples csv/semicolon.csv
} >npy/vector.npy
{
  printf 'RIFF\x14\x01\x00\x00WAVEfmt \x10\x00\x00\x00\x01\x00\x01\x00'
  printf '\xE0\x2E\x00\x00\xC0\x5D\x00\x00\x02\x00\x10\x00data\xF0\x00\x00\x00'
  samples csv/semicolon.csv
} >sound/pcm.wav
function58() { # binary or not, ordinate type
  printf '    -1\n    58%s\nBearing 1\nNONE\nNONE\nNONE\nNONE\n' "$1"
  printf '    1         0    0         0 NONE               0   0 NONE               0   0\n'
  printf '%10d       120         1  0.00000E+00  8.33333E-05  0.00000E+00\n' "$2"
  printf '%10d    0    0    0 NONE                 NONE                \n' 17 12 0 0
}
for _ in 1 2; do
  function58 '' 2
  awk 'BEGIN { for (i = 1; i <= 120; ++i) printf "%13.5E%s", sin(i), i % 6 ? "" : "\n" }'
  echo '    -1'
done >uff/text.uff
for _ in 1 2; do
  function58 'b     1     2          11         480     0     0           0           0' 2
  samples csv/semicolon.csv
  samples csv/semicolon.csv
  printf '\n    -1\n'
done >uff/binary.uff
lvm() { # headings of segments, columns of times, names, samples
  printf 'LabVIEW Measurement\t\nSeparator\tTab\nDecimal_Separator\t.\nMulti_Headings\t%s\n' "$1"
  printf 'X_Columns\t%s\n***End_of_Header***\t\n\t\nChannels\t2\t\t\nSamples\t%b\t\n' "$2" "$4"
  printf 'X_Dimension\tTime\tTime\t\nDelta_X\t0.0001\t0.0001\t\n***End_of_Header***\t\t\nX_Value\t%b\tComment\n' "$3"
}
{
  lvm No One 'x\ty' '10\t5'
  awk 'BEGIN { for (i = 0; i < 60; ++i) printf "%.4f\t%.6f\t%s\n", i / 1e4, sin(i), i % 10 < 5 ? i : "" }'
} >lvm/one.lvm
{
  lvm Yes No 'x\ty' '60\t60'
  awk 'BEGIN { for (i = 0; i < 60; ++i) printf "\t%.6f\t%d\n", sin(i), i }'
} >lvm/no.lvm
{
  lvm Yes Multi 'x\tX_Value\ty' '60\t\t60'
  awk 'BEGIN { for (i = 0; i < 60; ++i) printf "%.4f\t%.6f\t%.4f\t%d\n", i / 1e4, sin(i), i / 1e4, i }'
} >lvm/multi.lvm
printf '\xEF\xBB\xBF"x"\t"y"\n1\t2\n3\t4\n' >csv/tabs.csv

record() { # class, file, variable
  printf '[[record]]\nclass = "%s"\nfile = "%s"\nvariable = "%s"\nsample_rate_hz = 12000\n' "$@"
}
{
  printf '%s' $'name = "raw"\nunit_m_per_s2 = 9.80665\n' "$bearing" "$classes"
  record Normal rig/a.mat x
  echo 'url = "https://example.org/a.mat"'
  record IR007 rig/b.csv 1
  printf 'sha256 = "%064d"\n' 0
  echo 'shaft_speed_rpm = "2"'
  record OR021 rig/c.h5 /x
  echo 'shaft_speed_rpm = { file = "rig/turns.csv", variable = "1", pulses_per_turn = 2 }'
} >description/raw.toml
printf '%s\n' '[[record]]' 'class = "IR007"' 'condition = "900 rpm"' 'file = "rig/d.csv"' 'variable = "1"' \
  'sample_rate_hz = 12000' 'shaft_speed_rpm = 900' 'defect_size_mm = 0.3' |
  cat description/raw.toml - >description/conditions.toml
printf '%s\n' 'name = "transfer"' 'like = "conditions"' '[transfer]' 'known = ["900 rpm"]' 'test = ["1200 rpm"]' \
  '[split]' 'window = 4096' '[[record]]' 'class = "Normal"' 'file = "a.mat"' 'variable = "x"' \
  'sample_rate_hz = 12000' >description/transfer.toml
for class in IR007 OR021; do
  for rpm in 900 1200; do
    printf '%s\n' '[[record]]' "class = \"$class\"" "condition = \"$rpm rpm\"" "file = \"$class$rpm.mat\"" \
      'variable = "x"' 'sample_rate_hz = 12000'
  done
done >>description/transfer.toml
cp ../artefacts/tiny.toml ../artefacts/speeds.toml simulation/
# A file for each top-level table, without comments: one change is read with less else.
sed 's/[[:space:]]*#.*//' "$project/pipeline/protocol.toml" |
  awk '/^\[/ { match($0, /[a-z]+/); name = substr($0, RSTART, RLENGTH) } NF { print >("protocol/" name ".toml") }'
cp "$project"/results/published/*.csv published/
while read -r file _; do cp "../artefacts/$file" "artefact/${file//\//-}"; done <../artefacts/consumers
