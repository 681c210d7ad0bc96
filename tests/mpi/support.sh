# For the scripts of this folder: SCRIPT AF2 SOURCE AF2-MPI. Gives what the scripts of tests/cli have, and $mpi.
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../cli/support.sh"
command -v mpirun >/dev/null || exit 77
mpi=$3
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1  # as machines that build often do
export TMPDIR=$work  # for mpirun's and af2-mpi's own files

# on RANKS OPTION...: runs af2-mpi.
on() {
  local ranks=$1
  shift
  timeout 100 mpirun --oversubscribe --bind-to none -n "$ranks" "$mpi" "$@"
}
