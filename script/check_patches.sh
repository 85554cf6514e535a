#!/bin/sh
# Whether every script/price/*.patch still applies; prints each that does not, exit status 1.
set -eu
cd "$(dirname "$0")/.."
status=0
for p in script/price/*.patch; do
  patch --dry-run -s -f -p1 < "$p" > /dev/null || { echo "check_patches.sh: $p does not apply any more" >&2; status=1; }
done
exit $status
