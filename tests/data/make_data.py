#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the tiny scene files of this folder, one for each thing that a loader must know; `bad/` holds what it must refuse.

Run without arguments, from anywhere. Needs only Python's own library. The same files come out each time.
"""
import base64
import copy
import json
import math
import os
import struct
import zlib

HERE = os.path.dirname(os.path.abspath(__file__))
BYTE, UBYTE, SHORT, USHORT, UINT, FLOAT = 5120, 5121, 5122, 5123, 5125, 5126
CODE = {BYTE: 'b', UBYTE: 'B', SHORT: 'h', USHORT: 'H', UINT: 'I', FLOAT: 'f'}
SIZE = {'SCALAR': 1, 'VEC2': 2, 'VEC3': 3, 'VEC4': 4, 'MAT4': 16}

TRIANGLE = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
SQUARE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
SQUARE_INDICES = [0, 1, 2, 0, 2, 3]
SQUARE_UV = [(0, 1), (1, 1), (1, 0), (0, 0)]


def save(name, data):
    path = os.path.join(HERE, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, 'wb') as file:
        file.write(data if isinstance(data, bytes) else data.encode())


def png(width, height, pixel):
    """An RGBA image; pixel(x, y) gives four bytes, y = 0 is the top row."""
    rows = b''.join(b'\0' + b''.join(bytes(pixel(x, y)) for x in range(width)) for y in range(height))
    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
    header = struct.pack('>IIBBBBB', width, height, 8, 6, 0, 0, 0)
    return b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', header) + chunk(b'IDAT', zlib.compress(rows, 9)) + chunk(b'IEND', b'')


class Gltf:
    def __init__(self):
        self.bytes = bytearray()
        self.json = {'asset': {'version': '2.0', 'generator': 'make_data.py'}, 'scene': 0, 'scenes': [{'nodes': []}], 'nodes': []}

    def add(self, kind, item):
        self.json.setdefault(kind, []).append(item)
        return len(self.json[kind]) - 1

    def view(self, data, stride=None):
        while len(self.bytes) % 4:
            self.bytes.append(0)
        view = {'buffer': 0, 'byteOffset': len(self.bytes), 'byteLength': len(data)}
        if stride:
            view['byteStride'] = stride
        self.bytes += data
        return self.add('bufferViews', view)

    def accessor(self, values, kind='VEC3', component=FLOAT, **more):
        flat = [c for v in values for c in (v if isinstance(v, (tuple, list)) else (v,))]
        data = struct.pack('<%d%s' % (len(flat), CODE[component]), *flat)
        return self.add('accessors', {'bufferView': self.view(data), 'componentType': component, 'type': kind,
                                      'count': len(flat) // SIZE[kind], **more})

    def primitive(self, positions=TRIANGLE, indices=None, component=USHORT, **more):
        attributes = {'POSITION': self.accessor(positions), **more.pop('attributes', {})}
        primitive = {'attributes': attributes, **more}
        if indices is not None:
            primitive['indices'] = self.accessor(indices, 'SCALAR', component)
        return primitive

    def mesh(self, *primitives, **more):
        return self.add('meshes', {'primitives': list(primitives), **more})

    def node(self, root=True, **members):
        index = self.add('nodes', members)
        if root:
            self.json['scenes'][0]['nodes'].append(index)
        return index

    def image(self, data, **texture):
        image = self.add('images', {'bufferView': self.view(data), 'mimeType': 'image/png'})
        return self.add('textures', {'source': image, **texture})

    def document(self, uri):
        document = copy.deepcopy(self.json)
        if self.bytes:
            document['buffers'] = [{'byteLength': len(self.bytes)}]
            if uri:
                document['buffers'][0]['uri'] = uri
        return document

    def inside(self):
        return self.document('data:application/octet-stream;base64,' + base64.b64encode(self.bytes).decode())

    def save(self, name):
        if name.endswith('.glb'):
            save(name, glb(self.document(None), bytes(self.bytes)))
        else:
            save(name, json.dumps(self.inside(), indent=1))


def glb(document, binary):
    text = json.dumps(document, separators=(',', ':')).encode()
    text += b' ' * (-len(text) % 4)
    binary += b'\0' * (-len(binary) % 4)
    chunks = struct.pack('<II', len(text), 0x4E4F534A) + text
    if binary:
        chunks += struct.pack('<II', len(binary), 0x004E4942) + binary
    return struct.pack('<III', 0x46546C67, 2, 12 + len(chunks)) + chunks


def triangle():
    g = Gltf()
    g.node(mesh=g.mesh(g.primitive()))
    return g


def plain():
    triangle().save('data_uri.gltf')

    g = Gltf()
    leaf = g.node(root=False, mesh=g.mesh(g.primitive()), matrix=[0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1])
    g.node(name='parent', children=[leaf], translation=[10, 20, 30], rotation=[0, math.sqrt(0.5), 0, math.sqrt(0.5)], scale=[2, 3, 4])
    document = g.document('node%20transforms.bin')
    save('node_transforms.gltf', json.dumps(document, indent=1))
    save('node transforms.bin', bytes(g.bytes))

    g = Gltf()
    mesh = g.mesh(g.primitive(SQUARE, SQUARE_INDICES))
    for x in range(3):
        g.node(mesh=mesh, translation=[2 * x, 0, 0])
    g.save('instances.glb')

    g = triangle()
    unseen = g.node(root=False, mesh=g.mesh(g.primitive([(9, 9, 9), (8, 9, 9), (9, 8, 9)])))
    g.json['scenes'] = [{'nodes': [unseen]}, {'nodes': [0]}]
    g.json['scene'] = 1
    g.save('two_scenes.gltf')


def cameras_and_lights():
    g = triangle()
    perspective = g.add('cameras', {'type': 'perspective', 'name': 'eye', 'perspective': {'yfov': 0.5, 'znear': 0.1, 'aspectRatio': 2}})
    flat = g.add('cameras', {'type': 'orthographic', 'orthographic': {'xmag': 4, 'ymag': 3, 'znear': 0, 'zfar': 50}})
    g.node(camera=perspective, translation=[1, 2, 3], rotation=[0, math.sqrt(0.5), 0, math.sqrt(0.5)], scale=[5, 5, 5])
    g.node(camera=flat)
    g.save('cameras.gltf')

    g = triangle()
    g.json['extensionsUsed'] = g.json['extensionsRequired'] = ['KHR_lights_punctual']
    g.json['extensions'] = {'KHR_lights_punctual': {'lights': [
        {'type': 'directional', 'name': 'sun', 'color': [1, 0.5, 0.25], 'intensity': 80000},
        {'type': 'directional', 'intensity': 20000},
        {'type': 'spot', 'intensity': 50, 'range': 20, 'spot': {'innerConeAngle': 0.1, 'outerConeAngle': 0.5}},
        {'type': 'point', 'intensity': 200, 'color': [0, 1, 0]}]}}
    for light in range(4):
        g.node(translation=[light, 0, 0], rotation=[-math.sqrt(0.5), 0, 0, math.sqrt(0.5)],
               extensions={'KHR_lights_punctual': {'light': light}})
    g.save('lights.gltf')


def materials():
    red_green = lambda x, y: (255, 0, 0, 255) if x < 2 else (0, 255, 0, 64 * y)
    g = Gltf()
    sampler = g.add('samplers', {'wrapS': 33071, 'wrapT': 33648})
    texture = g.image(png(4, 4, red_green), sampler=sampler)
    material = g.add('materials', {'alphaMode': 'MASK', 'alphaCutoff': 0.25, 'doubleSided': True, 'emissiveFactor': [0, 0.5, 1],
                                   'pbrMetallicRoughness': {'baseColorFactor': [1, 0.5, 0.25, 0.75],
                                                            'baseColorTexture': {'index': texture, 'texCoord': 1}}})
    uv0, uv1 = g.accessor([(9, 9)] * 4, 'VEC2'), g.accessor(SQUARE_UV, 'VEC2')
    g.node(mesh=g.mesh(g.primitive(SQUARE, SQUARE_INDICES, material=material, attributes={'TEXCOORD_0': uv0, 'TEXCOORD_1': uv1})))
    g.save('texture_mask.glb')

    g = Gltf()
    g.add('images', {'uri': 'two%20by%20two.png'})
    texture = g.add('textures', {'source': 0})
    material = g.add('materials', {'pbrMetallicRoughness': {'baseColorTexture': {'index': texture}}})
    uv = g.accessor(SQUARE_UV, 'VEC2')
    g.node(mesh=g.mesh(g.primitive(SQUARE, SQUARE_INDICES, material=material, attributes={'TEXCOORD_0': uv})))
    g.save('texture_file.gltf')
    save('two by two.png', png(2, 2, lambda x, y: (255 * x, 255 * y, 0, 255)))

    g = Gltf()
    for x, alpha in ((0, 0.3), (2, 0.6)):
        g.node(mesh=g.mesh(g.primitive(material=g.add('materials', {'alphaMode': 'BLEND', 'pbrMetallicRoughness': {'baseColorFactor': [1, 1, 1, alpha]}}))), translation=[x, 0, 0])
    g.save('blend.glb')

    g = Gltf()
    g.json['extensionsRequired'] = ['KHR_texture_transform']
    texture = g.image(png(1, 1, lambda x, y: (1, 2, 3, 4)))
    transform = {'offset': [0.5, 0.25], 'rotation': math.pi / 2, 'scale': [2, 3]}
    material = g.add('materials', {'pbrMetallicRoughness': {'baseColorTexture': {
        'index': texture, 'extensions': {'KHR_texture_transform': transform}}}})
    uv = g.accessor([(0, 0), (1, 0), (0, 1)], 'VEC2')
    g.node(mesh=g.mesh(g.primitive(material=material, attributes={'TEXCOORD_0': uv})))
    g.save('texture_transform.gltf')

    g = Gltf()
    bytes4 = g.accessor([(255, 0, 0, 255), (0, 255, 0, 51), (0, 0, 255, 0)], 'VEC4', UBYTE, normalized=True)
    floats3 = g.accessor([(0.25, 0.5, 0.75)] * 3)
    g.node(mesh=g.mesh(g.primitive(attributes={'COLOR_0': bytes4}), g.primitive(attributes={'COLOR_0': floats3})))
    g.save('vertex_colours.gltf')


def geometry():
    g = Gltf()
    square = lambda component: g.primitive(SQUARE, SQUARE_INDICES, component)
    unindexed = g.primitive([SQUARE[i] for i in SQUARE_INDICES])
    g.node(mesh=g.mesh(square(UBYTE), square(USHORT), square(UINT), unindexed))
    g.save('indices.gltf')

    g = Gltf()
    zigzag = [(0, 0, 0), (0, 1, 0), (1, 0, 0), (1, 1, 0), (2, 0, 0)]
    centre = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
    g.node(mesh=g.mesh(g.primitive(zigzag, mode=5), g.primitive(centre, [0, 1, 2, 3], mode=6), g.primitive(mode=0), g.primitive(mode=1)))
    g.save('strip_fan.gltf')

    g = Gltf()                                                  # position, normal as bytes, uv as shorts: 20 bytes a vertex
    rows = [struct.pack('<3f4b2H', *p, 0, 0, 127, 0, 65535 * int(u), 65535 * int(v)) for p, (u, v) in zip(SQUARE, SQUARE_UV)]
    view = g.view(b''.join(rows), stride=20)
    part = lambda **members: g.add('accessors', {'bufferView': view, 'count': 4, **members})
    attributes = {'POSITION': part(componentType=FLOAT, type='VEC3'),
                  'NORMAL': part(componentType=BYTE, type='VEC3', byteOffset=12, normalized=True),
                  'TEXCOORD_0': part(componentType=USHORT, type='VEC2', byteOffset=16, normalized=True)}
    g.node(mesh=g.mesh({'attributes': attributes, 'indices': g.accessor(SQUARE_INDICES, 'SCALAR', UBYTE)}))
    g.save('interleaved.glb')

    g = Gltf()
    g.json['extensionsRequired'] = ['KHR_mesh_quantization']
    positions = g.accessor([(0, 0, 0), (32767, 0, 0), (0, 32767, 0)], 'VEC3', SHORT, normalized=True)
    g.node(mesh=g.mesh({'attributes': {'POSITION': positions}}), scale=[10, 10, 10])
    g.save('quantized.gltf')

    g = Gltf()
    indices, values = g.view(struct.pack('<2H', 0, 2)), g.view(struct.pack('<6f', 0, 0, 5, 0, 1, 5))
    sparse = {'count': 2, 'indices': {'bufferView': indices, 'componentType': USHORT}, 'values': {'bufferView': values}}
    dense = g.accessor(TRIANGLE, sparse=sparse)
    flat = g.add('accessors', {'componentType': FLOAT, 'type': 'VEC3', 'count': 3, 'sparse': sparse})
    g.node(mesh=g.mesh({'attributes': {'POSITION': dense}, 'targets': [{'POSITION': flat}], }, weights=[0]))
    g.save('sparse.gltf')

    g = Gltf()                                                  # two primitives that share one large array
    positions = g.accessor(TRIANGLE + [(5, 5, 5), (6, 5, 5), (5, 6, 5), (float('nan'), 0, 0)])
    first, second = g.accessor([0, 1, 2], 'SCALAR', USHORT), g.accessor([5, 3, 4], 'SCALAR', USHORT)
    g.node(mesh=g.mesh({'attributes': {'POSITION': positions}, 'indices': first}, {'attributes': {'POSITION': positions}, 'indices': second}))
    g.save('shared_vertices.gltf')


BOX = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
BOX_INDICES = [0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1, 2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3]
INSIDE_OUT = BOX_INDICES[::-1]


def outlines():
    """Boxes under names that say what they are; only those named shell are outlines."""
    g = Gltf()
    material = lambda pbr={}, **more: g.add('materials', {'pbrMetallicRoughness': {'baseColorFactor': [0.02, 0.01, 0.01, 1], **pbr}, **more})
    ink, red = material(), material({'baseColorFactor': [0.8, 0.1, 0.1, 1]})
    textured, glowing, blended = material({'baseColorTexture': {'index': g.image(png(1, 1, lambda x, y: (9, 9, 9, 255)))}}), material(emissiveFactor=[1, 0, 0]), material(alphaMode='BLEND')
    put = lambda name, indices, of, positions=BOX, **more: g.node(name=name, mesh=g.mesh(g.primitive(positions, indices, material=of)), **more)
    put('model', BOX_INDICES, red, translation=[0.05, 0.05, 0.05], scale=[0.9, 0.9, 0.9])
    put('shell', INSIDE_OUT, ink)
    put('mirrored shell', INSIDE_OUT, ink, translation=[0, 0, 3], scale=[-1, -1, -1])
    put('shell of three', [i + 8 * k for k in range(3) for i in INSIDE_OUT], ink, [(x + 5 * i, y, z) for i in range(3) for x, y, z in BOX])
    put('shell without indices', None, ink, [BOX[i] for i in INSIDE_OUT])
    stays = [('coloured room', INSIDE_OUT, red), ('two-sided room', INSIDE_OUT, material(doubleSided=True)), ('textured room', INSIDE_OUT, textured),
             ('glowing room', INSIDE_OUT, glowing), ('blended room', INSIDE_OUT, blended), ('black box', BOX_INDICES, ink),
             ('black room without a side', INSIDE_OUT[6:], ink), ('black sheet', INSIDE_OUT[:6], ink)]
    for i, other in enumerate(stays):
        put(*other, translation=[3 * i + 3, 0, 0])
    g.save('outlines.glb')

    g = Gltf()
    put('shell', INSIDE_OUT, material())
    g.save('only_a_shell.gltf')


def animation():
    g = Gltf()
    mesh = g.mesh(g.primitive())
    for x in range(4):
        g.node(mesh=mesh)
    times = g.accessor([0, 1, 3], 'SCALAR')
    moves = g.accessor([(0, 0, 0), (1, 2, 3), (5, 2, 3)])
    half = math.sqrt(0.5)
    turns = g.accessor([(0, 0, 0, 1), (0, 0, half, half), (0, 0, -1, 0)], 'VEC4')   # the last is the same as (0, 0, 1, 0)
    spline = [(0, 0, 0), (1, 1, 1), (0, 0, 0)] + [(0, 0, 0), (2, 2, 2), (1, 0, 0)] + [(1, 0, 0), (4, 4, 4), (0, 0, 0)]
    samplers = [{'input': times, 'output': moves}, {'input': times, 'output': moves, 'interpolation': 'STEP'},
                {'input': times, 'output': turns, 'interpolation': 'LINEAR'},
                {'input': times, 'output': g.accessor(spline), 'interpolation': 'CUBICSPLINE'}]
    paths = ['translation', 'translation', 'rotation', 'scale']
    channels = [{'sampler': i, 'target': {'node': i, 'path': p}} for i, p in enumerate(paths)]
    g.add('animations', {'name': 'all', 'samplers': samplers, 'channels': channels})
    g.add('animations', {'name': 'one', 'samplers': samplers, 'channels': channels[:1]})
    g.save('node_animation.gltf')

    g = Gltf()                                                  # a strip bent by its second joint
    positions = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 2, 0), (1, 2, 0)]
    g.node(root=False, translation=[0, 1, 0], name='upper')
    g.node(translation=[0, 0, 0], children=[0], name='lower')
    joints = g.accessor([(0, 1, 0, 0)] * 6, 'VEC4', UBYTE)
    weights = g.accessor([(1, 0, 0, 0)] * 2 + [(0.5, 0.5, 0, 0)] * 2 + [(0, 1, 0, 0)] * 2, 'VEC4')
    joints1 = g.accessor([(0, 0, 0, 9)] * 6, 'VEC4', USHORT)    # a joint of no weight may be any
    weights1 = g.accessor([(0, 0, 0, 0)] * 6, 'VEC4', UBYTE, normalized=True)
    identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
    lowered = identity[:13] + [-1] + identity[14:]
    skin = g.add('skins', {'joints': [1, 0], 'inverseBindMatrices': g.accessor([identity, lowered], 'MAT4')})
    mesh = g.mesh(g.primitive(positions, [0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 5, 4],
                              attributes={'JOINTS_0': joints, 'WEIGHTS_0': weights, 'JOINTS_1': joints1, 'WEIGHTS_1': weights1}))
    g.node(mesh=mesh, skin=skin, translation=[100, 100, 100])
    times, turns = g.accessor([0, 1], 'SCALAR'), g.accessor([(0, 0, 0, 1), (0, 0, half, half)], 'VEC4')
    g.add('animations', {'samplers': [{'input': times, 'output': turns}], 'channels': [{'sampler': 0, 'target': {'node': 0, 'path': 'rotation'}}]})
    g.save('skin.glb')

    g = Gltf()
    up, out = g.accessor([(0, 0, 1)] * 3), g.accessor([(0, 0, 0), (2, 0, 0), (0, 0, 0)])
    mesh = g.mesh(g.primitive(targets=[{'POSITION': up}, {'POSITION': out}]), weights=[0.5, 0])
    g.node(mesh=mesh)
    g.node(mesh=mesh, weights=[0, 1])
    g.node(mesh=mesh)
    times, weights = g.accessor([0, 2], 'SCALAR'), g.accessor([0, 0, 1, 1], 'SCALAR')
    g.add('animations', {'samplers': [{'input': times, 'output': weights}], 'channels': [{'sampler': 0, 'target': {'node': 2, 'path': 'weights'}}]})
    g.save('morph.gltf')


def obj():
    save('room.obj', '\ufeff# a floor, a concave wall and a leaf\nmtllib room.mtl\no floor\nv 0 0 0\nv 4 0 0\nv 4 0 4\nv 0 0 4\n'
         'vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 1 0\nusemtl red\nf 1/1/1 4/4/1 3/3/1 2/2/1\n'
         'g wall\nusemtl tiled\nv 0 0 0\nv 4 0 0\nv 4 3 0\nv 2 1 0\nv +0 3. 0\n'
         'f -5/1 -4/2 -3/3 -2/1 \\\n -1/4\ng leaf\nusemtl leaf\nf 1/1 2/2 8/3\nl 1 2\nf 1 2\n')
    save('room.mtl', 'newmtl red\nKd 1 0 0\nKe 0 0 0.5\n\nnewmtl tiled\nKd 1 1 1\nmap_Kd -s 2 3 1 -o 0.5 0.25 0 -clamp on two by two.png\n\n'
         'newmtl leaf\nKd 0.5 1 0.5\nd 0.75\nmap_d leaf.png\n\nnewmtl glass\nTr 0.9\n')
    save('leaf.png', png(2, 2, lambda x, y: (200 * y, 200 * y, 200 * y, 255)))
    save('no_mtl.obj', 'mtllib nowhere.mtl\nusemtl stone\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n')


def bad():
    base = triangle()
    binary = bytes(base.bytes)

    def variant(name, change):
        document = base.inside()
        change(document)
        save('bad/' + name + '.gltf', json.dumps(document))

    def put(*path, value):
        def change(document):
            at = document
            for key in path[:-1]:
                at = at[key] if not isinstance(at, dict) else at.setdefault(key, {})
            at[path[-1]] = value
        return change

    good = glb(base.document(None), binary)
    save('bad/empty.glb', b'')
    save('bad/truncated.glb', good[:-20])
    save('bad/header_only.glb', good[:16])
    save('bad/version_1.glb', good[:4] + struct.pack('<I', 1) + good[8:])
    save('bad/chunk_too_long.glb', good[:12] + struct.pack('<I', 0xfffffff0) + good[16:])
    save('bad/not_gltf.glb', b'MZ\x90\x00 this is a program \xff\xfe')
    save('bad/not_json.gltf', '{"asset": {"version": "2.0"},\n "nodes": [1, 2,, 3]}')
    save('bad/not_utf8.gltf', b'{"asset": {"version": "2.0", "generator": "caf\xe9"}}')
    save('bad/deep.gltf', '{"asset": {"version": "2.0"}, "extras": ' + '[' * 4000 + ']' * 4000 + '}')
    save('bad/huge_number.gltf', '{"asset": {"version": "2.0"}, "scene": 1e999}')
    save('bad/array.gltf', '[1, 2, 3]')
    save('bad/no_asset.gltf', '{"scenes": []}')
    variant('version_1', put('asset', 'version', value='1.0'))
    variant('draco', put('extensionsRequired', value=['KHR_draco_mesh_compression']))
    variant('no_triangles', put('scenes', value=[{'nodes': []}]))
    variant('only_points', put('meshes', 0, 'primitives', 0, 'mode', value=0))
    variant('huge_mesh_index', put('nodes', 0, 'mesh', value=4294967296))
    variant('negative_index', put('nodes', 0, 'mesh', value=-1))
    variant('fraction_index', put('nodes', 0, 'mesh', value=0.5))
    variant('text_index', put('nodes', 0, 'mesh', value='0'))
    variant('bad_accessor', put('meshes', 0, 'primitives', 0, 'attributes', 'POSITION', value=7))
    variant('bad_material', put('meshes', 0, 'primitives', 0, 'material', value=0))
    variant('bad_mode', put('meshes', 0, 'primitives', 0, 'mode', value=7))
    variant('bad_view', put('accessors', 0, 'bufferView', value=3))
    variant('bad_buffer', put('bufferViews', 0, 'buffer', value=1))
    variant('bad_scene', put('scene', value=5))
    variant('bad_root', put('scenes', 0, 'nodes', value=[1]))
    variant('count_zero', put('accessors', 0, 'count', value=0))
    variant('count_negative', put('accessors', 0, 'count', value=-3))
    variant('count_huge', put('accessors', 0, 'count', value=4000000000))
    variant('count_beyond', put('accessors', 0, 'count', value=1e300))
    variant('offset_overflow', put('bufferViews', 0, 'byteOffset', value=18446744073709551615))
    variant('offset_beyond', put('accessors', 0, 'byteOffset', value=8))
    variant('view_beyond', put('bufferViews', 0, 'byteLength', value=4096))
    variant('buffer_beyond', put('buffers', 0, 'byteLength', value=1099511627776))
    variant('buffer_missing', put('buffers', 0, 'uri', value='no such file.bin'))
    variant('buffer_absolute', put('buffers', 0, 'uri', value='/etc/passwd'))
    variant('buffer_network', put('buffers', 0, 'uri', value='https://example.org/a.bin'))
    variant('buffer_base64', put('buffers', 0, 'uri', value='data:application/octet-stream;base64,?!'))
    variant('buffer_none', lambda d: d['buffers'][0].pop('uri'))
    variant('component_type', put('accessors', 0, 'componentType', value=5124))
    variant('accessor_type', put('accessors', 0, 'type', value='VEC2'))
    variant('accessor_word', put('accessors', 0, 'type', value='VEC7\n'))
    variant('stride', put('bufferViews', 0, 'byteStride', value=2))
    variant('nothing_huge', put('accessors', value=[{'componentType': FLOAT, 'type': 'VEC3', 'count': 4000000000}]))
    variant('cycle', put('nodes', value=[{'mesh': 0}, {'children': [2]}, {'children': [1]}]))
    variant('own_child', put('nodes', value=[{'mesh': 0, 'children': [0]}]))
    variant('two_parents', put('nodes', value=[{'children': [2]}, {'children': [2]}, {'mesh': 0}]))
    variant('root_twice', put('scenes', 0, 'nodes', value=[0, 0]))
    variant('zero_quaternion', put('nodes', 0, 'rotation', value=[0, 0, 0, 0]))
    variant('projective_matrix', put('nodes', 0, 'matrix', value=[1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]))
    variant('short_matrix', put('nodes', 0, 'matrix', value=[1, 2, 3]))
    variant('far_away', put('nodes', 0, 'translation', value=[1e31, 0, 0]))
    variant('far_scaled', put('nodes', value=[{'mesh': 0, 'scale': [1e29, 1, 1], 'translation': [9.5e29, 0, 0]}]))
    variant('bad_camera', put('cameras', value=[{'type': 'perspective', 'perspective': {'yfov': 0, 'znear': 1}}]))
    variant('bad_near', put('cameras', value=[{'type': 'perspective', 'perspective': {'yfov': 1, 'znear': 2, 'zfar': 1}}]))
    variant('bad_light', put('extensions', value={'KHR_lights_punctual': {'lights': [{'type': 'area'}]}}))
    variant('bad_alpha', put('materials', value=[{'alphaMode': 'GLASS'}]))
    texture = lambda image: {'images': [image], 'textures': [{'source': 0}],
                             'materials': [{'pbrMetallicRoughness': {'baseColorTexture': {'index': 0}}}]}
    inside = lambda data: {'uri': 'data:image/png;base64,' + base64.b64encode(data).decode()}
    picture = png(4, 4, lambda x, y: (x, y, 0, 255))
    sized = lambda w, h: picture[:16] + struct.pack('>II', w, h) + picture[24:]
    variant('image_broken', lambda d: d.update(texture(inside(b'nothing of the kind'))))
    variant('image_truncated', lambda d: d.update(texture(inside(picture[:45]))))
    variant('image_huge', lambda d: d.update(texture(inside(sized(20000, 20)))))
    variant('image_bomb', lambda d: d.update(texture(inside(sized(16000, 16000)))))
    variant('image_missing', lambda d: d.update(texture({'uri': 'no such.png'})))
    variant('image_none', lambda d: d.update(texture({})))
    variant('no_source', lambda d: d.update({**texture({}), 'textures': [{'extensions': {'KHR_texture_basisu': {'source': 0}}}]}))

    def geometry(name, build):
        g = Gltf()
        build(g)
        g.save('bad/' + name + '.gltf')

    nan, inf = float('nan'), float('inf')
    mesh_of = lambda g, *a, **k: g.node(mesh=g.mesh(g.primitive(*a, **k)))
    geometry('nan_vertex', lambda g: mesh_of(g, [(0, 0, 0), (1, nan, 0), (0, 1, 0)]))
    geometry('infinite_vertex', lambda g: mesh_of(g, [(0, 0, 0), (1, 0, 0), (0, 1, inf)]))
    geometry('vertex_too_far', lambda g: mesh_of(g, [(0, 0, 0), (1, 0, 0), (0, 3e30, 0)]))
    geometry('zero_area', lambda g: mesh_of(g, [(0, 0, 0), (1, 0, 0), (2, 0, 0)]))
    geometry('index_beyond', lambda g: mesh_of(g, TRIANGLE, [0, 1, 3]))
    geometry('signed_indices', lambda g: mesh_of(g, TRIANGLE, [0, 1, 2], SHORT))
    geometry('uneven_attributes', lambda g: mesh_of(g, attributes={'NORMAL': g.accessor([(0, 0, 1)] * 2)}))
    geometry('joints_alone', lambda g: mesh_of(g, attributes={'JOINTS_0': g.accessor([(0, 0, 0, 0)] * 3, 'VEC4', UBYTE)}))

    def skinned(g, **skin):
        joints, weights = g.accessor([(4, 0, 0, 0)] * 3, 'VEC4', UBYTE), g.accessor([(1, 0, 0, 0)] * 3, 'VEC4')
        g.add('skins', {'joints': [0], **skin})
        g.node(mesh=g.mesh(g.primitive(attributes={'JOINTS_0': joints, 'WEIGHTS_0': weights})), skin=0)
    geometry('joint_beyond', skinned)
    geometry('skin_matrices', lambda g: skinned(g, joints=[0, 0], inverseBindMatrices=g.accessor([[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]], 'MAT4')))
    geometry('skin_joint', lambda g: skinned(g, joints=[5]))

    def sparse(index):
        def build(g):
            indices, values = g.view(struct.pack('<H', index)), g.view(struct.pack('<3f', 0, 0, 5))
            more = {'count': 1, 'indices': {'bufferView': indices, 'componentType': USHORT}, 'values': {'bufferView': values}}
            g.node(mesh=g.mesh({'attributes': {'POSITION': g.accessor(TRIANGLE, sparse=more)}}))
        return build
    geometry('sparse_index', sparse(3))

    def animated(times, values, **target):
        def build(g):
            mesh_of(g)
            samplers = [{'input': g.accessor(times, 'SCALAR'), 'output': g.accessor(values)}]
            g.add('animations', {'samplers': samplers, 'channels': [{'sampler': 0, 'target': {'node': 0, 'path': 'translation', **target}}]})
        return build
    geometry('animation_times', animated([1, 0], [(0, 0, 0)] * 2))
    geometry('animation_values', animated([0, 1], [(0, 0, 0)] * 3))
    geometry('animation_node', animated([0, 1], [(0, 0, 0)] * 2, node=1))

    def bomb(g):                                                # 2^20 triangles from nothing, a hundred times
        indices = g.add('accessors', {'componentType': UINT, 'type': 'SCALAR', 'count': 3 << 20})
        mesh = g.mesh({**g.primitive(), 'indices': indices})
        for _ in range(100):
            g.node(mesh=mesh)
    geometry('bomb', bomb)

    save('bad/empty.obj', '')
    save('bad/no_faces.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\n')
    save('bad/index_beyond.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 4\n')
    save('bad/index_before.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -4\n')
    save('bad/index_zero.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n')
    save('bad/index_huge.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4294967299\n')
    save('bad/nan.obj', 'v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n')
    save('bad/infinite.obj', 'v 0 0 0\nv 1 1e99 0\nv 0 1 0\nf 1 2 3\n')
    save('bad/short_vertex.obj', 'v 0 0\n')
    save('bad/word.obj', 'v 0 0 zero\n')
    save('bad/corner.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/ 2/ 3/\n')
    save('bad/zero_byte.obj', 'v 0 0 0\0\n')
    save('bad/unknown.xyz', 'What is this?\n')


if __name__ == '__main__':
    plain()
    cameras_and_lights()
    materials()
    geometry()
    outlines()
    animation()
    obj()
    bad()
