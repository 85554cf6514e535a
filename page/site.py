#!/usr/bin/env python3
"""Gathers the page, the writeup, the gallery and the docs into a folder that any static file server can serve.

usage: page/site.py build/web build/site

Markdown becomes HTML in the look of the writeup; links to scenes open them in the page, links to files that are not
part of the site become plain text. Every image of the writeup whose command names a scene gets a link that opens that
scene with its options. SITE_URL, if set, is where the site will be, for link previews. Needs nothing but Python.
"""
import html
import json
import os
import pathlib
import posixpath
import re
import shlex
import shutil
import sys
import urllib.parse

PAGES = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "scenes/README.md", "art/README.md", "tiny/README.md",
         *sorted(str(p) for p in pathlib.Path("docs").rglob("*.md"))]
WRITEUP = sorted(str(p) for p in pathlib.Path("writeup").glob("*.html"))
COPIED = [("writeup", "*.css"), ("writeup", "*.js"), ("writeup/pictures", "*.jpg"), ("writeup/pictures", "*.png"),
          ("writeup/pictures", "*.svg"), ("art", "*.jpg"), ("art", "*.mp4"), ("docs", "*.jpg"), ("scenes/thumbnails", "*.jpg")]
MENU = [("Home", "index.html"), ("Try it", "web/index.html"), ("Features", "writeup/assignment3.html"),
        ("Other courses", "writeup/courses.html"), ("Troubleshooting", "writeup/troubleshooting.html"),
        ("Gallery", "art/index.html"), ("Scenes", "scenes/index.html"), ("Docs", "docs/index.html")]
REQUESTS = {"-check", "-debugpixel", "-explain", "-advise", "-files", "-layers", "-report", "-time", "-stats",
            "-reference"}


def target_of(source):
    """The name in the site of a Markdown file of the tree."""
    folder, name = posixpath.split(source)
    return posixpath.join(folder, "index.html" if name == "README.md" else name[:-3] + ".html")


def slug(text):
    """The anchor that GitHub gives a heading."""
    return re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")


class Site:
    def __init__(self, web, out):
        self.web, self.out = web, out
        self.scenes = {scene["name"] for scene in json.loads((web / "examples.json").read_text())["scenes"]}
        self.copied = {str(file) for folder, pattern in COPIED for file in pathlib.Path(folder).glob(pattern)}

    def link(self, address, source, target):
        """A link of a file of the tree as the site has it, or None where the site has no such file."""
        if re.match(r"[a-z]+:", address):
            return None if address.startswith("http") else address  # works offline: no page needs another server
        path, _, fragment = address.partition("#")
        if not path:
            return address
        name = posixpath.normpath(posixpath.join(posixpath.dirname(source), path))
        if name + "/README.md" in PAGES:
            name += "/README.md"
        if name in PAGES:
            goal = target_of(name) + ("#" + fragment if fragment else "")
        elif name in WRITEUP or name in self.copied:
            goal = name + ("#" + fragment if fragment else "")
        elif name in self.scenes:
            goal = self.scene_link(name)
        else:
            return None
        return posixpath.relpath(goal.split("#")[0], posixpath.dirname(target) or ".") + goal[len(goal.split("#")[0]):]

    def scene_link(self, scene, options=None):
        query = "scene=" + scene
        if options is not None:
            query += "&options=" + " ".join(options)
        return "web/index.html#" + urllib.parse.quote(query, safe="=&/-._")

    def menu(self, target):
        links = []
        for name, goal in MENU:
            here = ' aria-current="page"' if goal == target else ""
            links.append(f'<a href="{posixpath.relpath(goal, posixpath.dirname(target) or ".")}"{here}>{name}</a>')
        return '<p class="pages">' + "\n".join(links) + "</p>"

    def page(self, target, title, body, about="", picture="art/valley.jpg"):
        up = posixpath.relpath(".", posixpath.dirname(target) or ".")
        preview = f'<meta property="og:title" content="{html.escape(title)}">\n'
        if about:
            preview += f'<meta name="description" content="{html.escape(about)}">\n'
            preview += f'<meta property="og:description" content="{html.escape(about)}">\n'
        if os.environ.get("SITE_URL"):
            preview += f'<meta property="og:image" content="{os.environ["SITE_URL"].rstrip("/")}/{picture}">\n'
        kind = "" if 'class="pictures' in body else ' class="prose"'
        text = (f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
                f'<meta name="viewport" content="width=device-width, initial-scale=1">\n'
                f'<title>{html.escape(title)}</title>\n{preview}'
                f'<link rel="stylesheet" href="{up}/writeup/style.css">\n<link rel="icon" href="{up}/web/icon.svg">\n'
                f'</head>\n<body{kind}>\n<header>\n{self.menu(target)}\n</header>\n<main class="text">\n{body}\n</main>\n'
                f'</body>\n</html>\n')
        self.write(target, text)

    def write(self, target, text):
        file = self.out / target
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)


