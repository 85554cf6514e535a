#!/bin/sh
# Makes a movie of any scene: the camera orbits it or moves elsewhere, or an option of raypro, or a variable of the scene,
# changes over the frames.
#
#     script/movie.sh -turntable art/cradle.scn art/movie.avi -frames 72 -samples 16 -srgb
#     script/movie.sh -to "0 1 3  0 0 -1  0 1 0  0.4" scenes/hello.scn build/closer.avi
#     script/movie.sh -sweep focus 3 9 scenes/lens.scn build/focus.avi -aperture 0.12 -samples 64
#     script/movie.sh -define t 0 1 pendulum.scn build/pendulum.webp -hosts lab.txt
#     script/movie.sh -each "sh script/art/orrery.sh" art/year.scn build/year.avi -frames 250
#
#   -turntable         one orbit around the vertical axis through the middle of the scene
#   -turns x           number of orbits, with -turntable; negative: the other way (default 1)
#   -to "camera"       from the scene's camera to this one: eye, direction, up, half angle; easing in and out
#   -bookmarks         through the views that rayview keeps as bookmarks of the scene, in the order of their digits
#   -sweep name a b    raypro's option -name goes from a to b; may be combined with the others
#   -define name a b   $name in the scene goes from a to b; likewise
#   -each command      runs "command x" before each frame, x from 0 to 1, to change what the scene includes; likewise
#   -frames n          (default 48)       -fps n   frames per second (default 25)
#   -width n -height n (default 320 240)  -keep    keep the frames, in the folder that is printed
#   -hosts file        render frames on these machines, by GNU parallel; they must see this folder by this name
#   -slurm words       or as an array of jobs, with these options for sbatch
#
# The extension chooses the format: .avi, .webp (by img2webp) or .mp4 (by ffmpeg).
# All further options are passed to raypro. Each frame is a scene that includes the scene itself and, where the camera moves,
# sets a camera; the last camera counts.
# If a frame or the movie fails, the frames that are rendered are kept. RAYPRO and RAYIMG name the programs; otherwise
# they are those of the build, beside this script or on PATH. .webp needs the package webp, .mp4 the package ffmpeg.
set -eu
export LC_ALL=C  # numbers have a point
here=$(cd "$(dirname "$(readlink -f "$0" || echo "$0")")" && pwd)
# What lies in a build of the sources, or is installed.
program() {
  for file in "$here/../build/$1" "$here/$1"; do [ ! -x "$file" ] || { echo "$file"; return; }; done
  command -v "$1" || echo "$1"
}
raypro=${RAYPRO:-$(program raypro)}
rayimg=${RAYIMG:-$(program rayimg)}
fail() { printf 'movie.sh: %s\n' "$2" >&2; exit "$1"; }
usage() { fail 2 "$1; see the top of $0"; }
number() {  # option, value: not 0,5 nor 1/2, and nothing that is no finite double
  awk 'BEGIN { v = ARGV[1] + 0
    exit !(ARGV[1] ~ /^[-+]?([0-9]+[.]?[0-9]*|[.][0-9]+)([eE][-+]?[0-9]+)?$/ && v > -1e308 && v < 1e308) }' "$2" ||
    usage "$1 must be a number such as -1 or 0.5, got '$2'"
}
quoted() { for word; do printf " '%s'" "$(printf %s "$word" | sed "s/'/'\\\\''/g")"; done; }

