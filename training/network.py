"""The network of the classifier: convolutions over the planes of a finding."""
import torch
from torch import nn

from findings import LABELS, PLANES


def block(inputs, outputs, stride, width=3):
    return nn.Sequential(nn.Conv2d(inputs, outputs, width, stride=stride, padding=width // 2, bias=False),
                         nn.BatchNorm2d(outputs), nn.ReLU())


class Network(nn.Module):
    """14 x 48 x 48 planes to one output for each label and, last, one for anything else."""

    def __init__(self):
        super().__init__()
        self.features = nn.Sequential(block(PLANES, 32, 2, width=5), block(32, 64, 1), block(64, 96, 2),
                                      block(96, 128, 1), block(128, 160, 2), nn.AdaptiveAvgPool2d(1), nn.Flatten(),
                                      nn.Dropout(0.3))
        self.outputs = nn.Linear(160, len(LABELS) + 1)

    def forward(self, planes):
        return self.outputs(self.features(planes))


def export(network, file):
    """Writes the network as ONNX that OpenCV 4.6 reads."""
    network.eval()
    example = torch.zeros(1, PLANES, 48, 48)
    torch.onnx.export(network, example, str(file), opset_version=11, input_names=['planes'], output_names=['classes'],
                      do_constant_folding=True)
