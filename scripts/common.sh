# shellcheck shell=bash
# Sourced by the scripts, which then stand in the root of the checkout.
CDPATH='' cd -- "$(dirname "${BASH_SOURCE[0]}")/.." || exit

# quietly NAME COMMAND...: one line with the name and the seconds it took. All the command prints goes to
# build/log/NAME.log, of which the end is shown if it fails. The command is a program or a function made of one list
# (a && b), since bash ignores `set -e` in here.
quietly() {
  local name=$1 log="build/log/$1.log" start=$SECONDS status=0
  shift
  mkdir -p build/log
  printf '%-12s' "$name"
  "$@" >"$log" 2>&1 </dev/null || status=$?
  if ((status == 0)); then
    printf '%4d s\n' $((SECONDS - start))
  else
    printf 'FAILED after %d s; the end of %s:\n' $((SECONDS - start)) "$log"
    # Tests that passed would push out those that did not.
    { grep -vE '^ +Start +[0-9]+: | Passed +[0-9.]+ sec$' "$log" || true; } | tail -n 100
  fi
  return "$status"
}