def size_of_jpeg(file):
    """Width and height as attributes, which keep a place for the image (ITU-T T.81, B.2.2: the frame header)."""
    data, at = file.read_bytes(), 2
    if data[:2] != b"\xff\xd8":
        sys.exit(f"site.py: {file} is not a JPEG")
    number = lambda place: int.from_bytes(data[place:place + 2], "big")
    while data[at + 1] not in (0xC0, 0xC2):
        at += 2 + number(at + 2)
    return f'width="{number(at + 7)}" height="{number(at + 5)}"'


class Markdown:
    """The Markdown of this tree: headings, paragraphs, lists, tables, code, images, links, bold and code words."""

    def __init__(self, site, source):
        self.site, self.source, self.target = site, source, target_of(source)
        self.title, self.about = source, ""

    def inline(self, text):
        parts = re.split(r"(`+[^`]+`+)", text)
        text = "".join(self.code_words(part.strip("`")) if i % 2 else self.words(part)
                       for i, part in enumerate(self.with_links(parts)))
        return re.sub(r"\*\*([^*]+)\*\*", r"<strong>\1</strong>", text)

    def code_words(self, text):
        """Options are not broken behind their dash."""
        return "<code>" + re.sub(r"(?<!\S)-[a-z_]+", r"<span>\g<0></span>", html.escape(text)) + "</code>"

    def with_links(self, parts):
        """Code within the brackets of a link is kept with it."""
        whole = []
        for i, part in enumerate(parts):
            if whole and re.search(r"\[[^\]]*$", whole[-1]) and len(whole) % 2 == 1:
                whole[-1] += re.sub(r"^`+|`+$", "\x00", part) if i % 2 else part
            elif i % 2 and len(whole) % 2 == 0:
                whole += ["", part]
            elif not i % 2 and len(whole) % 2 == 1:
                whole[-1] += part
            else:
                whole.append(part)
        return whole

    def words(self, text):
        text = html.escape(text, quote=False)
        text = re.sub(r"!\[([^\]]*)\]\(([^) ]+)\)", self.image, text)
        text = re.sub(r"\[([^\]]+)\]\(([^) ]+)\)", self.anchor, text)
        text = re.sub(r"\x00([^\x00]*)\x00", r"<code>\1</code>", text)
        return re.sub(r"(?<![\w*])\*([^*\s][^*]*)\*(?![\w*])", r"<em>\1</em>", text)

    def image(self, found):
        goal = self.site.link(found[2], self.source, self.target)
        if not goal:
            return html.escape(found[1])
        size = size_of_jpeg(pathlib.Path(self.source).parent / found[2])
        return f'<img src="{goal}" {size} alt="{html.escape(found[1])}">'

    def anchor(self, found):
        goal = self.site.link(found[2], self.source, self.target)
        return f'<a href="{html.escape(goal)}">{found[1]}</a>' if goal else found[1]

    def convert(self, text):
        lines = re.sub(r"<!--.*?-->\n?", "", text, flags=re.S).splitlines()
        self.lines, self.at, out = lines, 0, []
        while self.at < len(lines):
            out.append(self.block())
        return "\n".join(block for block in out if block)

    def take_while(self, is_in):
        begin = self.at
        while self.at < len(self.lines) and is_in(self.lines[self.at]):
            self.at += 1
        return self.lines[begin:self.at]

    def block(self):
        line = self.lines[self.at]
        if not line.strip():
            self.at += 1
            return ""
        if line.startswith("```"):
            self.at += 1
            code = self.take_while(lambda one: not one.startswith("```"))
            self.at += 1
            return self.code(code)
        if line.startswith("    "):
            code = self.take_while(lambda one: one.startswith("    ") or not one.strip())
            return self.code(one[4:] for one in code)
        if found := re.match(r"(#+) (.*)", line):
            self.at += 1
            return self.heading(len(found[1]), found[2])
        if line.startswith("|"):
            return self.table(self.take_while(lambda one: one.startswith("|")))
        if re.match(r"([-*]|\d+\.) ", line):
            return self.list(line)
        text = self.take_while(lambda one: one.strip() and not re.match(r"#|\||```|[-*] |\d+\. ", one))
        if not text:
            text = [line]
            self.at += 1
        return self.paragraph(" ".join(text))

    def code(self, lines):
        return '<pre tabindex="0">' + html.escape("\n".join(lines).rstrip("\n")) + "</pre>"

    def heading(self, level, text):
        if level == 1:
            self.title = re.sub(r"[`*]", "", text)
        return f'<h{level} id="{slug(re.sub(r"[`*]", "", text))}">{self.inline(text)}</h{level}>'

    def paragraph(self, text):
        if not self.about and not text.startswith("!"):
            self.about = re.sub(r"[`*]|\[|\]\([^)]*\)", "", text)[:200]
        return "<p>" + self.inline(text) + "</p>"

    def list(self, first):
        is_ordered, items = first[0].isdigit(), []
        for line in self.take_while(lambda one: re.match(r"([-*]|\d+\.) |  +\S", one)):
            if re.match(r"([-*]|\d+\.) ", line):
                items.append(re.sub(r"^\S+ +", "", line))
            else:
                items[-1] += " " + line.strip()
        tag = "ol" if is_ordered else "ul"
        return f"<{tag}>" + "".join(f"<li>{self.inline(item)}</li>" for item in items) + f"</{tag}>"

    def table(self, lines):
        split = lambda line: re.split(r"(?<!\\)\|", line.strip().strip("|"))
        rows = [[cell.replace("\\|", "|").strip() for cell in split(line)] for line in lines]
        if any("![" in cell for row in rows[2:] for cell in row):
            return self.cards(rows[0], rows[2:])
        cell = lambda text, tag: f'<{tag} class="words">{self.inline(text)}</{tag}>'
        cells = lambda row, tag: "<tr>" + "".join(cell(text, tag) for text in row) + "</tr>"
        body = "\n".join(cells(row, "td") for row in rows[2:])
        return (f'<div class="scroll" tabindex="0"><table><thead>{cells(rows[0], "th")}</thead><tbody>\n'
                f'{body}</tbody></table></div>')

    def cards(self, heads, rows):
        """Makes figures, which fit any width, of a table of images. An image leads to its scene, or to itself."""
        figures = []
        for row in rows:
            image = next(self.inline(cell) for cell in row if "![" in cell)
            words = [self.inline(cell + " s" if head == "seconds" else cell)
                     for head, cell in zip(heads, row) if cell and "![" not in cell]
            scene = re.search(r'href="([^"]*#scene=[^"]*)"', " ".join(words))
            goal = scene[1] if scene else re.search(r'src="([^"]*)"', image)[1]
            image = image.replace("<img", '<img loading="lazy"')
            caption = " · ".join(words)
            figures.append(f'<figure><a href="{goal}">{image}</a>\n<figcaption>{caption}</figcaption></figure>')
        small = " small" if "thumbnails/" in figures[0] else ""
        return f'<div class="pictures{small}">\n' + "\n".join(figures) + "\n</div>"


