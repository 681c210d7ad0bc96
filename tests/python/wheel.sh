#!/usr/bin/env bash
# wheel.sh PYTHON SOURCE BUILD: pip makes a wheel, which works in an environment of its own.
set -euo pipefail
python=$1 source=$2 build=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$python" -c 'import ensurepip, venv' 2>/dev/null || { echo "no venv"; exit 77; }
unset PYTHONPATH
"$python" -m venv --system-site-packages "$work/env"
pip=("$work/env/bin/python" -m pip --disable-pip-version-check --no-input)
"${pip[@]}" --version || { echo "no pip"; exit 77; }
"${pip[@]}" wheel --quiet --no-index --no-deps --no-build-isolation --config-settings=build-dir="$build" -w "$work" "$source"
"${pip[@]}" wheel --quiet --no-index --no-deps --config-settings=build-dir="$build" -w "$work/isolated" "$source"
cmp "$work"/af2-*.whl "$work"/isolated/af2-*.whl  # nothing of the environment is in it
"${pip[@]}" install --quiet --no-index --no-deps "$work"/af2-*.whl
cd "$work"
"$work/env/bin/python" - "$source" "$work" <<'PYTHON'
import importlib.metadata, pathlib, sys
import af2
source, work = sys.argv[1:]
assert af2.__file__.startswith(work), af2.__file__
assert importlib.metadata.version("af2") == af2.__version__
assert {"py.typed", "_af2.pyi"} <= {path.name for path in pathlib.Path(af2.__file__).parent.iterdir()}
mesh = af2.mesh(f"{source}/examples/models/die.step", size=1)
mesh.write(f"{work}/die.vtu")
assert mesh.complete and len(mesh.triangles) > 100
if list(pathlib.Path(af2.__file__).parent.glob("af2-med.so")):
    mesh.write(f"{work}/die.med")
PYTHON
"${pip[@]}" uninstall --quiet --yes af2
! "$work/env/bin/python" -c 'import af2' 2>/dev/null || { echo "the package is still there"; exit 1; }
echo "$(basename "$work"/af2-*.whl) works"
