#!/bin/sh
# Makes a movie of any scene: the camera orbits it or moves elsewhere, or an option of raypro, or a variable of the scene,
# changes over the frames.
#
#     script/movie.sh -turntable art/flake.scn art/movie.avi -frames 72 -samples 16 -srgb
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
# RAYPRO and RAYIMG name the programs. File names must not contain spaces: the scene language does not allow them.
set -eu
export LC_ALL=C  # numbers have a point
here=$(cd "$(dirname "$0")/.." && pwd)
# What lies in a build of the sources, or is installed.
program() { if [ -x "$here/build/$1" ]; then echo "$here/build/$1"; else command -v "$1" || echo "$1"; fi; }
raypro=${RAYPRO:-$(program raypro)}
rayimg=${RAYIMG:-$(program rayimg)}
usage() { echo "movie.sh: $1; see the top of $0" >&2; exit 2; }

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
[ -z "$hosts" ] || [ -f "$hosts" ] || { echo "movie.sh: no such file of hosts: '$hosts'" >&2; exit 3; }
writer=$rayimg
case $out in
  *.avi) ;;
  *.webp) writer=img2webp ;;
  *.mp4) writer=ffmpeg ;;
  *) usage "a movie is .avi, .webp or .mp4, got '$out'" ;;
esac
for program in "$writer" ${engine:+"$(echo "$engine" | sed s/slurm/sbatch/)"}; do
  command -v "$program" > /dev/null || { echo "movie.sh: $program is not installed" >&2; exit 1; }
done
case $frames in '' | *[!0-9]* | 0) usage "-frames must be a whole number above 0, got '$frames'" ;; esac
[ -f "$scene" ] || { echo "movie.sh: no such scene: '$scene'" >&2; exit 3; }

views=$scene.views  # as rayview calls the file of bookmarks
[ "$way" != tour ] || [ "$(grep -c '^[1-9] camera ' "$views" 2> /dev/null)" -ge 2 ] 2> /dev/null ||
  { echo "movie.sh: -bookmarks needs two of them in '$views'; Control+1 in rayview keeps a view" >&2; exit 3; }

# Frames keep the command that made them, so the folder is a relative one where that is possible.
if [ -d build ] && [ -w build ]; then base=build; elif [ -w . ]; then base=.; else base=${TMPDIR:-/tmp}; fi
work=$(mktemp -d "$base/movie.XXXXXX")
trap '[ "$keep" ] || rm -rf "$work"' EXIT
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
awk -v way="$way" -v to="$to" -v turns="$turns" -v frames="$frames" -v low="$low" -v high="$high" -v least="$least" -v most="$most" -v scene="$scene" \
    -v work="$work" '
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
    if (way == "go" && split(to, goal, " ") < 10) { print "movie.sh: -to needs ten numbers" > "/dev/stderr"; exit 2 }
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
      file = sprintf("%s/frame%05d.scn", work, i)
      print "include " scene > file
      if (way) {
        printf "camera " > file
        for (k = 1; k <= 12; ++k) printf " %.17g", c[k] > file
        print "" > file
      }
      close(file)
      print substr(file, 1, length(file) - 4), mix(low, high, share), mix(least, most, share), share > (work "/frames")
    }
  }' "$work/about"

# Renders the frame of that line of the list.
quoted() { for word; do printf " '%s'" "$(printf %s "$word" | sed "s/'/'\\\\''/g")"; done; }
cat > "$work/frame.sh" << FRAME
#!/bin/sh
set -- \$(sed -n "\${1:-\$SLURM_ARRAY_TASK_ID}p" '$work/frames')
exec$(quoted "$raypro") "\$1.scn" "\$1.jpg" -width $width -height $height -quiet -allow_path '$allowed' \\
  ${sweep:+-$sweep "\$2"} ${define:+-define=$define="\$3"}$(quoted "$@")
FRAME
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

case $out in
  *.avi) "$rayimg" movie "$out" -fps "$fps" "$work"/frame*.jpg ;;
  *.webp) img2webp -loop 0 -lossy -q 85 -d "$(awk "BEGIN { printf \"%d\", 1000 / $fps + 0.5 }")" "$work"/frame*.jpg -o "$out" > /dev/null 2>&1 ;;
  *.mp4) ffmpeg -v error -y -framerate "$fps" -i "$work/frame%05d.jpg" -pix_fmt yuv420p "$out" < /dev/null ;;
esac
[ -z "$keep" ] || echo "the frames are in $work"
