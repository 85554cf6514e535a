"""Renders scenes with raypro from Python and in notebooks.

    import raypro
    image = raypro.render("scenes/hello.scn", width=512, samples=16)
    image                    # in a notebook: shows the image
    image.array[0][0]        # red, green and blue of the upper left pixel
    image.report["seconds"]  # the content of raypro -report

A scene is the name of a file, or a text with a line break in it. Mistakes of a text are reported for the file <stdin>.

Options are those of raypro, by name (raypro -help and docs/options.md have units, ranges and defaults), as values:
    width=512, mode="path"        -width 512 -mode path
    denoise=True, denoise=False   -denoise, or nothing: the setting of the scene or the default
    shadows=False                 -shadows off, for options with on and off; 0, 1 and numpy's booleans mean the same
    eye=(0, 1, 5)                 -eye 0 1 5
    layers=["depth", "normal"]    -layers depth,normal
    define={"t": 0.5}             -define t=0.5, for each name
    report="run.json"             a copy of image.report in a file
    seed=None                     nothing
raypro rejects unknown options with a SceneError.

The programs raypro and rayimg are searched in the folder of the environment variable RAYPRO, otherwise in the folder of
this file, in the installation or the sources that it belongs to, and on PATH. Requires only Python 3.9; arrays are
numpy's if numpy is installed.
"""

import array
import functools
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import warnings

try:
    import numpy
except ImportError:
    numpy = None

__all__ = ["Image", "SceneError", "debugpixel", "diff", "render", "tell"]


def __getattr__(name):
    """Returns the version of the program as raypro.__version__."""
    if name != "__version__":
        raise AttributeError(f"module 'raypro' has no attribute {name!r}")
    try:
        return _run("raypro", ["-version"])[0].split()[1]
    except FileNotFoundError as error:
        raise AttributeError(str(error)) from error


class SceneError(Exception):
    """An error message of raypro or rayimg, with line, column and caret if it concerns a file.

    status: its exit status, 1 to 255: 1 failed while rendering, 2 wrong arguments, 3 the scene or a file that it names
    is wrong or missing, 4 the image cannot be written; minus the number of the signal that killed it.
    """

    def __init__(self, text, status):
        super().__init__(text)
        self.status = status


class Image:
    """An image of floats, with the report of raypro.

    width, height: in pixels.
    report: the content of raypro -report as a dict; {} for a layer.
    warnings: a list of texts, each with its caret.
    summary: the output of raypro: size, samples per pixel, seconds, estimated error.
    layers: a dict of Images by name, for layers=["depth", ...].
    """

    def __init__(self, pfm, report=None, told=(), summary="", layers=None, png=None):
        self._pfm, self._png, self._rendered = pfm, png, None
        self.report, self.warnings, self.summary = report or {}, list(told), summary
        self.layers = layers or {}
        _, size, scale, self._floats = pfm.split(b"\n", 3)
        self.width, self.height = map(int, size.split())
        self._byte_order = "little" if float(scale) < 0 else "big"

    @functools.cached_property
    def array(self):
        """Floats in single precision, linear if srgb=True, not clamped: array[row][column] from the upper left.

        A pixel is [red, green, blue]; a single number, such as a depth, is repeated three times. With numpy an array of
        shape (height, width, 3), which matplotlib's imshow accepts; without, nested lists.
        """
        if numpy:
            order = "<f4" if self._byte_order == "little" else ">f4"
            return numpy.frombuffer(self._floats, order).reshape(self.height, self.width, 3)[::-1].astype(numpy.float32)
        floats = array.array("f", self._floats)
        if self._byte_order != sys.byteorder:
            floats.byteswap()
        pixels = [list(floats[i : i + 3]) for i in range(0, len(floats), 3)]
        return [pixels[i : i + self.width] for i in range(0, len(pixels), self.width)][::-1]

    def pixel(self, x, y):
        """Returns the pixel in column x from the left and row y from the bottom, both from 0, as in debugpixel."""
        if not (0 <= x < self.width and 0 <= y < self.height):
            raise IndexError(f"no pixel {x} {y} in an image of {self.width} x {self.height}")
        return self.array[self.height - 1 - y][x]

    def debugpixel(self, x, y):
        """Returns the tree of the rays behind a pixel as text, from the scene and options that rendered this image."""
        if self._rendered is None:
            raise ValueError("this image has no rays: it is a layer, or was not rendered here")
        scene, folder, options = self._rendered
        return debugpixel(scene, x, y, folder=folder, **{**options, "layers": None})

    def save(self, name):
        """Writes the image; the extension selects the format: png, jpg, ppm, bmp, pfm, hdr, or exr if available."""
        with tempfile.TemporaryDirectory(prefix="raypro-") as folder:
            source = _in_folder(folder, "picture.pfm", self._pfm)
            encoding = {"srgb": self.report.get("settings", {}).get("srgb")}
            _run("rayimg", ["convert", source, _file(name), *_words(encoding)])

    def _repr_png_(self):
        if self._png is None:
            with tempfile.TemporaryDirectory(prefix="raypro-") as folder:
                self.save(os.path.join(folder, "picture.png"))
                self._png = pathlib.Path(folder, "picture.png").read_bytes()
        return self._png

    def __repr__(self):
        return f"<raypro.Image {self.width} x {self.height}>"


