"""Small object detectors and classifiers as ONNX files, written field by field, since Debian has no package of onnx for Python.

They report an object in each of 4 x 4 cells: of class `red` as certain as the cell is redder than green, of class
`green` the other way round. https://github.com/onnx/onnx/blob/main/onnx/onnx.proto has the numbers of the fields.
"""
import numpy as np

SIZE, CELLS = 64, 4
LABELS = ['red', 'green']
FLOAT, INT64 = 1, 7  # TensorProto.DataType
ATTRIBUTE_INTS = 7


def varint(number):
    out = b''
    while number > 127:
        out += bytes([number & 127 | 128])
        number >>= 7
    return out + bytes([number])


def field(number, value):
    if isinstance(value, int):
        return varint(number << 3) + varint(value)
    data = value.encode() if isinstance(value, str) else value
    return varint(number << 3 | 2) + varint(len(data)) + data


def tensor(name, array):
    array = np.asarray(array)
    kind = INT64 if array.dtype == np.int64 else FLOAT
    data = array.astype('<i8' if kind == INT64 else '<f4').tobytes()
    return b''.join(field(1, size) for size in array.shape) + field(2, kind) + field(8, name) + field(9, data)


def node(operation, inputs, output, **ints):
    attributes = b''.join(field(5, field(1, key) + b''.join(field(8, value) for value in values) + field(20, ATTRIBUTE_INTS))
                          for key, values in ints.items())
    return (b''.join(field(1, one) for one in inputs) + field(2, output) + field(3, output) + field(4, operation) +
            attributes)


def value(name, shape):
    sizes = b''.join(field(1, field(1, size)) for size in shape)
    return field(1, name) + field(2, field(1, field(1, FLOAT) + field(2, sizes)))


def model(nodes, tensors, outputs, images=(1, 3, SIZE, SIZE)):
    """@param outputs shapes by name"""
    graph = (b''.join(field(1, one) for one in nodes) + field(2, 'detector') + b''.join(field(5, one) for one in tensors) +
             field(11, value('images', images)) + b''.join(field(12, value(*one)) for one in outputs.items()))
    return field(1, 7) + field(8, field(1, '') + field(2, 11)) + field(7, graph)


def branch(name, weights, constants, shape):
    """Numbers of each cell: weighted red, green and blue, and a constant. @return nodes, tensors"""
    numbers = len(weights)
    kernel = np.asarray(weights, np.float32).reshape(numbers, 3, 1, 1)
    nodes = [node('Conv', ['cells', f'{name}_kernel'], f'{name}_seen', kernel_shape=[1, 1], strides=[1, 1]),
             node('Add', [f'{name}_seen', f'{name}_constants'], f'{name}_sum'),
             node('Reshape', [f'{name}_sum', f'{name}_shape'], name)]
    tensors = [tensor(f'{name}_kernel', kernel),
               tensor(f'{name}_constants', np.asarray(constants, np.float32).reshape(1, numbers, CELLS, CELLS)),
               tensor(f'{name}_shape', np.asarray(shape, np.int64))]
    return nodes, tensors


def detector(layout):
    """@param layout 'yolo_rows', 'yolo_columns' or 'ssd'"""
    step, count = SIZE // CELLS, CELLS * CELLS
    v, u = np.mgrid[:CELLS, :CELLS] * step + step / 2
    side = np.full((CELLS, CELLS), SIZE / 2)
    one, none = np.ones((CELLS, CELLS)), np.zeros((CELLS, CELLS))
    nothing, redder, greener = (0, 0, 0), (1, -1, 0), (-1, 1, 0)
    pool = node('AveragePool', ['images'], 'cells', kernel_shape=[step, step], strides=[step, step])
    if layout == 'ssd':
        corners = [(u - side / 2) / SIZE, (v - side / 2) / SIZE, (u + side / 2) / SIZE, (v + side / 2) / SIZE]
        scores = branch('score_columns', [nothing, redder, greener], [none, none, none], (1, 3, count))
        boxes = branch('box_columns', [nothing] * 4, corners, (1, 4, count))
        nodes = [pool, *scores[0], *boxes[0], node('Transpose', ['score_columns'], 'scores', perm=[0, 2, 1]),
                 node('Transpose', ['box_columns'], 'boxes', perm=[0, 2, 1])]
        return model(nodes, [*scores[1], *boxes[1]], {'scores': (1, count, 3), 'boxes': (1, count, 4)})
    rows = layout == 'yolo_rows'
    head = [u, v, side, side] + ([one] if rows else [])
    numbers = len(head) + 2
    nodes, tensors = branch('columns', [nothing] * len(head) + [redder, greener], [*head, none, none], (1, numbers, count))
    if not rows:
        return model([pool, *nodes], tensors, {'columns': (1, numbers, count)})
    nodes.append(node('Transpose', ['columns'], 'rows', perm=[0, 2, 1]))
    return model([pool, *nodes], tensors, {'rows': (1, count, numbers)})


def classifier(weights, planes=14, size=48):
    """A classifier of findings: each output is a weighted sum of the means of the planes.

    @param weights for each output, the weights by the number of the plane
    """
    kernel = np.zeros((len(weights), planes, 1, 1), np.float32)
    for output, of_planes in enumerate(weights):
        for plane, weight in of_planes.items():
            kernel[output, plane] = weight
    nodes = [node('AveragePool', ['images'], 'means', kernel_shape=[size, size], strides=[size, size]),
             node('Conv', ['means', 'kernel'], 'sums', kernel_shape=[1, 1], strides=[1, 1]),
             node('Reshape', ['sums', 'shape'], 'classes')]
    tensors = [tensor('kernel', kernel), tensor('shape', np.asarray((1, len(weights)), np.int64))]
    return model(nodes, tensors, {'classes': (1, len(weights))}, images=(1, planes, size, size))
