#!/usr/bin/env python3
"""Writes the images beside it, with the OpenEXR of PyPI: pip install OpenEXR numpy.
Every stored pixel of channel c (R 0, G 1, B 2, Y 0) at x y, counted from the origin of both windows, is x + 10 y + c / 4."""
import os

import numpy
import OpenEXR

os.chdir(os.path.dirname(os.path.abspath(__file__)))


def write(name, data, display, channels='RGB', kind=OpenEXR.scanlineimage, **more):
    left, top, right, bottom = data
    x, y = numpy.meshgrid(numpy.arange(left, right + 1), numpy.arange(top, bottom + 1))
    pixels = {c: (x + 10 * y + {'G': 1, 'B': 2}.get(c, 0) / 4).astype('float16') for c in channels}
    window = lambda w: (numpy.array(w[:2], 'int32'), numpy.array(w[2:], 'int32'))
    header = {'compression': OpenEXR.ZIPS_COMPRESSION, 'type': kind, 'dataWindow': window(data),
              'displayWindow': window(display), **more}
    with OpenEXR.File(header, pixels) as file:
        file.write(name)


write('within.exr', (2, 1, 5, 3), (0, 0, 7, 4))
write('beyond.exr', (-2, -1, 8, 6), (1, 2, 4, 4))
write('aside.exr', (-3, 1, 2, 9), (-1, -2, 5, 3))
write('apart.exr', (10, 10, 12, 11), (0, 0, 3, 1))
write('gray.exr', (-1, 0, 1, 1), (-2, -1, 2, 2), 'Y')
tiles = OpenEXR.TileDescription()
tiles.xSize = tiles.ySize = 4
write('tiled.exr', (1, -1, 6, 4), (0, 0, 4, 6), 'ARGB', OpenEXR.tiledimage, tiles=tiles)
