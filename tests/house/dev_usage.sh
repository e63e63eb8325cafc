#!/bin/sh
# ./dev tells wrong usage from help: exit 2 with the verbs on stderr, exit 0 with them on stdout. usage: dev_usage.sh DEV
set -eu
status=0
said=$("$1" paint 2>&1 > /dev/null) || status=$?
[ "$status" -eq 2 ] || { echo "an unknown verb: exit $status, not 2"; exit 1; }
case "$said" in
  *paint*"usage: ./dev VERB"*) ;;
  *) echo "an unknown verb: unexpected message: $said"; exit 1 ;;
esac
"$1" help | grep -q 'usage: ./dev VERB' || { echo "help prints no usage"; exit 1; }