def convert(site, source):
    markdown = Markdown(site, source)
    body = markdown.convert(pathlib.Path(source).read_text())
    if source == "README.md":
        body = re.sub(r"(<img [^>]*>)", r'<a href="web/index.html">\1</a>', body, count=1)
        body = body.replace("</p>", '</p>\n<p class="try"><a href="web/index.html">Try it in your browser</a></p>', 1)
    site.page(target_of(source), markdown.title, body, markdown.about)


def edit_links(site, text):
    """Adds to each figure of the writeup the link that opens its scene."""

    def with_link(found):
        words = shlex.split(html.unescape(re.sub(r"<[^>]*>", "", found[1])))
        is_image = words[0] == "build/raypro" and not words[2].startswith("-") and not REQUESTS & set(words)
        if not is_image or words[1] not in site.scenes:
            return found[0]
        goal = site.scene_link(words[1], words[3:])
        return found[0] + f'<a class="edit" href="../{html.escape(goal)}">edit this scene</a>'

    return re.sub(r'<code class="command">(.*?)</code>', with_link, text)


def copy_writeup(site, source):
    text = pathlib.Path(source).read_text()
    menu = site.menu(source)
    inner = [link for link in re.findall(r'<a href="(?!\.\./)[^"]*"[^>]*>[^<]*</a>', text.partition("</header>")[0])
             if re.search(r'"(.*?)\.html', link)[1] not in ("courses", "troubleshooting")]  # which the menu has
    menu += '<p class="pages">' + "\n".join(inner) + "</p>" if 'aria-current' in "".join(inner) else ""
    text = re.sub(r'<p class="pages">.*?</p>', lambda _: menu, text, count=1, flags=re.S)

    def linked(found):
        goal = site.link(html.unescape(found[1]), source, source)
        return f'<a href="{html.escape(goal)}"{found[2]}>{found[3]}</a>' if goal else found[3]

    head, tail = text.split(menu)
    text = head + menu + re.sub(r'<a href="([^"]*)"([^>]*)>(.*?)</a>', linked, tail, flags=re.S)
    site.write(source, edit_links(site, text))


def docs_index(site):
    items = []
    for source in PAGES:
        if source.startswith("docs/") or source in ("CONTRIBUTING.md", "CHANGELOG.md"):
            text = pathlib.Path(source).read_text()
            title = re.search(r"^# (.*)", text, re.M)[1].replace("`", "")
            goal = posixpath.relpath(target_of(source), "docs")
            items.append(f'<li><a href="{goal}">{html.escape(title)}</a></li>')
    site.page("docs/index.html", "Documentation of raypro", "<h1>Documentation</h1>\n<ul>" + "\n".join(items) + "</ul>",
              "All documents of raypro.")


def main():
    web, out = map(pathlib.Path, sys.argv[1:3])
    shutil.rmtree(out, ignore_errors=True)
    site = Site(web, out)
    shutil.copytree(web, out / "web", ignore=shutil.ignore_patterns("hashes.json"))
    for file in sorted(site.copied):
        (out / file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, out / file)
    for source in PAGES:
        convert(site, source)
    for source in WRITEUP:
        copy_writeup(site, source)
    docs_index(site)
    size = sum(file.stat().st_size for file in out.rglob("*") if file.is_file())
    print(f"{out}: {size / 1e6:.1f} MB; python3 -m http.server -d {out}, then http://localhost:8000")


main()
