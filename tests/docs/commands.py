"""Runs every command that README.md and docs/*.md show, and compares the output that they show with what is printed.

usage: commands.py TREE [PAGE...]; RAYPRO, RAYIMG, RAYGRADE and, if it is built, RAYVIEW name the programs.
Commands are the lines of indented blocks and the texts in backticks that begin with one of our programs. They run in a
folder of their own, and as images are small here, with the sizes and limits of SMALL behind their words. A command that
cannot run here is named in NOT_HERE with the reason: one that is neither is an error, and so is an entry that no page
needs.
"""
import contextlib
import glob
import io
import os
import re
import shutil
import subprocess
import sys
import tempfile

TREE = os.path.abspath(sys.argv[1])
PAGES = sys.argv[2:] or ["README.md", *sorted(os.path.relpath(name, TREE) for name in glob.glob(TREE + "/docs/*.md"))]
PROGRAMS = "raypro|rayimg|rayview|raygrade|raypro-parallel|raypro-slurm|raypro-movie"
BEGIN = re.compile(rf"(build/)?({PROGRAMS}) |(script/|make\b|printf |PYTHONPATH=|pip |python3 |cp |cd |apt-get |git )")
SMALL = " -width 16 -height 12"

# What begins a command that needs another machine, an hour, or the tree itself, which other tests build.
NOT_HERE = {
    "make": "builds the tree",
    "script/setup.sh": "builds the tree",
    "raypro scenes/hello.scn -width 512 -height 512 -advise": "Transcripts.AdviceOfTheDocsIsTheProgramsOutput runs it",
    "script/wheel.sh": "tests/python/test_wheel.py runs it",
    "script/claims_table.sh": "renders for hours",
    "script/other_architecture.sh": "needs another compiler",
    "pip install": "needs a package of Python's",
    "python3 -m http.server": "never ends",
    "cp share/python/*": "starts Jupyter",
    "raypro-slurm": "tests/farm/slurm.sh runs it",
    "raypro-parallel -copy": "tests/farm/parallel.sh runs it",
    "apt-get": "installs a package",
    "git clone": "needs a repository",
    "cd /autograder": "Gradescope's folders",
    "raygrade /autograder": "Gradescope's folders",
    "PYTHONPATH=": "a line of a Python session, which is run as a whole",
}
unneeded = set(NOT_HERE)
failures = []


def fail(place, command, why):
    failures.append(f"{place}: {command}\n    {' '.join(why.split())[-400:]}")


def run(command, statuses=(0,), **options):
    """Returns the output; raises RuntimeError for another status."""
    done = subprocess.run(
        ["bash", "-c", command], stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=300, **options
    )
    if done.returncode not in statuses:
        raise RuntimeError(f"status {done.returncode}: {done.stdout} {done.stderr}")
    return done.stdout + done.stderr


def blocks(page):
    """Indented parts of a page, each as (number of the first line, lines without the indent)."""
    found, lines = [], open(os.path.join(TREE, page), encoding="utf-8").read().split("\n")
    fenced = False
    for number, line in enumerate(lines, 1):
        if line.startswith("```"):
            fenced = not fenced
            kind = line[3:]
        elif line.startswith("    ") or (fenced and kind == ""):
            if not found or found[-1][0] + len(found[-1][1]) != number:
                found.append((number, []))
            found[-1][1].append(line if fenced else line[4:])
    return found


def inline(page):
    """Texts in backticks outside of blocks, each as (number of its line, text)."""
    text = open(os.path.join(TREE, page), encoding="utf-8").read()
    text = re.sub(r"^(    .*|```[^`]*```)$", lambda m: "\n" * m.group().count("\n"), text, flags=re.M)
    for match in re.finditer(r"`([^`\n]+(?:\n[^`\n]+)?)`", text):
        yield text.count("\n", 0, match.start()) + 1, " ".join(match.group(1).split())


def without_remark(line):
    """The command of a line: a remark stands behind two blanks or more."""
    return line if line.startswith("printf") else re.split(r" {2,}", line)[0]


def smaller(command):
    """The command as it is run here, and the statuses that it may have."""
    command = command.replace("build/", "")
    program = command.split()[0]
    if program == "raypro" and re.match(r"raypro [^-]\S* ?.*", command) and "-advise" not in command:
        limits = " -samples 4" if "-samples" in command else ""
        limits += " -time 1" if "-time" in command else ""
        limits += " -error 60" if "-error" in command else ""
        size = "" if re.search("-debugpixel|-convert", command) else SMALL
        first, bar, reader = command.partition(" | ")
        return first + size + limits + bar + reader, (0,)
    if command.startswith("raypro -as comp30019 -f"):
        return command + " -w 16 -h 12", (0,)
    if program == "rayview":
        return command + (" -headless -exit_immediately" if "-headless" not in command else "") + SMALL, (0,)
    if program.endswith("movie.sh") or program == "raypro-movie":
        words = re.sub(r" -(hosts \S+|slurm \"[^\"]*\")", "", command)
        return re.sub(r" -frames \d+", "", words) + " -frames 2" + SMALL + " -samples 1", (0,)
    if program == "raypro-parallel":
        return command + SMALL + " -samples 2", (0,)
    return command, (0, 1) if " diff " in command else (0,)


