#!/bin/sh
# Draws the viewer as a user sees it: every panel and every way of looking, in both themes, at two sizes of the window.
#
#     script/viewer_screens.sh folder [scene]          scenes/hello.scn by default
#     SIZES="1280x800" script/viewer_screens.sh folder
#
# A file is called what-theme-size.png. Letters and lines are twice as large where the window is wider than 3000 pixels,
# as on screens that are twice as dense. RAYVIEW names the program (default build/rayview). No window is opened.
set -eu
here=$(cd "$(dirname "$0")/.." && pwd)
rayview=${RAYVIEW:-$here/build/rayview}
[ $# -ge 1 ] || { echo "viewer_screens.sh: which folder? See the top of $0" >&2; exit 2; }
folder=$1 scene=${2:-$here/scenes/hello.scn}
mkdir -p "$folder"

# shot theme size what: what comes before the picture is read from standard input.
shot() {
  wide=${2%x*} high=${2#*x} scale=1
  [ "$wide" -le 3000 ] || scale=2
  file=$folder/$3-$1-$2.png
  { echo "resize $wide $high $scale"; cat; echo "screenshot $file"; } |
    "$rayview" "$scene" -headless -panels "$1" -events - -samples 1 -quiet -image "$folder/traced.png" > "$folder/log" || {
    cat "$folder/log" >&2
    exit 1
  }
  echo "$file"
}

for size in ${SIZES:-1280x800 3840x2160}; do
  middle="$((${size%x*} / 3)) $((${size#*x} / 2))"
  for theme in dark light; do
    echo "tick 6" | shot $theme $size start
    for panel in Scene Image Pixel Render View; do
      # What is open at first is closed, so that the panel has all of the column.
      { echo "click left $middle"; echo "click right $middle"; echo "tick 6"
        for open in Scene Pixel; do [ $open = $panel ] || echo "panel $open"; done
        case $panel in Scene | Pixel) ;; *) echo "panel $panel" ;; esac; } | shot $theme $size "panel-$panel"
    done
    printf 'key Control+O\ntick 6\n' | shot $theme $size scenes
    printf 'key H\n' | shot $theme $size help
    printf 'key G\nkey L\ntick 0.1\n' | shot $theme $size rays
    printf 'key B\nkey E\ntick 0.1\n' | shot $theme $size boxes
    printf 'key X\ntick 0.1\n' | shot $theme $size section
    printf 'key S\nwait trace\nkey I\ntick 0.1\n' | shot $theme $size flat
    printf 'key S\nwait trace\nkey R\nkey [\nkey S\nwait trace\nkey Shift+D\ntick 0.1\n' | shot $theme $size difference
    printf 'key F8\nwait trace\ntick 0.1\n' | shot $theme $size normals
    printf 'down right %s Control\nmove 20 20\nup right 20 20 Control\ntick 0.1\n' "$middle" | shot $theme $size crop
  done
done
rm -f "$folder/log" "$folder/traced.png"
