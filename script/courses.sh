#!/bin/sh
# How many pixels of other courses' pictures differ from ours at all, as a table for the writeup:
#
#     script/courses.sh FOLDER > writeup/measured/courses.csv
#
# FOLDER holds scenes-groningen, scenes-cs315 and scenes-comp30019, which are not ours to pass on. RAYPRO and RAYIMG name
# the programs. A largest difference is in levels, of 255.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
raypro=${RAYPRO:-$root/build/raypro} rayimg=${RAYIMG:-$root/build/rayimg}
cd "$1"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

row() {  # course, scene, picture, at most so many pixels, options
  course=$1 scene=$2 picture=$3 goal=$4
  shift 4
  "$raypro" "scenes-$course/$scene" "$work/out.png" -quiet "$@"
  # With -fail 0 the pixels that differ are counted, and the exit status is 1 where there are any.
  "$rayimg" diff "$work/out.png" "scenes-$course/reference/$picture" -fail 0 -json > "$work/diff" || [ $? = 1 ]
  awk -v course="$course" -v scene="${scene##*/}" -v options="$*" -v goal="$goal" '
    /"value"/ { largest = $2 } /"pixels"/ { pixels = $2 } /"pixels_beyond"/ { differ = $2 }
    END { printf "%s,%s,%s,%d,%d,%d,%s\n", course, scene, options, pixels, differ, 255 * largest + 0.5, goal }' "$work/diff"
}

echo "course,scene,options,pixels,that differ,by at most,goal"
row groningen json/scene01.json ../json/scene01_reference.png 0
row groningen scene01-zbuffer.yaml scene01-zbuffer.png 0
row groningen scene01-gooch.yaml scene01-gooch.png 0
row groningen scene01-shadows.yaml scene01-shadows.png 0
row groningen scene01-lights-shadows.yaml scene01-lights-shadows.png 0
row groningen scene01-ss.yaml scene01-ss2x2.png 34 -samples 4
row groningen scene01-camera-ss-reflect-lights-shadows.yaml scene01-camera-ss2x2-reflect-lights-shadows.png 480 -samples 4
for scene in SphereTest TriangleTest TriangleShadingTest; do row cs315 $scene.json $scene.png 0; done
for scene in SphereShadingTest1 ShadowTest1 TransformationTest; do row cs315 $scene.json $scene.png 20; done
row cs315 FullTest-floor-fixed.json FullTest.png 165
row cs315 CornellBox.json CornellBox.png 135
row comp30019 tests/sample_scene_1.txt sample_scene_1_s1.png 0 -mode flat
row comp30019 tests/sample_scene_1.txt sample_scene_1_x1.png 0
row comp30019 tests/sample_scene_1.txt sample_scene_1_s2.png 18 -samples 16
