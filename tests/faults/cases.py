"""The command lines that faults.py makes fail."""

import dataclasses
import os

TREE = os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..'))
GLTF = os.path.join(TREE, 'tests', 'fixtures', 'gltf')
SKIN = os.path.join(GLTF, 'skin', 'and_morph.gltf')
TEXTURES = os.path.join(GLTF, 'material', 'textures.gltf')
XFILE = os.path.join(TREE, 'tests', 'fixtures', 'xfile', 'tower_binary_packed.x')
SLIDER = os.path.join(TREE, 'tests', 'cli', 'slider.gltf')

# Files beside the folders in which the cases run.
INPUTS = {
    'buttons': '0 RIGHT down\n40 RIGHT up\n80 F8 down\n120 F8 up\n'
               '160 F6 down\n200 F6 up\n',
    'limber.conf': '[display]\nsize = 32x32\n',
}


@dataclasses.dataclass
class Case:
    """A command line. Its files exist before it runs."""

    name: str
    arguments: list
    files: tuple = ()
    varying: tuple = ()           # files that hold times
    prints_the_same: bool = True  # not if it prints times
    statuses: tuple = (0,)
    growing: tuple = ()           # files that hold what limber has done so far
    own_memory: bool = False      # only limber's own allocations fail
    may_do_without: tuple = ()    # sentences about what limber can do without


SMALL = ['--size', '32x32', '--gl', 'soft']
PLAY = ['play', '--display', 'null', '--clock', 'fixed:25', '--frames', '8',
        '--script', '../buttons', '--no-labels'] + SMALL
RENDER = ['render', '--frames', '1', '-o', 'x.png'] + SMALL

CASES = [
    Case('help', ['--help']),
    Case('info', ['info', SKIN]),
    Case('info-json', ['info', '--json', TEXTURES]),
    Case('info-x', ['info', '--json', XFILE]),
    Case('doctor-model', ['doctor', SKIN]),
    Case('doctor-model-json', ['doctor', '--json', TEXTURES]),
    Case('doctor', ['doctor', '--json', '--config', '../limber.conf'],
         prints_the_same=False, statuses=(0, 1), own_memory=True),
    Case('pose', ['pose', SKIN, '--clip', '0', '--time', '0.3', '-o', 'x.obj'],
         files=('x.obj',)),
    Case('pose-x', ['pose', XFILE, '-o', 'x.obj'], files=('x.obj',)),
    Case('render-png', RENDER + [TEXTURES], files=('x.png',)),
    Case('render-config', ['render', '--frames', '1', '-o', 'x.png', '--gl',
                           'soft', '--config', '../limber.conf', SKIN],
         files=('x.png',)),
    Case('render-labels', RENDER + ['--size', '96x64', SLIDER],
         files=('x.png',)),
    Case('render-gif', ['render', '-o', 'x.gif', '--frames', '4', XFILE] + SMALL,
         files=('x.gif',)),
    Case('render-y4m', ['render', '-o', 'x.y4m', '--frames', '4', SKIN] + SMALL,
         files=('x.y4m',)),
    Case('export', ['export', SKIN, '--c', 'x.c'], files=('x.c',)),
    Case('optimize', ['optimize', SKIN, '--size', '32x32', '-o', 'x.glb'],
         files=('x.glb',)),
    Case('compare', ['compare', SKIN, '--fps', '4', '--size', '32x32',
                     '--format', 'json', '--plot', 'x.svg', '--export', 'baked'],
         files=('x.svg',), varying=('x.svg',), prints_the_same=False),
    Case('bench', ['bench', '--runs', '1', '--json', SKIN],
         prints_the_same=False),
    Case('play-record', PLAY + [SKIN, '--record', 'x.gif', '--record-buttons',
                                'x.buttons', '--stats', 'x.json'],
         files=('x.gif', 'x.buttons', 'x.json'), varying=('x.json',),
         growing=('x.buttons',)),
    Case('play-camera', PLAY + ['--demo', 'face', '--camera', 'pattern',
                                '--camera-use', 'motion', '--record', 'x.y4m'],
         files=('x.y4m',), may_do_without=('--camera pattern: ',)),
    Case('demo-walker', RENDER + ['--demo', 'walker'], files=('x.png',)),
    Case('demo-arm', RENDER + ['--demo', 'arm'], files=('x.png',)),
    Case('demo-face', RENDER + ['--demo', 'face'], files=('x.png',)),
    Case('demo-crowd', RENDER + ['--demo', 'crowd', '--walkers', '2'],
         files=('x.png',)),
    Case('demo-duel', RENDER + ['--demo', 'duel'], files=('x.png',)),
    Case('demo-tuner', RENDER + ['--demo', 'tuner'], files=('x.png',)),
]
