#!/usr/bin/env bash
# The same command gives the same bytes, whatever the number of threads.
. "$(dirname "$0")/support.sh"

for model in brickhole die; do
  expect 0 "$af2" mesh "$models/$model.step" --size 0.5 --threads 1 -o one.vtu -o one.msh -o one.obj
  for threads in 1 2 7; do
    expect 0 "$af2" mesh "$models/$model.step" --size 0.5 --threads $threads -o two.vtu -o two.msh -o two.obj
    for format in vtu msh obj; do same one.$format two.$format; done
  done
done

# Planar domains are meshed by arithmetic alone: the C library chooses among versions of its functions by the processor.
star() {  # star POINTS RADIUS: of the inner corners
  awk -v n="$1" -v r="$2" 'BEGIN {
    print 2 * n, 2, 0, 0
    for (i = 0; i < 2 * n; ++i) {
      angle = 0.3 + 3.141592653589793 * i / n; radius = i % 2 ? r : 1
      printf "%d %.17g %.17g\n", i + 1, radius * cos(angle), radius * sin(angle)
    }
    print 2 * n, 0
    for (i = 1; i <= 2 * n; ++i) print i, i, i % (2 * n) + 1
    print 0
  }'
}
other_processor=GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4
while read -r points radius rules; do
  star "$points" "$radius" >star.poly
  expect 0 "$af2" mesh star.poly --size 0.06 --rules "$rules" -o one.vtu
  expect 0 env "$other_processor" "$af2" mesh star.poly --size 0.06 --rules "$rules" -o two.vtu
  same one.vtu two.vtu
done <<<'8 0.35 quad/rows
6 0.5 quad/paving
5 0.5 tri/even'

# Times of writing are in no file, if the libraries that write these are there.
for format in med exo cgns inp bdf glb; do
  "$af2" mesh "$models/die.step" --size 2 -o first.$format >/dev/null 2>&1 || continue
  sleep 1.1
  expect 0 "$af2" mesh "$models/die.step" --size 2 -o second.$format
  same first.$format second.$format
done
finish
