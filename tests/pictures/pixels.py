"""Pictures as means of blocks, and what is the same of two of them.

A block is 16 x 16 pixels of a full-size picture. Antialiasing, another version of the rasteriser or a line moved by a fraction of
a pixel change a block's mean by a few levels of 255; another colour map, a legend that is missing or a label in another place
change it by tens. A picture passes where no block differs by more than LIMIT and few differ by more than FAINT."""
import pathlib

from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkCommonDataModel import vtkImageData

REDUCED, BLOCK = 4, 4  # a baseline has every fourth pixel of a picture (means), a block every fourth of a baseline's
LIMIT, FAINT, FAINT_SHARE = 22, 8, 0.004  # levels of 255, and the share of blocks
LEVELS = 16  # of a baseline's colours: multiples of 256 / LEVELS are kept, so that it is small


class Picture:
    """Values 0 to 255, three a pixel, the lowest row first."""

    def __init__(self, width, height, values):
        self.width, self.height, self.values = width, height, values

    def at(self, x, y):
        start = 3 * (y * self.width + x)
        return self.values[start:start + 3]


def from_vtk(image):
    width, height, _ = image.GetDimensions()
    components = image.GetNumberOfScalarComponents()
    values = bytes(memoryview(image.GetPointData().GetScalars()))
    if components == 4:
        values = bytes(v for i, v in enumerate(values) if i % 4 != 3)
    assert len(values) == 3 * width * height, "no picture of three colours"
    return Picture(width, height, values)


def shrunk(image, factor):
    shrink = vtkImageShrink3D()
    shrink.SetInputData(image)
    shrink.SetShrinkFactors(factor, factor, 1)
    shrink.AveragingOn()
    shrink.Update()
    return shrink.GetOutput()


def read(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    if reader.GetErrorCode() or reader.GetOutput().GetNumberOfPoints() == 0:
        raise AssertionError(f"{path}: no PNG file")
    return reader.GetOutput()


def reduced(path):
    """A picture as a baseline has it."""
    return shrunk(read(path), REDUCED)


def to_vtk(picture):
    image = vtkImageData()
    image.SetDimensions(picture.width, picture.height, 1)
    image.AllocateScalars(3, 3)  # unsigned char
    memoryview(image.GetPointData().GetScalars()).cast("B")[:] = picture.values
    return image


def write_baseline(picture, path):
    """Colours are rounded to LEVELS levels a channel: blocks hardly notice, and the file is small."""
    step = 256 // LEVELS
    table = bytes(min(255, (value + step // 2) // step * step) for value in range(256))
    path.parent.mkdir(parents=True, exist_ok=True)
    writer = vtkPNGWriter()
    writer.SetInputData(to_vtk(Picture(picture.width, picture.height, picture.values.translate(table))))
    writer.SetCompressionLevel(9)
    writer.SetFileName(str(path))
    writer.Write()


def blocks(picture):
    return from_vtk(shrunk(to_vtk(picture), BLOCK))


def difference(baseline, picture):
    """What a reader would notice, as one line; nothing where the two show the same."""
    if (baseline.width, baseline.height) != (picture.width, picture.height):
        return f"its size is {picture.width} x {picture.height}, the baseline's {baseline.width} x {baseline.height} (both reduced)"
    one, two = blocks(baseline), blocks(picture)
    changes = [max(abs(a - b) for a, b in zip(one.values[i:i + 3], two.values[i:i + 3])) for i in range(0, len(one.values), 3)]
    worst = max(range(len(changes)), key=changes.__getitem__)
    faint = sum(change > FAINT for change in changes) / len(changes)
    if changes[worst] <= LIMIT and faint <= FAINT_SHARE:
        return None
    full = BLOCK * REDUCED
    x, y = worst % one.width * full, (one.height - 1 - worst // one.width) * full
    return (f"differs by up to {changes[worst]} of 255 (allowed {LIMIT}), most near pixel {x}, {y} from the upper left; "
            f"{100 * faint:.2f} % of it by more than {FAINT} (allowed {100 * FAINT_SHARE:.1f} %)")


def compare(path, baseline):
    """Compares a picture with its baseline; the complaint, or nothing."""
    picture = from_vtk(reduced(path))
    return difference(from_vtk(read(pathlib.Path(baseline))), picture)