way='' turns=1 to='' sweep='' each='' low=0 high=0 define='' least=0 most=0 hosts='' slurm='' engine='' frames=48 fps=25 width=320 height=240 keep='' scene='' out=''
while [ $# -gt 0 ]; do
  case $1 in
    -turntable) way=turn; shift; continue ;;
    -bookmarks) way=tour; shift; continue ;;
    -keep) keep=yes; shift; continue ;;
    -sweep)
      [ $# -ge 4 ] || usage "-sweep needs a name and two numbers"
      sweep=$2 low=$3 high=$4
      shift 4
      continue ;;
    -define)
      [ $# -ge 4 ] || usage "-define needs a name and two numbers"
      define=$2 least=$3 most=$4
      shift 4
      continue ;;
    -turns | -hosts | -slurm | -to | -each | -frames | -fps | -width | -height)
      [ $# -ge 2 ] || usage "$1 needs a value"
      case $1 in
        -hosts) engine=parallel hosts=$2 ;; -slurm) engine=slurm slurm=$2 ;;
        -turns) turns=$2 ;; -to) way=go to=$2 ;; -each) each=$2 ;; -frames) frames=$2 ;;
        -fps) fps=$2 ;; -width) width=$2 ;; -height) height=$2 ;;
      esac
      shift 2
      continue ;;
    -*) break ;;
  esac
  if [ -z "$scene" ]; then scene=$1; elif [ -z "$out" ]; then out=$1; else break; fi
  shift
done
[ "$out" ] || usage "a scene and an output file are needed"
[ "$way$sweep$define$each" ] || usage "one of -turntable, -to, -bookmarks, -sweep, -define and -each is needed"
[ -z "$each" ] || [ -z "$engine" ] || usage "-each changes the scene before each frame, so frames cannot be rendered together"
[ -z "$hosts" ] || [ -f "$hosts" ] || fail 3 "no such file of hosts: '$hosts'"
writer=$rayimg
case $out in
  *.avi) ;;
  *.webp) writer=img2webp ;;
  *.mp4) writer=ffmpeg ;;
  *) usage "a movie is .avi, .webp or .mp4, got '$out'" ;;
esac
for program in "$raypro" "$writer" ${engine:+"$(echo "$engine" | sed s/slurm/sbatch/)"}; do
  command -v "$program" > /dev/null || fail 1 "$program is not installed"
done
case $frames in
  '' | *[!0-9]* | 0* | ??????*) usage "-frames must be a whole number from 1 to 99999, got '$frames'" ;;
esac
number -fps "$fps"
awk 'BEGIN { exit !(ARGV[1] >= 0.1 && ARGV[1] <= 1000) }' "$fps" || usage "-fps must be 0.1 to 1000, got '$fps'"
number -turns "$turns"
[ -z "$sweep" ] || { number "-sweep $sweep" "$low"; number "-sweep $sweep" "$high"; }
[ -z "$define" ] || { number "-define $define" "$least"; number "-define $define" "$most"; }
if [ "$way" = go ]; then
  set -f
  count=0
  for word in $to; do number -to "$word"; count=$((count + 1)); done
  case $count in 10 | 12) ;; *) usage "-to needs ten numbers: eye, direction, up and half angle, got '$to'" ;; esac
  set +f
fi
[ -f "$scene" ] || fail 3 "no such scene: '$scene'"
folder=$(dirname "$out")
[ -d "$folder" ] || fail 4 "cannot write '$out': the folder '$folder' does not exist"
[ ! -d "$out" ] || fail 4 "cannot write '$out': it is a folder"
if [ ! -w "$folder" ] || { [ -e "$out" ] && [ ! -w "$out" ]; }; then fail 4 "cannot write '$out': permission denied"; fi

views=$scene.views  # as rayview calls the file of bookmarks
[ "$way" != tour ] || [ "$(grep -c '^[1-9] camera ' "$views" 2> /dev/null)" -ge 2 ] 2> /dev/null ||
  fail 3 "-bookmarks needs two of them in '$views'; Control+1 in rayview keeps a view"

# Frames keep the command that made them, so the folder is a relative one where that is possible.
if [ -d build ] && [ -w build ]; then base=build; elif [ -w . ]; then base=.; else base=${TMPDIR:-/tmp}; fi
work=$(mktemp -d "$base/movie.XXXXXX")
leave() {
  status=$?
  [ "$status" = 0 ] || [ "$keep" ] || ! ls "$work"/frame*.jpg > /dev/null 2>&1 || {
    keep=yes
    echo "movie.sh: there is no movie; the frames are in $work" >&2
  }
  [ "$keep" ] || rm -rf "$work"
}
trap leave EXIT
trap 'exit 129' HUP
trap 'exit 130' INT
trap 'exit 143' TERM

