"""Models that lead limber to code which no file of the tree reaches: each returns
the text or the bytes of a file."""

import base64
import json
import struct
import zlib

SIDE_LARGE = 2048   # pixels: limber halves images from this side on
SIDE_GRID = 10      # vertices of a hill: enough triangles for levels of detail
FAR = 1000000       # where a model is that limber moves to near the origin


def png(side):
    """A picture whose left half is black and whose right half is white."""
    def chunk(kind, body):
        return (struct.pack('>I', len(body)) + kind + body +
                struct.pack('>I', zlib.crc32(kind + body)))

    row = b'\0' + b'\0' * (side // 2) + b'\xff' * (side // 2)
    return (b'\x89PNG\r\n\x1a\n' +
            chunk(b'IHDR', struct.pack('>IIBBBBB', side, side, 8, 0, 0, 0, 0)) +
            chunk(b'IDAT', zlib.compress(row * side, 9)) + chunk(b'IEND', b''))


class Model:
    """The parts of a glTF file, to which arrays of numbers are added."""

    def __init__(self, **parts):
        self.data = b''
        self.json = {'asset': {'version': '2.0'}, 'accessors': [],
                     'bufferViews': [], **parts}

    def view(self, data):
        """Adds bytes; returns the number of their view."""
        self.json['bufferViews'].append(
            {'buffer': 0, 'byteOffset': len(self.data), 'byteLength': len(data)})
        self.data += data + b'\0' * (-len(data) % 4)
        return len(self.json['bufferViews']) - 1

    def array(self, kind, rows, component=5126):
        """Adds an accessor of floats, or of unsigned shorts; returns its number."""
        numbers = [number for row in rows for number in row]
        code = {5126: 'f', 5123: 'H'}[component]
        accessor = {'type': kind, 'componentType': component, 'count': len(rows),
                    'bufferView': self.view(
                        struct.pack(f'<{len(numbers)}{code}', *numbers))}
        if component == 5126:
            accessor['min'] = [min(column) for column in zip(*rows)]
            accessor['max'] = [max(column) for column in zip(*rows)]
        self.json['accessors'].append(accessor)
        return len(self.json['accessors']) - 1

    def text(self):
        """The whole file."""
        uri = base64.b64encode(self.data).decode()
        self.json['buffers'] = [
            {'byteLength': len(self.data),
             'uri': 'data:application/octet-stream;base64,' + uri}]
        return json.dumps(self.json)


def hill_points():
    """The vertices of uneven ground, and its triangles."""
    last = SIDE_GRID - 1
    points = [(float(x), 0.05 * ((x * x + 3 * z) % 7), float(z))
              for z in range(SIDE_GRID) for x in range(SIDE_GRID)]
    indices = []
    for z in range(last):
        for x in range(last):
            at = z * SIDE_GRID + x
            indices += [(at,), (at + SIDE_GRID,), (at + 1,),
                        (at + 1,), (at + SIDE_GRID,), (at + SIDE_GRID + 1,)]
    return points, indices


def hill():
    """A tower on a hill without normals that a clip moves, all far from the
    origin. It has more vertices than its triangles use, a transform as a matrix,
    and a mirrored copy of the hill's mesh."""
    model = Model(scenes=[{'nodes': [0, 3]}], scene=0)
    points, indices = hill_points()
    position = model.array('VEC3', points)
    index = model.array('SCALAR', indices, 5123)
    tower = model.array('VEC3', [(4.0, 1.0, 4.0), (4.0, 6.0, 4.0), (5.0, 1.0, 4.0)]
                        + [(4.0, 1.0, 4.0)] * 20)
    times = model.array('SCALAR', [(0.0,), (1.0,)])
    way = model.array('VEC3', [(FAR, 0.0, 0.0), (FAR + 1.0, 0.0, 0.0)])
    triangle = model.array('SCALAR', [(0,), (1,), (2,)], 5123)
    model.json.update(
        meshes=[{'primitives': [{'attributes': {'POSITION': position},
                                 'indices': index}]},
                {'primitives': [{'attributes': {'POSITION': tower},
                                 'indices': triangle}]}],
        nodes=[{'mesh': 0, 'translation': [FAR, 0, 0]},
               {'mesh': 1, 'translation': [FAR, 0, 0]},
               {'mesh': 0, 'scale': [-1, 1, 1]},
               {'matrix': [1, 0, 0, 0, 0.5, 1, 0, 0, 0, 0, 1, 0, FAR, 0, 0, 1],
                'children': [2]}],
        animations=[{'samplers': [{'input': times, 'output': way}],
                     'channels': [{'sampler': 0, 'target': {
                         'node': 1, 'path': 'translation'}}]}])
    model.json['scenes'][0]['nodes'].append(1)
    return model.text()


def shining(side=8):
    """A picture that shines on one half of a sheet of which less than half of
    the vertices are used. A morph target moves one, and a joint bends it. There are
    instances of it, and a clip that moves no node."""
    model = Model(extensionsUsed=['EXT_mesh_gpu_instancing'])
    points, indices = hill_points()
    points += points[:1] * (len(points) + 1)
    last = SIDE_GRID - 1
    count = len(points)
    attributes = {
        'POSITION': model.array('VEC3', points),
        'NORMAL': model.array('VEC3', [(0.0, 1.0, 0.0)] * count),
        'TEXCOORD_0': model.array('VEC2', [(x / last, z / last)
                                           for x, _, z in points]),
        'JOINTS_0': model.array('VEC4', [(0, 1, 0, 0)] * count, 5123),
        'WEIGHTS_0': model.array('VEC4', [(x / last, 1 - x / last, 0.0, 0.0)
                                          for x, _, z in points]),
    }
    target = {'POSITION': model.array(
        'VEC3', [(0.0, 1.0 if v == 40 else 0.0, 0.0) for v in range(count)])}
    index = model.array('SCALAR', indices, 5123)
    times = model.array('SCALAR', [(0.0,), (1.0,)])
    turned = model.array('VEC4', [(0.0, 0.0, 0.0, 1.0), (0.0, 0.0, 0.6, 0.8)])
    still = model.array('VEC3', [(0.0, 0.0, 0.0), (0.0, 0.0, 0.0)])
    places = model.array('VEC3', [(0.0, 0.0, 9.0), (9.0, 0.0, 9.0)])
    image = model.view(png(side))
    model.json.update(
        images=[{'bufferView': image, 'mimeType': 'image/png'}],
        textures=[{'source': 0}],
        materials=[{'emissiveTexture': {'index': 0}, 'emissiveFactor': [1, 1, 1]}],
        meshes=[{'primitives': [{'attributes': attributes, 'targets': [target],
                                 'material': 0, 'indices': index}]},
                {'primitives': [{'attributes': {
                    name: attributes[name] for name in (
                        'POSITION', 'NORMAL', 'TEXCOORD_0')},
                    'material': 0, 'indices': index}]}],
        skins=[{'joints': [1, 2]}],
        nodes=[{'mesh': 0, 'skin': 0}, {'children': [2]}, {},
               {'mesh': 1, 'scale': [-1, 1, 1]},
               {'mesh': 1, 'extensions': {'EXT_mesh_gpu_instancing': {
                   'attributes': {'TRANSLATION': places}}}}],
        animations=[
            {'samplers': [{'input': times, 'output': turned}],
             'channels': [{'sampler': 0, 'target': {'node': 2,
                                                    'path': 'rotation'}}]},
            {'samplers': [{'input': times, 'output': still}],
             'channels': [{'sampler': 0, 'target': {'path': 'translation'}}]}],
        scenes=[{'nodes': [0, 1, 3, 4]}], scene=0)
    return model.text()


def declared():
    """An .x file far from the origin, where an animation moves it, with normals,
    texture coordinates and colours in DeclData, and a picture that there is not."""
    words = ', '.join(str(number) for number in
                      (0, 0, 1065353216, 0, 0, 4278190335) * 3)
    return ('xof 0303txt 0032\n'
            'Frame f { FrameTransformMatrix { 1,0,0,0, 0,1,0,0, 0,0,1,0, '
            f'{FAR},0,0,1;; }}\n'
            'Mesh { 3; 0;0;0;, 1;0;0;, 0;1;0;; 1; 3;0,1,2;;\n'
            'MeshMaterialList { 1; 1; 0; Material { 1;1;1;1;; 1; 1;1;1;; 0;0;0;;\n'
            'TextureFilename { "C:\\\\art\\\\none.png"; } } }\n'
            'DeclData { 3; 2;0;3;0;, 1;0;5;0;, 4;0;10;0;; 18; ' + words + '; } } }\n'
            'AnimationSet { Animation { { f } AnimationKey { 2; 2; '
            f'0;3;{FAR},0,0;;, 4800;3;{FAR + 1},0,0;;; }} }} }}\n')
