#!/usr/bin/env python3
"""Writes the meshes of this folder with other programs' writers, and expected.txt.

    python3 -m venv venv && venv/bin/pip install trimesh pymeshlab meshio plyfile assimp-py numpy
    venv/bin/python make.py

The tests need none of it: they read the files and compare with expected.txt. A file is what a writer made, or that with
the change that is made below. The numbers are those of the mesh that was written, to five digits; the last column names
the programs that read them from the file. Made with trimesh 5.2, pymeshlab 2025.7, meshio 5.3.5, plyfile 1.1, assimp-py 1.1.
"""
import os
import re
import tempfile

import assimp_py
import meshio
import numpy as np
import plyfile
import pymeshlab
import trimesh

os.chdir(os.path.dirname(os.path.abspath(__file__)))
box = trimesh.creation.box(extents=(2, 1, 3))
box.apply_translation((1, .5, 1.5))
gem = trimesh.creation.icosphere(subdivisions=0, radius=1.5)
gem.apply_scale((1, .5, 2))
cone = trimesh.creation.cone(radius=1, height=2, sections=9)
SOURCES = {}


def write(name, mesh, data):
    SOURCES[name] = mesh
    with open(name, 'wb') as file:
        file.write(data if isinstance(data, bytes) else data.encode())


def written(suffix, save):
    """What `save` writes into a file of that suffix."""
    with tempfile.TemporaryDirectory() as folder:
        save(os.path.join(folder, 'mesh' + suffix))
        with open(os.path.join(folder, 'mesh' + suffix), 'rb') as file:
            return file.read()


def meshlab(mesh, suffix, prepare=lambda ms: None, **how):
    ms = pymeshlab.MeshSet()
    ms.add_mesh(pymeshlab.Mesh(mesh.vertices, mesh.faces))
    prepare(ms)
    return written(suffix, lambda file: ms.save_current_mesh(file, **how))


def meshio_bytes(mesh, suffix, **how):
    data = meshio.Mesh(mesh.vertices, [('triangle', mesh.faces)])
    return written(suffix, lambda file: meshio.write(file, data, **how))


def off(mesh):
    return trimesh.exchange.off.export_off(mesh, digits=6)


def obj(mesh, **how):
    return trimesh.exchange.obj.export_obj(mesh, header=None, digits=6, **how)


def stl_text(mesh):
    return trimesh.exchange.stl.export_stl_ascii(mesh)


def stl_bytes(mesh):
    return trimesh.exchange.stl.export_stl(mesh)


# OFF: numbers spread over lines in other ways than one vertex a line.
def offs():
    for name, mesh, per_line in (('pairs.off', box, 2), ('triples.off', gem, 3), ('five.off', cone, 5)):
        lines = off(mesh).split('\n')
        n = len(mesh.vertices)
        vertices = lines[2:2 + n]
        joined = [' '.join(vertices[i:i + per_line]) for i in range(0, n, per_line)]
        write(name, mesh, '\n'.join(lines[:2] + joined + lines[2 + n:]))
    lines = off(gem).split('\n')
    n = len(gem.vertices)
    write('numbers.off', gem, '\n'.join(lines[:2] + ' '.join(lines[2:2 + n]).split() + lines[2 + n:]))
    write('one_line.off', gem, ' '.join(lines[:2 + n]) + '\n' + '\n'.join(lines[2 + n:]))
    # Counts glued to the header.
    write('glued.off', gem, off(gem).replace('OFF\n', 'OFF', 1))
    write('glued_lines.off', box, off(box).replace('OFF\n8 12 0', 'OFF8\n12\n0', 1))
    write('glued_crlf.off', cone, off(cone).replace('OFF\n', 'OFF', 1).replace('\n', '\r\n'))
    write('glued_comment.off', cone, meshio_bytes(cone, '.off').decode().replace('OFF\n', 'OFF', 1))

    # MeshLab writes the letters of the header in an order of its own, and colors before normals.
    def prepare(ms):
        ms.compute_texcoord_parametrization_flat_plane_per_wedge()
        ms.compute_texcoord_transfer_wedge_to_vertex()
        ms.compute_color_by_function_per_vertex(x='255*x/2', y='255*y', z='255*z/3')
    write('ncst.off', box, meshlab(box, '.off', prepare))
    write('cst.off', box, meshlab(box, '.off', prepare, save_vertex_normal=False))
    write('nst.off', gem, meshlab(gem, '.off', prepare, save_vertex_color=False))


