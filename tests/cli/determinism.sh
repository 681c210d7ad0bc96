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
finish
