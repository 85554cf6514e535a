#!/usr/bin/env python3
"""Writes small models in the shapes that programs export, after their documentation and files of theirs. Needs Pillow.

Blender 4: manual, Wavefront OBJ export; MeshLab 2023: its exporter of OBJ with colors of vertices and of textures;
SketchUp: help, exporting OBJ files. Only the numbers are our own.
"""
import os

from PIL import Image

os.chdir(os.path.dirname(os.path.abspath(__file__)))


def write(name, text):
    with open(name, 'w') as file:
        file.write(text)


def box(low, high):
    return [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]


# Corners of a box's sides, from 1, counter-clockwise from outside: -x +x -y +y -z +z
SIDES = [(1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4)]
NORMALS = [(-1, 0, 0), (1, 0, 0), (0, -1, 0), (0, 1, 0), (0, 0, -1), (0, 0, 1)]


def blender(name, library, objects):
    """objects: (name, smooth, vertices, [(material, face)]), all with uv corners and flat normals."""
    lines = ['# Blender 4.1.1', '# www.blender.org', 'mtllib ' + library]
    first = 1
    number = 0
    for title, smooth, vertices, faces in objects:
        lines.append('o ' + title)
        lines += ['v %.6f %.6f %.6f' % v for v in vertices]
        if not smooth:
            lines += ['vn %.4f %.4f %.4f' % n for n in NORMALS]
        lines += ['vt %.6f %.6f' % uv for uv in ((0, 0), (1, 0), (1, 1), (0, 1))]
        material = None
        lines.append('s %d' % smooth)
        for i, (wanted, face) in enumerate(faces):
            if wanted != material:
                lines.append('usemtl ' + wanted)
                material = wanted
            uvs = (number * 4 + 1 + k for k in range(4))
            if smooth:
                corners = ('%d/%d' % (v - 1 + first, uv) for v, uv in zip(face, uvs))
            else:
                normal = SIDES.index(face) + 1
                corners = ('%d/%d/%d' % (v - 1 + first, uv, normal) for v, uv in zip(face, uvs))
            lines.append('f ' + ' '.join(corners))
        first += len(vertices)
        number += 1
    write(name, '\n'.join(lines) + '\n')


def mtl(title, materials):
    text = "# Blender 4.1.1 MTL File: '%s'\n# www.blender.org\n" % title
    for name, values in materials:
        text += '\nnewmtl %s\n' % name + ''.join('%s %s\n' % pair for pair in values)
    return text


# 1. Blender: a box of which one side is textured, and an octahedron that is smooth by its group.
octahedron = [(4, 1, 0), (2, 1, 0), (3, 2, 0), (3, 0, 0), (3, 1, 1), (3, 1, -1)]
triangles = [(1, 3, 5), (3, 2, 5), (2, 4, 5), (4, 1, 5), (3, 1, 6), (2, 3, 6), (4, 2, 6), (1, 4, 6)]
blender('blender_box.obj', 'blender box.mtl', [
    ('Cube', 0, box((-1, 0, -1), (1, 2, 1)), [('Red', side) for side in SIDES[:5]] + [('Wood.001', SIDES[5])]),
    ('Octahedron', 1, octahedron, [('Blue', face) for face in triangles])])
write('blender box.mtl', mtl('box.blend', [
    ('Red', [('Ns', '0.000000'), ('Ka', '1.000000 1.000000 1.000000'), ('Kd', '0.800000 0.100000 0.050000'),
             ('Ks', '0.500000 0.500000 0.500000'), ('Ke', '0.000000 0.000000 0.000000'), ('Ni', '1.450000'),
             ('d', '1.000000'), ('illum', '2')]),
    ('Wood.001', [('Ns', '0.000000'), ('Ka', '1.000000 1.000000 1.000000'), ('Ks', '0.500000 0.500000 0.500000'),
                  ('Ke', '0.000000 0.000000 0.000000'), ('Ni', '1.500000'), ('d', '1.000000'), ('illum', '2'),
                  ('map_Kd', '-s 2.000000 1.000000 1.000000 -o 0.250000 0.000000 0.000000 wood_grain.png')]),
    ('Blue', [('Ns', '90.000000'), ('Ka', '1.000000 1.000000 1.000000'), ('Kd', '0.050000 0.200000 0.700000'),
              ('Ks', '0.250000 0.250000 0.250000'), ('Ke', '0.000000 0.000000 0.000000'), ('Ni', '1.500000'),
              ('d', '1.000000'), ('illum', '2')])]))
