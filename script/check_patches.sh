#!/bin/sh
# Whether every patch of script/price, by which the prices of features and promises are measured, still applies.
#   usage: script/check_patches.sh [root of the tree]
set -eu
cd "${1:-$(dirname "$0")/..}"
if ! command -v patch > /dev/null; then
  echo "no patch here, so script/price is not checked"
  exit 0
fi
failed=0
for file in script/price/*.patch; do
  [ -e "$file" ] || continue
  patch -p1 --dry-run --force --silent < "$file" > /dev/null || {
    echo "$file no longer applies: make its change to the sources again and store the difference (diff -U1)"
    failed=1
  }
done
exit $failed