# The scene's own camera and its box, whichever file they come from.
allowed=$(dirname "$scene")
case $scene in
  *.[Ss][Cc][Nn]) ;;
  *)
    "$raypro" "$scene" -convert "$work/converted.scn" -quiet
    scene=$work/converted.scn ;;
esac
: > "$work/about"
[ "$way" != tour ] || grep '^[1-9] camera ' "$views" | sort >> "$work/about"
if [ "$way" ]; then
  "$raypro" "$scene" -convert "$work/whole.scn" ${define:+"-define=$define=$least"} -allow_path "$allowed" -quiet 2> "$work/said" ||
    { cat "$work/said" >&2; exit 3; }
  grep '^camera ' "$work/whole.scn" >> "$work/about"
  "$raypro" "$scene" -check ${define:+"-define=$define=$least"} -allow_path "$allowed" 2> /dev/null | grep '^bounds ' >> "$work/about"
fi
# Names go by the environment, where a backslash is one.
# shellcheck disable=SC1003  # in a name in quotes, a backslash and a quote have one before them
SCENE=$(printf %s "$scene" | sed 's/[\\"]/\\&/g') FOLDER=$work awk \
    -v way="$way" -v to="$to" -v turns="$turns" -v frames="$frames" -v low="$low" -v high="$high" -v least="$least" \
    -v most="$most" '
  function mix(a, b, t) { return a + (b - a) * t }
  # A vector of the camera around the vertical axis; ca and sa are of the angle.
  function turn(k,   x) { x = ca * from[k] + sa * from[k + 2]; c[k + 2] = -sa * from[k] + ca * from[k + 2]; c[k] = x }
  # Through four numbers in a row: from the second to the third as t goes from 0 to 1.
  #   source   Catmull, Rom, A class of local interpolating splines (1974)
  function spline(a, b, c, d, t) {
    return b + t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a))) / 2
  }
  function view(i, k) { return views[i < 1 ? 1 : i > tours ? tours : i, k] }
  $2 == "camera" { ++tours; for (k = 1; k <= 12; ++k) views[tours, k] = $(k + 2) }
  $1 == "bounds" { middle_x = ($2 + $6) / 2; middle_z = ($4 + $8) / 2 }
  $1 == "camera" { for (k = 1; k <= 12; ++k) from[k] = $(k + 1) }
  END {
    pi = atan2(0, -1)
    split(to, goal, " ")
    # A level camera stays level on its way: its up is +y, and not what is perpendicular to its first direction.
    roll = from[6] * from[7] - from[4] * from[9]
    if (from[8] > 0 && roll < 1e-9 && roll > -1e-9) { from[7] = 0; from[8] = 1; from[9] = 0 }
    # Around the place where the view comes nearest to the vertical line through the middle of the box.
    flat = from[4] * from[4] + from[6] * from[6]
    t = flat > 0 ? ((middle_x - from[1]) * from[4] + (middle_z - from[3]) * from[6]) / flat : 0
    if (!(t > 0)) t = 1
    px = from[1] + t * from[4]; pz = from[3] + t * from[6]
    for (i = 0; i < frames; ++i) {
      share = frames > 1 ? i / (frames - 1) : 0
      for (k = 1; k <= 12; ++k) c[k] = from[k]
      if (way == "go") {
        eased = share * share * (3 - 2 * share)
        for (k = 1; k <= 10; ++k) c[k] = mix(from[k], goal[k], eased)
      }
      if (way == "tour") {
        j = int(share * (tours - 1)); if (j > tours - 2) j = tours - 2
        for (k = 1; k <= 12; ++k) {
          c[k] = spline(view(j, k), view(j + 1, k), view(j + 2, k), view(j + 3, k), share * (tours - 1) - j)
          if (frames == 1) c[k] = view(1, k)
        }
      }
      if (way == "turn") {  # the frame after the last would be the first again
        a = 2 * pi * turns * i / frames; ca = cos(a); sa = sin(a)
        c[1] = px + ca * (from[1] - px) + sa * (from[3] - pz); c[3] = pz - sa * (from[1] - px) + ca * (from[3] - pz)
        turn(4); turn(7)
      }
      name = sprintf("frame%05d", i); file = ENVIRON["FOLDER"] "/" name ".scn"
      print "include \"" ENVIRON["SCENE"] "\"" > file
      if (way) {
        printf "camera " > file
        for (k = 1; k <= 12; ++k) printf " %.17g", c[k] > file
        print "" > file
      }
      close(file)
      print name, mix(low, high, share), mix(least, most, share), share > (ENVIRON["FOLDER"] "/frames")
    }
  }' "$work/about"

