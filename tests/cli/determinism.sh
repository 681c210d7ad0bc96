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

# Times of writing are in no file, if the libraries that write these are there.
for format in med exo cgns inp bdf glb; do
  "$af2" mesh "$models/die.step" --size 2 -o first.$format >/dev/null 2>&1 || continue
  sleep 1.1
  expect 0 "$af2" mesh "$models/die.step" --size 2 -o second.$format
  same first.$format second.$format
done
finish