def prepare(place):
    """What commands find: scenes under the names that pages use, images of every kind, a program to be graded."""
    shutil.copytree(TREE + "/scenes", "scenes")
    for name in ("share", "script", "art"):
        os.symlink(os.path.join(TREE, name), name)
    os.mkdir("bin")
    for name in ("raypro", "rayimg", "raygrade", "rayview"):
        if name.upper() in os.environ:
            os.symlink(os.path.abspath(os.environ[name.upper()]), "bin/" + name)
    for name, script in (("parallel", "farm/parallel.sh"), ("slurm", "farm/slurm.sh"), ("movie", "movie.sh")):
        os.symlink(f"{TREE}/script/{script}", "bin/raypro-" + name)
    os.environ["PATH"] = os.path.abspath("bin") + os.pathsep + os.environ["PATH"]
    for name in ("scene.scn", "in.scn", "room.scn", "a.scn", "b.scn", "scenes/scene.scn"):
        shutil.copy("scenes/first.scn", name)
    open("pendulum.scn", "w").write("define t 0\nsphere -1  $t 0 0  1\n")
    shutil.copy("pendulum.scn", "ball.scn")
    open("bunny.obj", "w").write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    quiet = " -width 16 -height 16 -quiet"
    for seed in (1, 2, 3):
        run(f"raypro in.scn seed{seed}.exr -mode path -samples 2 -seed {seed} -layers normal" + quiet)
    for name in ("mine", "reference", "renders"):
        os.mkdir(name)
    # What students hand in, and an image with rows and columns swapped.
    run("raypro in.scn out.jpg -width 320 -height 256 -quiet; rayimg convert out.jpg kept.png")
    run(f"raypro scenes/mirrors.json mine/mirror.png {quiet}; raypro scenes/glass.scn reference/glass.ppm {quiet}")
    head, pixels = open("reference/glass.ppm", "rb").read().split(b"255\n", 1)
    size = 16
    swapped = b"".join(pixels[3 * (size * x + y) :][:3] for y in range(size) for x in range(size))
    open("mine/glass.ppm", "wb").write(head + b"255\n" + swapped)
    run("for to in reference renders mine.png reference.png; do cp mine/mirror.png $to; done")
    run("for f in mine reference; do rayimg convert $f/glass.ppm $f/glass.png; rm $f/glass.ppm; done")
    for name, source in (("noisy.exr", "seed1.exr"), ("clean.exr", "seed2.exr"), ("out.exr", "seed3.exr")):
        shutil.copy(source, name)
    for number in (1, 2, 3):
        shutil.copy("out.jpg", f"turn0{number}.jpg")
    os.makedirs("handed_in/alice")
    shutil.copy("mine/mirror.png", "handed_in/alice")
    # One bounce less than a scene of the suite needs.
    student = '#!/bin/sh\nexec "$(dirname "$0")/tracing" "$@" -max_depth 2 -quiet\n'
    shutil.copy(os.environ["RAYPRO"], "tracing")  # the sandbox shows nothing but the folder
    shutil.copy("tracing", "handed_in/alice")
    lights = "[{position: [0, 0, 9], color: [1, 1, 1]}]"
    ball = "[{type: sphere, position: [0, 0, 0], radius: 1, material: {color: [1, 0, 0], ka: 0.2, kd: 0.7}}]"
    open("scene.yaml", "w").write(f"Eye: [0, 0, 9]\nLights: {lights}\nObjects: {ball}\n")
    for name in ("student", "tracer", "handed_in/alice/tracer"):
        open(name, "w").write(student)
        os.chmod(name, 0o755)
    suite = "name: small\nwidth: 24\nheight: 18\nscenes:\n  - scene: scenes/sphere.scn\n"
    open("suite.yaml", "w").write(suite)


def try_command(place, shown):
    for begin in NOT_HERE:
        if shown.startswith(begin):
            unneeded.discard(begin)
            return None
    if "rayview" in shown and not os.path.exists("bin/rayview"):
        return None
    if shown.startswith("raypro-parallel"):
        if not shutil.which("parallel"):
            return None
        open("lab.txt", "w").write(":\n")
    if re.search(r"\.(webp|mp4)", shown) and not shutil.which("img2webp" if ".webp" in shown else "ffmpeg"):
        return None
    command, statuses = smaller(shown)
    try:
        return run(command, statuses)
    except (RuntimeError, subprocess.TimeoutExpired) as error:
        fail(place, shown, f"{command}: {error}")
    return None


