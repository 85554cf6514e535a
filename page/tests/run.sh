#!/bin/sh
# Tests the page of build/web: its engine in Node, and the page in Chromium and Firefox. What is missing is said and left out.
#   usage: page/tests/run.sh [folder of the build]
set -eu
cd "$(dirname "$0")/../.."
build=$(cd "${1:-build}" && pwd)
RAYPRO=$build/raypro RAYIMG=$build/rayimg WEB=$build/web SITE=$build/site
CHROMIUM=$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)
FIREFOX=$(command -v firefox-esr || command -v firefox || true)
export RAYPRO RAYIMG WEB SITE CHROMIUM FIREFOX

if ! [ -f "$WEB/raypro.wasm" ]; then
  echo "tests of the page: skipped, make web has not made it"
elif ! command -v node > /dev/null; then
  echo "tests of the page: skipped, there is no Node"
else
  node --test --test-reporter=spec page/tests/engine.mjs
  if [ -n "$CHROMIUM" ]; then
    node --test --test-reporter=spec page/tests/page.mjs
  else
    echo "tests of the page in a browser: skipped, there is no Chromium"
  fi
  if [ -n "$FIREFOX" ]; then
    node --test --test-reporter=spec page/tests/firefox.mjs
  else
    echo "tests of the page in another browser: skipped, there is no Firefox"
  fi
  if [ -d "$SITE" ]; then node --test --test-reporter=spec page/tests/site.mjs; fi
fi
