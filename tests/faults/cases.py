"""The command lines that faults.py makes fail: those of CASES, and those of the
reference texts and films, tests/golden/texts.txt and films.txt."""

import dataclasses
import os
import re
import shlex

import models

TREE = os.path.abspath(os.path.join(os.path.dirname(__file__), '..', '..'))
ASSETS = os.path.join(TREE, 'assets')
GOLDEN = os.path.join(TREE, 'tests', 'golden')
GLTF = os.path.join(TREE, 'tests', 'fixtures', 'gltf')
SKIN = os.path.join(GLTF, 'skin', 'and_morph.gltf')
LEVELS = os.path.join(GLTF, 'mesh', 'levels.gltf')
TEXTURES = os.path.join(GLTF, 'material', 'textures.gltf')
MIRROR = os.path.join(GLTF, 'clip', 'mirror.gltf')
XFILE = os.path.join(TREE, 'tests', 'fixtures', 'xfile', 'tower_binary_packed.x')
SLIDER = os.path.join(TREE, 'tests', 'cli', 'slider.gltf')
BINARY = os.path.join(GLTF, 'container', 'binary.glb')
WALKER = os.path.join(ASSETS, 'walker.glb')
FACE = os.path.join(ASSETS, 'face.glb')
FAKE_GLES = os.path.join(TREE, 'build', 'host', 'unit', 'fake_gles.so')

# Files beside the folders in which the cases run.
INPUTS = {
    'buttons': '0 RIGHT down\n40 RIGHT up\n80 F8 down\n120 F8 up\n'
               '160 F6 down\n200 F6 up\n',
    'limber.conf': '[display]\nsize = 32x32\n',
    # Saves a picture, and presses ENTER, at which the tuner saves a preset.
    'saving': '0 F9 down\n40 F8 down\n80 F8 up\n120 F9 up\n'
              '160 ENTER down\n200 ENTER up\n',
    # An upper body that only takes what its clip moves.
    'moved.character': '[layer upper]\nclip = both\nnodes = moved\n',
    # faults.py lets limber write known.levels.
    'hill.gltf': models.hill(),
    'known.gltf': models.hill(),
    'shining.gltf': models.shining(),
    'large.gltf': models.shining(models.SIDE_LARGE),
    'declared.x': models.declared(),
}


