"""Shapes of models: positions, normals, texture coordinates and indices each."""
import math


def cube():
    positions, normals, texcoords, indices = [], [], [], []
    for axis in range(3):
        for side in (-1, 1):
            first = len(positions)
            for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                position, normal = [0, 0, 0], [0, 0, 0]
                position[axis] = normal[axis] = side
                position[(axis + 1) % 3] = u * side
                position[(axis + 2) % 3] = v
                positions.append(position)
                normals.append(normal)
                texcoords.append(((u + 1) / 2, (1 - v) / 2))
            indices += [first + i for i in (0, 1, 2, 0, 2, 3)]
    return positions, normals, texcoords, indices


def squares_of(across, along):
    """Two triangles for each square of vertices in rows."""
    indices = []
    for j in range(along):
        for i in range(across):
            k = j * (across + 1) + i
            next_row = k + across + 1
            indices += [k, k + 1, next_row + 1, k, next_row + 1, next_row]
    return indices


def blob(around, down, size=1):
    """A sphere with dents."""
    positions, normals, texcoords = [], [], []
    for j in range(down + 1):
        for i in range(around + 1):
            a, b = 2 * math.pi * i / around, math.pi * j / down
            radius = size * (1 + 0.25 * math.sin(3 * a) * math.sin(2 * b))
            normal = (math.cos(a) * math.sin(b), math.cos(b), math.sin(a) * math.sin(b))
            normals.append(normal)
            positions.append([c * radius for c in normal])
            texcoords.append((i / around, j / down))
    return positions, normals, texcoords, squares_of(around, down)


def quad(width, height):
    positions = [(-width, -height, 0), (width, -height, 0), (width, height, 0), (-width, height, 0)]
    return positions, [(0, 0, 1)] * 4, [(0, 1), (1, 1), (1, 0), (0, 0)], [0, 1, 2, 0, 2, 3]


def strips(count):
    positions, normals, texcoords, indices = [], [], [], []
    for i in range(count + 1):
        for j in range(2):
            positions.append([i / count, 2 * j, 0.2 * math.sin(7 * i / count) - i / count])
            normals.append((0, 0, 1))
            texcoords.append((i / count, 1 - j))
    for k in range(0, 2 * count, 2):
        indices += [k, k + 2, k + 1, k + 1, k + 2, k + 3]
    return positions, normals, texcoords, indices


def rope(around, along):
    positions, normals, texcoords, indices = [], [], [], []
    for j in range(along + 1):
        for i in range(around + 1):
            a, y = 2 * math.pi * i / around, 12 * j / along
            normal = (math.cos(a), 0, math.sin(a))
            positions.append((0.4 * normal[0] + math.sin(y), 0.5 * y, 0.4 * normal[2]))
            normals.append(normal)
            texcoords.append((i / around, y))
    for j in range(along):
        for i in range(around):
            k = j * (around + 1) + i
            above = k + around + 1
            indices += [k, above, k + 1, k + 1, above, above + 1]
    return positions, normals, texcoords, indices


def tube(around, along):
    """An upright tube of radius 1, six units high."""
    positions, normals, texcoords = [], [], []
    for j in range(along + 1):
        for i in range(around + 1):
            a = 2 * math.pi * i / around
            normals.append((math.cos(a), 0, math.sin(a)))
            positions.append((math.cos(a), 6 - 6 * j / along, math.sin(a)))
            texcoords.append((i / around, j / along))
    return positions, normals, texcoords, squares_of(around, along)


def grid(squares, repeats):
    """Hilly ground that stands upright; texture coordinates go from -repeats / 2."""
    positions, normals, texcoords = [], [], []
    for j in range(squares + 1):
        for i in range(squares + 1):
            u, v = i / squares, j / squares
            positions.append((2 * u - 1, 2 * v - 1, 0.2 * math.sin(5 * u) * math.cos(4 * v)))
            normals.append((0, 0, 1))
            texcoords.append(((u - 0.5) * repeats, (0.5 - v) * repeats))
    return positions, normals, texcoords, squares_of(squares, squares)


def sized(shape, x, y, z):
    positions, *rest = shape
    return [(a * x, b * y, c * z) for a, b, c in positions], *rest