# Renders the frame of that line of the list.
# shellcheck disable=SC2016  # of frame.sh
{
  moving=''
  [ -z "$sweep" ] || moving="$(quoted "-$sweep") \"\$2\""
  [ -z "$define" ] || moving="$moving$(quoted "-define=$define=")\"\$3\""
  echo '#!/bin/sh'
  echo 'line=${1:-$SLURM_ARRAY_TASK_ID} more=${2:-}'
  printf 'work=%s\n' "$(quoted "$work" | cut -c 2-)"
  echo 'set -- $(sed -n "${line}p" "$work/frames")'
  printf 'exec%s "$work/${scene:-$1}.scn" "$work/$1.jpg" -width%s -height%s -quiet -allow_path%s%s%s $more\n' \
    "$(quoted "$raypro")" "$(quoted "$width")" "$(quoted "$height")" "$(quoted "$allowed")" "$moving" "$(quoted "$@")"
} > "$work/frame.sh"

# What raypro would refuse is found before the first frame: of options by their values in all frames, without a scene,
# and of a scene by that of the last frame.
i=0
while [ "$i" -lt "$frames" ]; do
  i=$((i + 1)); [ "$sweep" ] || i=$frames
  scene=none sh "$work/frame.sh" "$i" -check > "$work/said" 2>&1 || [ $? != 2 ] || { cat "$work/said" >&2; exit 2; }
done
[ "$each" ] || sh "$work/frame.sh" "$frames" -check > "$work/said" 2>&1 || { cat "$work/said" >&2; exit 3; }
begun=$(date +%s) i=0
case $engine in
  parallel)
    eta=; [ ! -t 2 ] || eta=--eta
    seq "$frames" | parallel $eta --jobs 1 --retries 3 --sshloginfile "$hosts" --workdir "$PWD" sh "$work/frame.sh" ;;
  slurm)
    # shellcheck disable=SC2086  # words of sbatch
    sbatch --wait --quiet $slurm --job-name=movie --output="$work/said" --open-mode=append --array="1-$frames" \
      "$work/frame.sh" || { cat "$work/said" >&2; exit 1; } ;;
  *)
    while read -r name value defined share; do
      # shellcheck disable=SC2086  # a command of several words
      [ -z "$each" ] || $each "$share" < /dev/null
      i=$((i + 1))
      sh "$work/frame.sh" "$i" < /dev/null
      left=$((($(date +%s) - begun) * (frames - i) / i))
      [ ! -t 2 ] || printf '\rframe %d of %d, %d s left ' "$i" "$frames" "$left" >&2
    done < "$work/frames"
    [ ! -t 2 ] || echo >&2 ;;
esac

made=$work/movie.${out##*.}  # which takes its place once it is whole
case $out in
  *.avi) "$rayimg" movie "$out" -fps "$fps" "$work"/frame*.jpg ;;
  *.webp)
    pause=$(awk "BEGIN { printf \"%d\", 1000 / $fps + 0.5 }")
    img2webp -loop 0 -lossy -q 85 -d "$pause" "$work"/frame*.jpg -o "$made" > "$work/said" 2>&1 ||
      { cat "$work/said" >&2; exit 1; }
    mv -f "$made" "$out" ;;
  *.mp4)  # whose pixels are coded by twos
    ffmpeg -v error -y -framerate "$fps" -i "file:$work/frame%05d.jpg" -vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2' \
      -pix_fmt yuv420p "file:$made" < /dev/null
    mv -f "$made" "$out" ;;
esac
[ -z "$keep" ] || echo "the frames are in $work"