def is_fragment(command):
    """Returns true for a text in backticks that is no whole command, but a program and its subcommand or option."""
    words = command.split()
    is_option = len(words) == 2 and words[1].startswith("-") and not re.match("-(help|list|man|version)", words[1])
    has_placeholder = "..." in command or re.search(r"\b[A-Z]{3,}\b|[{}]", command)
    is_subcommand = words[0] == "rayimg" and len(words) == 2
    return (
        is_option or is_subcommand or has_placeholder
        or command in ("raypro -threads 1", "raypro -as comp30019", "rayimg convert -exposure")
    )


def try_python(page):
    """A page's Python: sessions with >>> by what they print, other blocks as they stand, on a small scene."""
    sys.path.insert(0, TREE + "/share/python")
    import raypro

    scene = "scenes/first.scn"
    image = raypro.render(scene, width=48, height=32)
    names = {"raypro": raypro, "numpy": raypro.numpy, "scene": scene, "image": image}
    names["text"] = "sphere -1  0 0 0  1\n"
    count = 0
    for number, lines in blocks(page):
        session = [line for line in lines if line.startswith(">>> ")]
        source = "\n".join(line[4:] for line in session) if session else "\n".join(lines)
        if "raypro." not in source and "image." not in source:
            continue
        if "numpy." in source and not raypro.numpy:
            continue
        count += 1
        source = source.replace("4096", "4").replace("(1, 4, 16, 64)", "(1, 2)")
        source = re.sub(r"512", "32", source)
        shown = "\n".join(lines[lines.index(session[-1]) + 1 :]) if session else ""
        try:
            with contextlib.redirect_stdout(io.StringIO()):
                exec(source, names)
            printed = ""
        except raypro.SceneError as error:
            printed = f"raypro.SceneError: {error}"
        except Exception as error:  # whatever a page's line raises is what is wrong with it
            printed = repr(error)
        if printed.rstrip() != shown.rstrip():
            fail(f"{page}:{number}", source, f"printed {printed!r}")
    return count


def masked(text):
    """The text without its numbers and their columns."""
    return re.sub(r"\s+", " ", re.sub(r"\d+(\.\d+)?", "0", text)).strip()


def shown_block(begin):
    """The block whose first line matches: its place and its text."""
    for page in PAGES:
        for number, lines in blocks(page):
            if re.match(begin, lines[0]):
                return f"{page}:{number}", "\n".join(lines)
    return None, None


def expect_lines(place, text, printed):
    for line in text.split("\n"):
        if masked(line) not in masked(printed):
            fail(place, line, printed)


def compare_shown():
    """Compares output that stands in blocks of its own; numbers only where the page says of which scene they are."""
    place, text = shown_block(r"scenes/room\.scn:")
    if place:
        line, column = map(int, re.match(r"\S+?:(\d+):(\d+)", text).groups())
        wrong = re.search(r"\| (spere.*)", text).group(1)
        including = int(re.search(r"included from scenes/main.scn:(\d+)", text).group(1))
        open("scenes/room.scn", "w").write("# a comment\n" * (line - 1) + " " * (column - 1) + wrong + "\n")
        open("scenes/main.scn", "w").write("# a comment\n" * (including - 1) + "include room.scn\n")
        printed = run("raypro scenes/main.scn -check", (3,))
        if text not in printed:
            fail(place, text, printed)
    folders, text = shown_block("FLIP ")
    if folders:
        expect_lines(folders, text, run("rayimg diff mine reference"))
    graded, text = shown_block(r"sphere: \d")
    if graded:
        words = "-out graded2 -- ./student {scene} {image} -width {width} -height {height}"
        printed = run("raygrade share/suites/cos426/suite.yaml " + words, (0, 1))
        for line in text.split("\n"):
            if line not in printed:
                fail(graded, line, printed)
    return sum(map(bool, (place, folders, graded)))


def main():
    place = tempfile.mkdtemp(prefix="docs-")
    os.chmod(place, 0o755)  # in the sandbox programs are another user's
    os.chdir(place)
    count = 0
    try:
        prepare(place)
        for page in PAGES:
            shutil.copy("kept.png", "out.png")
            for number, lines in blocks(page):
                for offset, line in enumerate(lines):
                    if BEGIN.match(line):
                        count += 1
                        try_command(f"{page}:{number + offset}", without_remark(line))
            # That page has usages, from the programs' own tables.
            for number, text in inline(page) if page != "docs/options.md" else ():
                if re.match(rf"(build/)?({PROGRAMS}) \S|script/\S+ \S", text) and not is_fragment(text):
                    count += 1
                    try_command(f"{page}:{number}", text)
        pythons = try_python("docs/python.md") if "docs/python.md" in PAGES else 0
        compared = compare_shown()
    finally:
        os.chdir("/")
        shutil.rmtree(place, ignore_errors=True)
    if len(sys.argv) == 2 and unneeded:
        failures.append("no page needs these of NOT_HERE: " + ", ".join(sorted(unneeded)))
    print("\n".join(failures))
    print(f"{count} commands, {pythons} parts in Python, {compared} outputs compared; {len(failures)} failures")
    return 1 if failures else 0


sys.exit(main())