def render(scene, *, progress=None, folder=None, **options):
    """Renders a scene, a file or a text, and returns an Image.

    progress: a function of the completed share, 0 to 1, and a text such as "0:12 left  4.3 Mrays/s", called about ten
    times per second. True or False: a line of progress or none; by default one in notebooks and on terminals.
    folder: base of relative names, including those of files in a text; by default the current folder.
    Warnings are also passed to Python's module warnings. Ctrl-C and exceptions of progress stop raypro, without a trace.
    """
    if progress is None or progress is True:
        progress = _ProgressLine() if progress or _is_watched() else None
    of_png = {name: options.pop(name) for name in ("bits", "bytes") if name in options}
    wanted = options.pop("report", None)
    with tempfile.TemporaryDirectory(prefix="raypro-") as place:
        picture, report = os.path.join(place, "picture.pfm"), os.path.join(place, "report.json")
        if wanted is not None:
            report = os.path.abspath(os.path.join(folder or "", os.fspath(wanted)))
        summary, said = _run_scene(scene, [picture, "-report", report], options, folder, progress)
        if not os.path.exists(picture):
            raise ValueError("these options render no image; raypro.tell(scene, ...) returns the output of raypro")
        pfm, report = pathlib.Path(picture).read_bytes(), json.loads(pathlib.Path(report).read_text(encoding="utf-8"))
        layers = {file.name.split(".")[1]: Image(file.read_bytes()) for file in pathlib.Path(place).glob("*.*.pfm")}
        png = None
        if of_png or report["settings"]["mode"] in _SHOWN_SCALED:
            shown = os.path.join(place, "picture.png")
            _run_scene(scene, [shown, "-quiet"], {**options, **of_png, "layers": None}, folder)
            png = pathlib.Path(shown).read_bytes()
    told = _split_warnings(said)
    for text in told:
        warnings.warn("\n" + text, stacklevel=2)
    image = Image(pfm, report, told, summary.replace(picture, "").strip(), layers, png)
    image._rendered = scene, folder, options
    return image


# Modes whose PNG raypro scales to black and white; they are fast enough to be rendered twice.
_SHOWN_SCALED = ("depth", "normal", "id")


def tell(scene, *, folder=None, **options):
    """Returns the output of raypro about a scene without an image: tell(scene, check=True), files=True, advise=True."""
    return _run_scene(scene, [], options, folder)[0]


def debugpixel(scene, x, y, **options):
    """Returns the tree of the rays behind a pixel: column x from the left, 0 to width - 1, row y from the bottom.

    Options are those of render; width and height are the size of the image. verbose=True prints all digits.
    """
    return tell(scene, debugpixel=(x, y), **options)


