#!/usr/bin/env bash
# CalculiX solves with the elements, sets and sides of .inp files: a strip that is pulled gets longer as it should.
. "$(dirname "$0")/support.sh"
command -v ccx >/dev/null || { echo "no CalculiX"; exit 77; }
export OMP_NUM_THREADS=1

cat >strip.poly <<'E'
4 2 0 0
1 0 0
2 10 0
3 10 2
4 0 2
4 1
1 1 2 3
2 2 3 2
3 3 4 4
4 4 1 1
0
E

# The boundary 2 is pulled by 1 for each unit of length; thickness 0.1, modulus 1000, length 10.
write_job() {
  echo "*INCLUDE, INPUT=mesh.inp"
  echo "*MATERIAL, NAME=M"; echo "*ELASTIC"; echo "1000., 0."
  echo "*SHELL SECTION, ELSET=all_elements, MATERIAL=M"; echo "0.1"
  echo "*STEP"; echo "*STATIC"
  echo "*BOUNDARY"; echo "boundary_1, 1, 1"; echo "boundary_3, 2, 2"; echo "all_nodes, 3, 3"
  echo "*DLOAD"
  for side in 1 2 3 4; do
    if grep -q "ELSET=boundary_2_side$side\$" mesh.inp; then echo "boundary_2_side$side, EDNOR$side, -1."; fi
  done
  echo "*NODE PRINT, NSET=boundary_2"; echo "U"; echo "*END STEP"
}

for order in 1 2; do
  for rules in tri/even quad/classic; do
    expect 0 "$af2" mesh strip.poly --size 0.7 --order "$order" -r "$rules.af2" -o mesh.inp
    write_job >job.inp
    expect 0 ccx job
    if grep -qE '\*(ERROR|WARNING)' out; then fail "CalculiX complains about order $order, $rules"; fi
    awk 'NF == 4 && $1 + 0 > 0 { ++n; if ($2 < 0.0999999 || $2 > 0.1000001 || $3 > 1e-9 || $3 < -1e-9) ++wrong }
         END { exit !(n >= 4 && !wrong) }' job.dat || fail "order $order, $rules: $(cat job.dat)"
  done
done

# Numbers have at most 20 columns, of which CalculiX reads no more.
expect 0 "$af2" mesh "$models/cylinder.brep" --size 1.7 -o round.inp
awk -F, '/^\*/ { inside = /^\*NODE/ }
         inside && !/^\*/ { for (i = 2; i <= 4; ++i) { gsub(/ /, "", $i); if (length($i) > 20) exit 1 } }' round.inp ||
  fail "numbers are too long"

finish
