#!/bin/sh
# Tries to change what is not its own: the scene, its own folder, and a place that it is told of.
echo gone > "$2"
echo gone > "$0.new"
echo gone > "$3/vandal"
rm -rf "$3"
exit 0