def diff(picture, reference, **options):
    """Returns the difference of an image from a reference, each an Image or the name of a file, as rayimg diff -json.

    "rmse": of the linear values. "display_rmse": in 255ths, clamped to 0..1. "psnr": in dB, None if both are equal.
    "flip": mean perceived difference, 0 to 1. "largest": the largest difference, its pixel and channel. "bias": of each
    channel. "failures": the limits, such as fail_rmse=0.01, that are exceeded. Options are those of rayimg diff;
    map="where.png" writes a map.
    """
    with tempfile.TemporaryDirectory(prefix="raypro-") as folder:
        names = [
            _in_folder(folder, name, image._pfm) if isinstance(image, Image) else _file(image)
            for name, image in (("picture.pfm", picture), ("reference.pfm", reference))
        ]
        beyond_a_limit = 1
        text, _ = _run("rayimg", ["diff", *names, "-json", *_words(options)], accepted=(0, beyond_a_limit))
    found = json.loads(text)
    return {**found, "picture": str(picture), "reference": str(reference)}


def main():
    """Runs raypro or rayimg of a wheel, whichever the command is named after."""
    program = pathlib.Path(__file__).resolve().with_name("raypro_programs") / os.path.basename(sys.argv[0])
    os.execv(program, [str(program), *sys.argv[1:]])


# Words of the command line.


@functools.lru_cache(maxsize=None)
def _switches(program):
    """Returns the options of raypro with the values on and off, and those without a value, from its help."""
    text = subprocess.run([program, "-help"], stdout=subprocess.PIPE, text=True, check=True).stdout
    blocks = re.split(r"^  -", text, flags=re.MULTILINE)[1:]
    on_or_off = {block.split()[0] for block in blocks if re.search(r"\bon or off;", block)}
    return on_or_off, {block.split()[0] for block in blocks if re.match(r"\w+(  |$)", block, flags=re.MULTILINE)}


def _words(options):
    return [word for name, value in options.items() for word in _words_of(name, value)]


def _words_of(name, value):
    option = "-" + name
    if getattr(value, "shape", None) == () and (hasattr(value, "__iter__") or "bool" in type(value).__name__):
        value = value.item()  # numpy's booleans, and arrays that are one value
    if value is None:
        return []
    if isinstance(value, (bool, int)) and value in (0, 1):
        on_or_off, alone = _switches(_find("raypro"))
        if name in on_or_off:
            return [option, "on" if value else "off"]
        if name in alone or isinstance(value, bool):
            return [option] if value else []
    if isinstance(value, dict):
        return [word for key, of_key in value.items() for word in (option, f"{key}={of_key}")]
    if isinstance(value, (str, os.PathLike)) or not hasattr(value, "__iter__"):
        text = str(value)
        may_look_like_an_option = isinstance(value, (str, os.PathLike)) and text.startswith("-")
        return [f"{option}={text}"] if may_look_like_an_option else [option, text]
    values = list(value)
    if name in ("define", "allow_path"):
        return [word for each in values for word in (option, str(each))]
    if values and isinstance(values[0], (str, os.PathLike)):
        return [option, ",".join(map(str, values))]
    return [option, *map(str, values)]


# Running the programs.


def _find(program):
    named = os.environ.get(program.upper()) or os.environ.get("RAYPRO")
    if named:
        places = [pathlib.Path(named).parent.absolute()]
    else:
        here = pathlib.Path(__file__).resolve().parent
        places = [here / "raypro_programs", here, here / "../../build", here / "../../../bin"]
    found = shutil.which(program, path=os.pathsep.join(map(str, places))) or (not named and shutil.which(program))
    if found:
        return found
    place = f"{places[0]}, the folder of RAYPRO" if named else f"the folder of {__file__} or on PATH"
    lack = f"no {program} in {place}"
    advice = "build it (script/setup.sh), install it, or set its path: os.environ['RAYPRO'] = '/.../build/raypro'"
    raise FileNotFoundError(f"{lack}; {advice}")