# Four columns: in u, the texture's quarters are these grays of red.
wood = Image.new('RGB', (4, 1))
for x, level in enumerate((51, 102, 153, 204)):
    wood.putpixel((x, 0), (level, level // 2, 0))
wood.resize((64, 16), Image.NEAREST).save('wood_grain.png')

# 2. Blender: a pane, a mirror, and a side with a normal map, which Blender writes as map_Bump.
blender('blender_glass.obj', 'blender_glass.mtl', [
    ('Pane', 0, box((-1, 0, 0), (1, 2, .1)), [('Glass', side) for side in SIDES]),
    ('Metal', 0, box((-3, 0, 0), (-2, 1, 1)), [('Metal', side) for side in SIDES]),
    ('Studs', 0, box((-3, 1.5, 0), (-2, 2.5, 1)), [('Studs', side) for side in SIDES])])
write('blender_glass.mtl', mtl('glass.blend', [
    ('Glass', [('Ns', '1000.000000'), ('Ka', '1.000000 1.000000 1.000000'), ('Kd', '0.200000 0.800000 0.400000'),
               ('Ks', '0.000000 0.000000 0.000000'), ('Ke', '0.000000 0.000000 0.000000'), ('Ni', '1.450000'),
               ('d', '0.250000'), ('illum', '9')]),
    ('Metal', [('Ns', '0.000000'), ('Ka', '1.000000 1.000000 1.000000'), ('Kd', '0.100000 0.100000 0.100000'),
               ('Ks', '0.700000 0.600000 0.400000'), ('Ke', '0.000000 0.000000 0.000000'), ('Ni', '1.450000'),
               ('d', '1.000000'), ('illum', '3'), ('Pr', '0.100000'), ('Pm', '1.000000')]),
    ('Studs', [('Ns', '0.000000'), ('Ka', '1.000000 1.000000 1.000000'), ('Kd', '0.500000 0.500000 0.500000'),
               ('Ks', '0.000000 0.000000 0.000000'), ('Ke', '0.000000 0.000000 0.000000'), ('Ni', '1.450000'),
               ('d', '1.000000'), ('illum', '2'), ('map_Bump', '-bm 1.000000 blender_normals.png')])]))
# Tilted by 3-4-5: (0.6, 0, 0.8) as a color.
Image.new('RGB', (2, 2), (204, 128, 230)).save('blender_normals.png')


blender('blender_lamp.obj', 'blender_lamp.mtl',
        [('Lamp', 0, box((0, 0, 0), (1, 1, 1)), [('Lamp', side) for side in SIDES])])
write('blender_lamp.mtl', mtl('lamp.blend', [
    ('Lamp', [('Ns', '0.000000'), ('Ka', '1.000000 1.000000 1.000000'), ('Kd', '0.000000 0.000000 0.000000'),
              ('Ks', '0.000000 0.000000 0.000000'), ('Ke', '0.900000 0.600000 0.300000'), ('Ni', '1.450000'),
              ('d', '1.000000'), ('illum', '2')])]))


# 3. MeshLab: colors of vertices; normals before vertices, blanks at the ends of lines.
def meshlab(name, comment, body):
    write(name, '''####
#
# OBJ File Generated by Meshlab
#
####
# Object %s
#
%s#
####
mtllib ./%s.mtl

%s
# End of File
''' % (name, comment, name, body))


corners = box((0, 0, 0), (2, 1, 3))
vertices = ''.join('vn %.6f %.6f %.6f\nv %.6f %.6f %.6f %.6f %.6f %.6f\n'
                   % (x - 1, 2 * y - 1, (2 * z - 3) / 3, x, y, z, x / 2, y, z / 3) for x, y, z in corners)
faces = ''.join('f %s \n' % ' '.join('%d//%d' % (v, v) for v in side) for side in SIDES)
meshlab('meshlab_colors.obj', '# Vertices: 8\n# Faces: 6\n',
        vertices + '# 8 vertices, 0 vertices normals\n\nusemtl material_0\n' + faces +
        '# 6 faces, 0 coords texture\n')
write('meshlab_colors.obj.mtl', '''#
# Wavefront material file
# Converted by Meshlab Group
#

newmtl material_0
Ka 0.200000 0.200000 0.200000
Kd 1.000000 1.000000 1.000000
Ks 1.000000 1.000000 1.000000
Tr 0.000000
illum 2
Ns 0.000000

''')

# 4. MeshLab: two textures, one of them clamped, and vt right before each face.
vertices = ''.join('v %.6f %.6f %.6f\n' % corner for corner in corners)
faces = ''
for i, side in enumerate(SIDES):
    faces += ''.join('vt %f %f\n' % uv for uv in ((0, 0), (1, 0), (1, 1), (0, 1)))
    if i in (0, 3):
        faces += 'usemtl material_%d\n' % (i // 3)
    faces += 'f ' + ' '.join('%d/%d' % (v, 4 * i + k + 1) for k, v in enumerate(side)) + ' \n'
meshlab('meshlab_textures.obj', '# Vertices: 8\n# Faces: 6\n', vertices + '# 8 vertices, 0 vertices normals\n\n' + faces)
write('meshlab_textures.obj.mtl', '''#
# Wavefront material file
# Converted by Meshlab Group
#

newmtl material_0
Ka 0.200000 0.200000 0.200000
Kd 0.752941 0.752941 0.752941
Ks 1.000000 1.000000 1.000000
Tr 0.000000
illum 2
Ns 0.000000
map_Kd checker.png

newmtl material_1
Ka 0.200000 0.200000 0.200000
Kd 0.500000 1.000000 1.000000
Ks 1.000000 1.000000 1.000000
Tr 0.500000
illum 1
Ns 0.000000
map_Kd -clamp on checker.png
map_d checker.png

''')
checker = Image.new('RGB', (2, 2))
for x in range(2):
    for y in range(2):
        checker.putpixel((x, y), (255, 255, 255) if x == y else (0, 0, 255))
checker.resize((32, 32), Image.NEAREST).save('checker.png')

# 5. SketchUp: groups, CR LF, texture paths of Windows, materials that no library has.
house = ['# Alias OBJ Model File', '# Exported from SketchUp, (c) 2000-2012 Trimble Navigation Limited',
         '# File units = inches', '', 'mtllib sketchup_house.mtl', '', 'g Mesh1 Model', '', 'usemtl FrontColor']
house += ['v  %g %g %g' % corner for corner in corners]
house += ['vt  %g %g' % uv for uv in ((0, 0), (1, 0), (1, 1), (0, 1))]
house += ['vn  %g %g %g' % normal for normal in NORMALS]
house += ['f %d/1/%d %d/2/%d %d/3/%d %d/4/%d ' % (a, i, b, i, c, i, d, i)
          for i, (a, b, c, d) in enumerate(SIDES[:2], 1)]
for i, material in ((3, 'Brick_Antique'), (4, '*Roof_Tile'), (5, 'Translucent_Glass_Gray'), (6, 'Brick_Antique')):
    a, b, c, d = SIDES[i - 1]
    house += ['', 'usemtl ' + material, 'f %d/1/%d %d/2/%d %d/3/%d %d/4/%d ' % (a, i, b, i, c, i, d, i)]
write('sketchup_house.obj', '\r\n'.join(house) + '\r\n')
write('sketchup_house.mtl', '\r\n'.join('''## Alias OBJ Material File
# Exported from SketchUp, (c) 2000-2012 Trimble Navigation Limited

newmtl FrontColor
Ka 0.000000 0.000000 0.000000
Kd 1.000000 1.000000 1.000000
Ks 0.330000 0.330000 0.330000

newmtl Brick_Antique
Ka 0.000000 0.000000 0.000000
Kd 0.480392 0.270588 0.200000
Ks 0.330000 0.330000 0.330000
map_Kd sketchup_house\\Brick_Antique.png

newmtl Translucent_Glass_Gray
Ka 0.000000 0.000000 0.000000
Kd 0.600000 0.600000 0.600000
Ks 0.330000 0.330000 0.330000
d 0.500000
'''.split('\n')))
os.makedirs('sketchup_house', exist_ok=True)
Image.new('RGB', (4, 4), (204, 153, 102)).save('sketchup_house/Brick_Antique.png')