@dataclasses.dataclass
class Case:
    """A command line. Its files exist before it runs."""

    name: str
    arguments: list
    files: tuple = ()
    given: dict = dataclasses.field(default_factory=dict)  # copies of files
    variables: dict = dataclasses.field(default_factory=dict)  # of the environment
    varying: tuple = ()           # files that hold times
    prints_the_same: bool = True  # not if it prints times
    statuses: tuple = (0,)
    leaves: tuple = ()            # files that it leaves behind if it fails
    growing: tuple = ()           # files that hold what limber has done so far
    finds: bool = False           # it may print why it fails
    own_memory: bool = False      # only limber's own allocations fail
    kinds: tuple = ()             # the only kinds of calls that fail, or all
    may_do_without: tuple = ()    # sentences about what limber can do without
    reference: bool = False       # of tests/golden: only its new sites fail


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
    # Small models first: they reach most sites, in a tenth of the time.
    Case('crowd-model', RENDER + ['--demo', 'crowd', SKIN], files=('x.png',)),
    Case('duel-model', RENDER + ['--demo', 'duel', SKIN], files=('x.png',)),
    Case('duel-levels', RENDER + ['--demo', 'duel', LEVELS], files=('x.png',)),
    Case('tuner-model', RENDER + ['--demo', 'tuner', SKIN], files=('x.png',)),
    Case('demo-walker', RENDER + ['--demo', 'walker'], files=('x.png',)),
    Case('demo-arm', RENDER + ['--demo', 'arm'], files=('x.png',)),
    Case('demo-face', RENDER + ['--demo', 'face'], files=('x.png',)),
    Case('demo-crowd', RENDER + ['--demo', 'crowd', '--walkers', '2'],
         files=('x.png',)),
    Case('demo-duel', RENDER + ['--demo', 'duel'], files=('x.png',)),
    Case('demo-tuner', RENDER + ['--demo', 'tuner'], files=('x.png',)),

    Case('info-glb', ['info', BINARY]),
    Case('doctor-character', ['doctor', 'x.glb'], finds=True,
         given={'x.glb': WALKER,
                'presets.ini': os.path.join(ASSETS, 'presets.ini'),
                'x.character': os.path.join(ASSETS, 'walker.character')}),
    Case('pose-glb', ['pose', BINARY, '-o', 'x.obj', '--math', 'fixed'],
         files=('x.obj',)),
    Case('character', ['character', WALKER, '-o', 'x.character']),
    Case('levels', ['levels', FACE, '-o', 'x.levels'], files=('x.levels',)),
    Case('render-levels', RENDER + ['x.gltf'], files=('x.png',),
         given={'x.gltf': SKIN, 'x.levels': SKIN}),
    Case('render-character', ['render', '-o', 'x.y4m', '--frames', '3', WALKER,
                              '--character', os.path.join(
                                  GOLDEN, 'characters', 'effects.character')] +
         SMALL, files=('x.y4m',)),
    Case('render-numbers', RENDER + ['--frames', '3', SLIDER, '--hud',
                                     '--stats', 'x.json'],
         files=('x-0001.png', 'x-0002.png', 'x-0003.png', 'x.json'),
         varying=('x.json',)),
    Case('optimize-again', ['optimize', BINARY, '-o', 'x.glb'],
         files=('x.glb',), given={'x.glb': BINARY}),
    Case('compare-threads', ['compare', SKIN, '--fps', '4', '--jobs', '3'],
         prints_the_same=False),
    Case('play-saving', PLAY + ['--demo', 'tuner', '--script', '../saving',
                                '--failsafe', 'x.starts'],
         files=('limber-0001.png', 'presets.ini'),
         given={'presets.ini': os.path.join(ASSETS, 'presets.ini')},
         leaves=('x.starts',),
         may_do_without=('limber-0002.png: ', 'presets.ini: ', 'x.starts: ',
                         'a picture of 32x32')),
    Case('play-image', PLAY + ['--display', 'image', '-o', 'x.png', SLIDER],
         files=('x.png',)),
    Case('play-osmesa', PLAY + ['--gl', 'osmesa', SLIDER], own_memory=True,
         kinds=('alloc', 'library')),
    Case('play-window', PLAY + ['--display', 'window', SLIDER],
         variables={'SDL_VIDEODRIVER': 'dummy'}, own_memory=True,
         kinds=('alloc', 'library')),
    Case('play-egl', PLAY + ['--display', 'egl', '--gl', 'gles1', SLIDER],
         variables={'LIMBER_EGL': FAKE_GLES, 'LIMBER_GLES': FAKE_GLES,
                    'FAKE_GLES_LOG': '/dev/null'}, own_memory=True,
         kinds=('alloc', 'library')),
    Case('play-gles1', PLAY + ['--gl', 'gles1', SLIDER],
         variables={'LIMBER_EGL': FAKE_GLES, 'LIMBER_GLES': FAKE_GLES,
                    'FAKE_GLES_LOG': '/dev/null'}, own_memory=True,
         kinds=('alloc', 'library')),
    Case('play-missing', PLAY + ['--buttons', 'evdev', '--camera', 'auto', SLIDER],
         may_do_without=('--camera auto: ', 'camera auto: ', 'evdev: ')),
    Case('play-watchdog', PLAY + ['--watchdog', 'x.dog', SLIDER],
         files=('x.dog',), given={'x.dog': '/dev/null'}, varying=('x.dog',),
         may_do_without=('x.dog: ',)),
    Case('play-moved', PLAY + ['--character', '../moved.character', SKIN]),
    Case('play-little-memory', PLAY + ['--memory', '200k', '../hill.gltf']),
    Case('show-walker', RENDER + ['--demo', 'walker', '--show',
                                  'skeleton,weights,wireframe,layers'],
         files=('x.png',)),
    Case('show-face', RENDER + ['--demo', 'face', '--show', 'keys,curve'],
         files=('x.png',)),
    Case('show-arm', RENDER + ['--demo', 'arm', '--show', 'pivots'],
         files=('x.png',)),

    Case('info-declared', ['info', '../declared.x']),
    Case('doctor-hill', ['doctor', '../hill.gltf'], finds=True),
    Case('levels-hill', ['levels', '../hill.gltf', '-o', 'x.levels'],
         files=('x.levels',)),
    Case('render-hill', RENDER + ['../hill.gltf'], files=('x.png',)),
    Case('render-known-levels', RENDER + ['../known.gltf'], files=('x.png',)),
    Case('render-large', RENDER + ['../large.gltf'], files=('x.png',)),
    Case('optimize-hill', ['optimize', '../hill.gltf', '-o', 'x.glb'],
         files=('x.glb',)),
    Case('optimize-shining', ['optimize', '../shining.gltf', '--size', '32x32',
                              '-o', 'x.glb'], files=('x.glb',)),
    Case('compare-shining', ['compare', '../shining.gltf', '--fps', '4',
                             '--size', '32x32', '--format', 'csv',
                             '--export', 'baked'], prints_the_same=False),
    Case('compare-mirror', ['compare', MIRROR, '--fps', '4', '--size', '32x32',
                            '--format', 'md', '--export', 'baked'],
         prints_the_same=False),
    Case('export-shining', ['export', '../shining.gltf', '--c', 'x.c'],
         files=('x.c',)),
    Case('character-shining', ['character', '../shining.gltf']),
    Case('doctor-other-character', ['doctor', WALKER, '--character', os.path.join(
        GOLDEN, 'characters', 'effects.character')], finds=True),
    Case('pose-printed', ['pose', BINARY, '-o', '/dev/stdout']),
    Case('pose-nowhere', ['pose', BINARY, '-o', '/dev/null']),
]


# A run of these takes more than a second, or fails at once.
LONG = re.compile('(optimize|compare)-(walker|arm|face|coarse)|bench|buttons|wrong')


def references():
    """The command lines of the reference texts and films."""
    lines = []
    for name, add in (('texts.txt', []),
                      ('films.txt', ['--size', '32x32', '-o', 'x.y4m'])):
        with open(os.path.join(GOLDEN, name), encoding='ascii') as file:
            for line in file:
                words = shlex.split(line, comments=True)
                if add:
                    words[1:1] = ['render']
                    words[0:1] = [f'film-{word}' for word in words[:1]]
                if len(words) > 1 and not LONG.match(words[0]):
                    lines.append(words + add)
    for number, (name, *arguments) in enumerate(lines, 1):
        arguments = [re.sub('^(assets|tests)/', TREE + r'/\1/', argument)
                     for argument in arguments]
        arguments = [re.sub('^OUT(/|$)', './', argument)
                     for argument in arguments]
        yield Case(f'{name}-{number}', arguments, statuses=(0, 1, 2),
                   prints_the_same=arguments[0] != 'compare',
                   finds=arguments[0] == 'doctor', reference=True,
                   may_do_without=('--camera pattern: ',))


CASES += references()
