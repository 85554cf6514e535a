#!/usr/bin/env python3
"""Compares the advice of raypro -advise with ten settings tried: script/advice.py [raypro]

For each scene it follows the advice, renders with each of the ten settings, and prints processor seconds until the
error asked for is claimed, from the start of the program to the file: the least of two runs each, on one thread. A render
whose claim is above the error does not count. The last column is the time of the advice over that of the best setting.
Behind raypro, scenes of one's own may be named, 256 pixels wide, to an error of 2."""
import json
import os
import re
import subprocess
import sys
import tempfile

# Scene, pixels a side, error, and options asked for.
CASES = [("hello", 384, "2", ""), ("area_light", 256, "1", ""), ("many_lights", 256, "2", ""),
         ("room", 160, "4", "-mode path"), ("indirect", 256, "4", ""), ("sphere_light", 512, "2", ""),
         ("lens", 384, "1", ""), ("environment", 192, "2", ""), ("gloss", 256, "2", ""), ("glass", 384, "1", ""),
         ("emissive", 256, "2", ""), ("refraction", 256, "3", "-mode path")]
TRIED = ["-error {e}", "-error {e} -shadow_samples 1", "-error {e} -shadow_samples 4", "-error {e} -lights one",
         "-error {e} -lights all", "-error {e} -adaptive off", "-samples 4 -denoise", "-samples 16 -denoise",
         "-samples 64 -denoise", "-samples 8 -denoise -shadow_samples 1"]
NEVER = float("inf")


def seconds_to_claim(command, image, error, patience):
    """The processor seconds of a render; infinity if it claims more than the error, or takes longer than patience."""
    report = image + ".json"
    least = NEVER
    for _ in range(2):
        before = os.times()
        try:
            subprocess.run([*command, image, "-threads", "1", "-quiet", "-report", report], check=True,
                           stderr=subprocess.DEVNULL, timeout=patience)
        except subprocess.TimeoutExpired:
            return NEVER
        after = os.times()
        least = min(least, after.children_user + after.children_system - before.children_user - before.children_system)
    with open(report, encoding="utf-8") as file:
        claim = json.load(file)["error"]
    return least if claim["high"] <= error else NEVER


def compare(raypro, scene, side, error, asked, folder):
    """Prints a row for the scene, and returns by how much the advice is slower than the best setting."""
    command = [raypro, scene, "-width", str(side), "-height", str(side), *asked.split()]
    advice = subprocess.run([*command, "-error", error, "-advise"], check=True, capture_output=True, text=True).stdout
    found = re.search(r"add: (.*)", advice)
    add = found[1].split() if found else []
    if "-denoise" not in add:
        add += ["-error", error]
    image = os.path.join(folder, "image.png")
    advised = seconds_to_claim(command + add, image, float(error), 100)
    best, least = "", NEVER
    for words in TRIED:
        patience = 10 + 4 * min(least, advised)  # other programs may be running
        seconds = seconds_to_claim(command + words.format(e=error).split(), image, float(error), patience)
        if seconds <= least:
            best, least = words, seconds
    ratio = advised / least
    name = os.path.basename(scene).removesuffix(".scn")
    print(f"{name:16} {error:>4} {advised:8.2f} {' '.join(add):48} {least:8.2f} {best.format(e=error):42} {ratio:5.2f}",
          flush=True)
    return ratio


def main():
    raypro = sys.argv[1] if len(sys.argv) > 1 else "build/raypro"
    scenes = sys.argv[2:]
    cases = [(path, 256, "2", "") for path in scenes] or [(f"scenes/{c[0]}.scn", *c[1:]) for c in CASES]
    with tempfile.TemporaryDirectory() as folder:
        ratios = [compare(raypro, *case, folder) for case in cases]
    print(f"worst {max(ratios):.2f}, within 1.3: {sum(ratio <= 1.3 for ratio in ratios)} of {len(ratios)}")


main()