# PLY: values that are not finite where nothing uses them; texture coordinates of faces.
def plys():
    n = len(box.vertices)
    data = meshio.Mesh(box.vertices, [('triangle', box.faces)], point_data={'quality': np.full(n, np.nan)})
    write('nan_quality.ply', box, written('.ply', lambda file: meshio.write(file, data, binary=False)))
    data.point_data = {'quality': np.full(n, np.inf), 'radius': np.full(n, np.nan)}
    write('inf_quality.ply', box, written('.ply', lambda file: meshio.write(file, data, binary=True)))

    def elements(mesh, extra, face_extra=()):
        fields = [('x', 'f4'), ('y', 'f4'), ('z', 'f4')] + extra
        vertex = np.zeros(len(mesh.vertices), dtype=fields)
        for i, axis in enumerate('xyz'):
            vertex[axis] = mesh.vertices[:, i]
        for field, _ in extra:
            vertex[field] = np.nan
        face = np.zeros(len(mesh.faces), dtype=[('vertex_indices', 'i4', (3,)), ('confidence', 'f8')])
        face['vertex_indices'] = mesh.faces
        face['confidence'] = np.nan
        return [plyfile.PlyElement.describe(vertex, 'vertex'), plyfile.PlyElement.describe(face, 'face')]
    big = plyfile.PlyData(elements(gem, [('curvature', 'f8')]), byte_order='>')
    write('nan_curvature_big.ply', gem, written('.ply', big.write))
    text = plyfile.PlyData(elements(cone, [('intensity', 'f4')]), text=True)
    write('nan_intensity.ply', cone, written('.ply', text.write))
    normals = plyfile.PlyData(elements(box, [('nx', 'f4'), ('ny', 'f4'), ('nz', 'f4')]), text=True)
    write('nan_normals.ply', box, written('.ply', normals.write))

    def trivial(ms):
        ms.compute_texcoord_parametrization_triangle_trivial_per_wedge(textdim=64, border=0, method='Basic')

    def flat(ms):
        ms.compute_texcoord_parametrization_flat_plane_per_wedge()
    write('wedges.ply', box, meshlab(box, '.ply', trivial, binary=False))
    write('wedges_binary.ply', gem, meshlab(gem, '.ply', trivial, binary=True))
    write('wedges_flat.ply', cone, meshlab(cone, '.ply', flat, binary=True))
    vertex = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (2, 0, 0), (2, 1, 0)],
                      dtype=[('x', 'f4'), ('y', 'f4'), ('z', 'f4')])
    face = np.empty(2, dtype=[('vertex_indices', 'O'), ('texcoord', 'O')])
    face['vertex_indices'][0], face['vertex_indices'][1] = [0, 1, 2, 3], [1, 4, 5, 2]
    face['texcoord'][0], face['texcoord'][1] = [0, 0, 1, 0, 1, .5, 0, .5], [.25, 0, 1, 0, 1, 1, .25, 1]
    quads = plyfile.PlyData([plyfile.PlyElement.describe(vertex, 'vertex'),
                             plyfile.PlyElement.describe(face, 'face', val_types={'texcoord': 'f4'})], text=True)
    write('wedges_quads.ply', trimesh.Trimesh([tuple(v) for v in vertex],
                                              [[0, 1, 2], [0, 2, 3], [1, 4, 5], [1, 5, 2]], process=False),
          written('.ply', quads.write))


# OBJ
def objs():
    text = obj(box, include_normals=True)
    write('nan_normals.obj', box, re.sub(r'^vn .*$', 'vn nan nan nan', text, count=3, flags=re.M))
    write('ind_normals.obj', box, re.sub(r'^vn .*$', 'vn -1.#IND -nan(ind) 1.#QNAN', text, count=1, flags=re.M))
    write('inf_normals.obj', box, re.sub(r'^vn .*$', 'vn inf 0 0', text, flags=re.M))
    # Lines joined by a backslash with and without a blank before it.
    joined = re.sub(r'^(f \S+ \S+) (\S+)$', r'\1\\\n \2', obj(gem), flags=re.M)
    write('joined.obj', gem, joined)
    write('joined_crlf.obj', box, re.sub(r'^(f \S+) (\S+) (\S+)$', r'\1\\\n \2 \\\n \3', obj(box), flags=re.M)
          .replace('\n', '\r\n'))
    write('joined_places.obj', cone, re.sub(r'^(v \S+ \S+) (\S+)$', r'\1\\\n \2', meshio_bytes(cone, '.obj').decode(),
                                      flags=re.M))
    # Indices into lists that are not there.
    write('no_normals.obj', box, re.sub(r'^vn .*\n', '', text, flags=re.M))
    write('no_uvs.obj', cone, re.sub(r'^f (\d+) (\d+) (\d+)', r'f \1/\1 \2/\2 \3/\3', obj(cone), flags=re.M))
    write('zeros.obj', gem, re.sub(r'^f (\d+) (\d+) (\d+)', r'f \1/0/0 \2/0/0 \3/0/0', obj(gem), flags=re.M))
    ms_text = meshlab(box, '.obj').decode()
    write('no_lists.obj', box, re.sub(r'^(vn|mtllib|usemtl) .*\n', '', re.sub(r'(\d+)//(\d+)', r'\1/\2/\2', ms_text),
                                 flags=re.M))