def _file(name):
    """Returns a name that raypro cannot mistake for an option, or for its standard input."""
    name = os.fsdecode(name)
    return os.path.join(".", name) if name.startswith("-") else name


def _run_scene(scene, words, options, folder=None, progress=None):
    is_text = isinstance(scene, str) and "\n" in scene
    if isinstance(scene, str) and not scene.strip():
        raise ValueError("the scene is empty; it is the name of a file, or a text with a line break in it")
    name = "-" if is_text else _file(scene)
    return _run("raypro", [name, *words, *_words(options)], scene if is_text else "", folder, progress)


def _run(program, words, text="", folder=None, progress=None, accepted=(0,)):
    """Runs a program with a text as input, and returns its standard output and standard error."""
    with tempfile.TemporaryFile() as given, tempfile.TemporaryFile() as output:
        given.write(text.encode("utf-8"))
        given.seek(0)
        reads, writes = _open_terminal() if progress else os.pipe()
        with open(reads, "rb", buffering=0) as errors:
            try:
                process = subprocess.Popen(
                    [_find(program), *words], stdin=given, stdout=output, stderr=writes, cwd=folder,
                    env={**os.environ, "TERM": "xterm", "NO_COLOR": "1"}, start_new_session=True,
                )  # fmt: skip
            finally:
                os.close(writes)
            try:
                said = _listen(errors, progress)
                status = process.wait()
            except BaseException:  # Ctrl-C among them, which in a session of its own raypro does not get
                _stop(process)
                raise
            finally:
                if hasattr(progress, "clear"):
                    progress.clear()
        output.seek(0)
        printed = output.read().decode("utf-8", "replace")
    if status not in accepted:
        raise SceneError(said.strip() or f"{program} ended with status {status}", status)
    return printed, said


def _open_terminal():
    """Opens a terminal, on which raypro reports progress ten times per second, or else a pipe: every five seconds."""
    try:
        return os.openpty()
    except OSError:
        return os.pipe()


def _listen(errors, progress):
    """Reads to the end. Passes lines of progress to the function and returns the others."""
    kept, rest, told = [], b"", ""
    while True:
        try:
            read = errors.read(65536)
        except OSError:  # how the end of a terminal looks on Linux
            read = b""
        *lines, rest = re.split(rb"\r\n|\n|\r\033\[K", rest + read)  # the last may not be whole yet
        for line in lines + [rest]:
            text = line.decode("utf-8", "replace").strip("\r")
            found = _PROGRESS.match(text)
            if found and progress and text != told:
                progress(int(found[1]) / 100, found[2] or "")
                told = text
            if not found and (line is not rest or not read):
                kept.append(text)
        if not read:
            return "\n".join(kept)


_PROGRESS = re.compile(r" *(\d+) ?%(?:  (.*))?$")


def _stop(process):
    process.terminate()
    try:
        process.wait(timeout=5)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()


def _split_warnings(said):
    """Splits warnings: each begins with a line that says so, followed by its lines with the caret."""
    return [text.strip("\n") for text in re.split(r"^(?=[^\n|]*: warning: )", said, flags=re.MULTILINE) if text.strip()]


def _in_folder(folder, name, content):
    path = pathlib.Path(folder, name)
    path.write_bytes(content)
    return str(path)


# Progress.


def _is_watched():
    return "ipykernel" in sys.modules or bool(getattr(sys.stdout, "isatty", bool)())


class _ProgressLine:
    """A line that is overwritten, and removed at the end."""

    def __init__(self):
        self._length = 0

    def __call__(self, share, text):
        self._show(f"{share:4.0%}  {text}")

    def clear(self):
        if self._length:
            self._show("")

    def _show(self, line):
        print("\r" + line.ljust(self._length), end="" if line else "\r", flush=True)
        self._length = len(line)
