#!/bin/sh
# From four folders that students handed in to a graded class, as docs/teachers.md tells a teacher to do it. The first
# is right, the second has no shadows, the third does not compile and the fourth never ends.
#   usage: RAYGRADE=build/raygrade grader/tests/class_of_four.sh
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
case ${RAYGRADE:=build/raygrade} in /*) ;; *) RAYGRADE=$(pwd)/$RAYGRADE ;; esac
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
chmod 755 "$place"
cd "$place"

fail() { echo "class_of_four.sh: $*" >&2; exit 1; }
# expect FILE TEXT: the file has the text.
expect() { grep -q -- "$2" "$1" || { cat printed >&2; fail "no '$2' in $1"; }; }

for student in amy bob cat dan; do
  mkdir -p handed_in/$student
  cp "$root/grader/tests/students/scn.c" handed_in/$student/tracer.c
  printf 'tracer: tracer.c\n\tcc -std=c99 -O2 -o tracer tracer.c -lm\n' > handed_in/$student/Makefile
done
sed -i 's/if (cosine <= 0 ||.*) continue;/if (cosine <= 0) continue;/' handed_in/bob/tracer.c
sed -i 's/^int main/int mian/' handed_in/cat/tracer.c
sed -i 's/read_scene(argv\[1\], &world, 0, 0);/for (;;) continue;/' handed_in/dan/tracer.c
for student in bob cat dan; do
  cmp -s handed_in/amy/tracer.c handed_in/$student/tracer.c && fail "$student is right"
done

mkdir suite
cp "$root"/share/suites/cos426/* suite
cat > suite/suite.yaml <<'SUITE'
name: Four
width: 120
height: 90
seconds: 1
scenes:
  - scene: sphere.scn
  - scene: lights.scn
  - scene: mirror.scn
SUITE

"$RAYGRADE" suite/suite.yaml -students handed_in -build "make -C {student}" -image ppm -- \
  {student}/tracer {scene} {image} {width} {height} > printed 2>&1

expect printed 'amy: lights: 1/1'
expect graded/bob/index.html 'no shadows'
expect graded/cat/index.html 'was not built'
expect graded/cat/index.html 'undefined reference'
expect graded/dan/index.html 'was stopped after 1'
for student in amy bob cat dan; do
  expect graded/index.html "$student/index.html"
  expect graded/class.csv "^$student,sphere,1,"
done
[ ! -e handed_in/amy/tracer ] || fail "what was handed in has changed"
echo "$place graded"