# STL
def stls():
    write('capitals.stl', box, stl_text(box).upper())
    write('capitals_mixed.stl', gem, re.sub(r'\b(facet|vertex|solid)\b', lambda m: m[0].capitalize(),
                                       meshlab(gem, '.stl', binary=False).decode()))
    write('bom.stl', cone, b'\xef\xbb\xbf' + meshio_bytes(cone, '.stl', binary=False))
    write('blank_lines.stl', gem, '\r\n\r\n \t' + stl_text(gem).replace('\n', '\r\n'))
    write('end_solid.stl', cone, re.sub('endsolid', 'end solid', stl_text(cone)))
    write('end_solid_capitals.stl', box, re.sub('ENDSOLID', 'END SOLID', stl_text(box).upper()))
    write('end_facet.stl', cone, re.sub(r'end(\w)', r'end \1', meshlab(cone, '.stl', binary=False).decode()))
    write('nan_normals.stl', gem, re.sub(r'facet normal .*', 'facet normal -nan(ind) -nan(ind) nan', stl_text(gem)))
    write('trailing.stl', box, stl_bytes(box) + b'\0\0')
    write('trailing_text.stl', cone, meshlab(cone, '.stl') + b' end of the mesh\r\n')
    write('trailing_long.stl', gem, meshio_bytes(gem, '.stl', binary=True) + bytes(range(77)))
    for name, mesh, more in (('solid.stl', box, b''), ('solid_trailing.stl', cone, b'\r\n'),
                             ('solid_capitals_trailing.stl', gem, b'\0' * 12)):
        head = b'SOLID box' if 'capitals' in name else b'solid of a CAD program'
        write(name, mesh, head.ljust(80) + stl_bytes(mesh)[80:] + more)


# What other programs read.
def seen(points, triangles):
    a, b, c = (np.asarray(points, float)[np.asarray(triangles)[:, k]] for k in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
    used = np.asarray(points, float)[np.unique(triangles)]
    return [len(triangles), area, *used.min(axis=0), *used.max(axis=0)]


def by_trimesh(name):
    mesh = trimesh.load(name, process=False, force='mesh')
    return seen(mesh.vertices, mesh.faces)


def by_meshlab(name):
    ms = pymeshlab.MeshSet()
    ms.load_new_mesh(name)
    return seen(ms.current_mesh().vertex_matrix(), ms.current_mesh().face_matrix())


def by_assimp(name):
    scene = assimp_py.import_file(name, assimp_py.Process_Triangulate)
    points, triangles = [], []
    for mesh in scene.meshes:
        triangles += (np.asarray(mesh.indices).reshape(-1, 3) + len(points)).tolist()
        points += np.asarray(mesh.vertices).reshape(-1, 3).tolist()
    return seen(points, triangles)


def by_meshio(name):
    mesh = meshio.read(name)
    return seen(mesh.points, np.concatenate([c.data for c in mesh.cells if c.type == 'triangle']))


def by_plyfile(name):
    if not name.endswith('.ply'):
        raise ValueError
    data = plyfile.PlyData.read(name)
    points = np.stack([data['vertex'][axis] for axis in 'xyz'], axis=1)
    return seen(points, np.stack(list(data['face']['vertex_indices'])))


READERS = (by_trimesh, by_meshlab, by_assimp, by_meshio, by_plyfile)


def text(numbers):
    return ' '.join('%.5g' % (value + 0.) for value in numbers)


def agrees(reader, name, expected):
    """In a process of its own, since some readers crash over some files."""
    child = os.fork()
    if child:
        return os.waitpid(child, 0)[1] == 0
    agreed = False
    try:
        agreed = text(reader(name)) == expected
    finally:
        os._exit(0 if agreed else 1)


offs(), plys(), objs(), stls()
with open('expected.txt', 'w') as table:
    print('# file, triangles, area, least and greatest x y z, and the programs that read that. Written by make.py.',
          file=table)
    for name, mesh in sorted(SOURCES.items()):
        expected = text(seen(mesh.vertices, mesh.faces))
        readers = [reader.__name__[3:] for reader in READERS if agrees(reader, name, expected)]
        print(name, expected, ','.join(readers) or 'none', file=table)
with open('texcoords.txt', 'w') as table:
    print('# file, u v of each corner of each face, as plyfile reads them. Written by make.py.', file=table)
    for name in sorted(SOURCES):
        if name.startswith('wedges'):
            lists = plyfile.PlyData.read(name)['face']['texcoord']
            print(name, *('%.9g' % value for value in np.concatenate(lists)), file=table)
